// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/principal_axes.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace mahlwerk::geometry {

Matrix3 diagonalise(Matrix3& a) {
  Matrix3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int sweeps = 30;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}}) {
      if (std::abs(a[p][q]) <= 1e-15 * (std::abs(a[p][p]) + std::abs(a[q][q]))) continue;
      const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
      const double c = 1 / std::sqrt(t * t + 1), s = t * c;
      for (std::size_t k = 0; k < 3; ++k) {
        const double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double pk = a[p][k], qk = a[q][k], vp = axes[k][p], vq = axes[k][q];
        a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
        axes[k][p] = c * vp - s * vq, axes[k][q] = s * vp + c * vq;
      }
    }
  return axes;
}

}  // namespace mahlwerk::geometry

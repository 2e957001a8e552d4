// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::cases {

/// Box that holds the centres of balls, periodic along some axes.
struct Domain {
  Vec3 half;     ///< [m] half the sides of the box
  Vec3 periods;  ///< [m] infinite along an axis that is not periodic

  /// Minimum-image convention: vector from `a` to the nearest image of `b`.
  Vec3 minimum_image(const Vec3& a, const Vec3& b) const {
    const Vec3 d = b - a;
    return {nearest(d.x, periods.x), nearest(d.y, periods.y), nearest(d.z, periods.z)};
  }
  /// The image of `p` that lies in the box.
  Vec3 wrap(const Vec3& p) const { return minimum_image({}, p); }

  /// Index of `p` along a space-filling curve: Z-order (Morton code) of 1024 steps along each axis.
  std::uint64_t z_order_index(const Vec3& p) const {
    const auto spread = [](double x, double side) {
      std::uint64_t found = 0;
      const auto step = static_cast<std::uint64_t>(std::clamp((x / side + 1) * 512, 0.0, 1023.0));
      for (unsigned bit = 0; bit < 10; ++bit) found |= (step >> bit & 1U) << (3 * bit);
      return found;
    };
    return spread(p.x, half.x) | spread(p.y, half.y) << 1U | spread(p.z, half.z) << 2U;
  }

 private:
  static double nearest(double d, double period) {
    return std::abs(d) <= 0.5 * period ? d : d - period * std::round(d / period);
  }
};

/// Linked-cell grid for neighbour search. Cells are at least `reach` wide, and their number does
/// not much exceed `points`, the expected number of points.
class Grid {
 public:
  Grid(const Domain& domain, double reach, std::size_t points) : domain_(&domain) {
    const std::array<double, 3> half{domain.half.x, domain.half.y, domain.half.z};
    const std::array<double, 3> period{domain.periods.x, domain.periods.y, domain.periods.z};
    const double most =
        math::cbrt(8 * half[0] * half[1] * half[2] / static_cast<double>(points + 8));
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = -half[i];
      periodic_[i] = std::isfinite(period[i]);
      n_[i] = std::max(1, static_cast<int>(std::min(1024.0, 2 * half[i] / std::max(reach, most))));
      scale_[i] = half[i] > 0 ? n_[i] / (2 * half[i]) : 0.0;
    }
    first_.assign(static_cast<std::size_t>(n_[0]) * static_cast<std::size_t>(n_[1]) *
                      static_cast<std::size_t>(n_[2]),
                  none);
  }

  void add(int point, const Vec3& p) {
    const auto c = cell(p);
    const std::size_t at = index(c[0], c[1], c[2]);
    if (static_cast<std::size_t>(point) >= next_.size())
      next_.resize(static_cast<std::size_t>(point) + 1, none);
    next_[static_cast<std::size_t>(point)] = first_[at];
    first_[at] = point;
  }

  /// Calls `visit` for every point within `reach` of `p`, and some farther ones, until it returns
  /// false. Returns false if `visit` did.
  template <class Visit>
  bool for_each_near(const Vec3& p, Visit visit) const {
    const auto c = cell(p);
    std::array<std::array<int, 3>, 3> near{};
    std::array<int, 3> many{};
    for (std::size_t i = 0; i < 3; ++i) many[i] = neighbours(i, c[i], near[i]);
    for (int x = 0; x < many[0]; ++x)
      for (int y = 0; y < many[1]; ++y)
        for (int z = 0; z < many[2]; ++z)
          for (int at = first_[index(near[0][x], near[1][y], near[2][z])]; at != none;
               at = next_[static_cast<std::size_t>(at)])
            if (!visit(at)) return false;
    return true;
  }

 private:
  static constexpr int none = -1;

  std::array<int, 3> cell(const Vec3& place) const {
    const Vec3 p = domain_->wrap(place);
    const std::array<double, 3> x{p.x, p.y, p.z};
    std::array<int, 3> c{};
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = static_cast<int>(std::clamp((x[i] - low_[i]) * scale_[i], 0.0, n_[i] - 1.0));
    return c;
  }
  /// The cell `c` and its neighbours along axis `i`, each once; returns their number.
  int neighbours(std::size_t i, int c, std::array<int, 3>& near) const {
    int many = 0;
    for (int d = -1; d <= 1; ++d) {
      int at = c + d;
      if (periodic_[i]) at = (at + n_[i]) % n_[i];
      if (at < 0 || at >= n_[i]) continue;
      if (std::find(near.begin(), near.begin() + many, at) == near.begin() + many)
        near[static_cast<std::size_t>(many++)] = at;
    }
    return many;
  }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * static_cast<std::size_t>(n_[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(n_[2]) +
           static_cast<std::size_t>(z);
  }

  const Domain* domain_;
  std::array<double, 3> low_{}, scale_{};
  std::array<int, 3> n_{};
  std::array<bool, 3> periodic_{};
  std::vector<int> first_, next_;
};

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/principal_axes.hpp"

namespace mahlwerk::observe {

void Alignment::add(const Vec3& axis, double to_jar, double weight) {
  time_ += weight;
  squares_ += weight * Vec3{axis.x * axis.x, axis.y * axis.y, axis.z * axis.z};
  products_ += weight * Vec3{axis.x * axis.y, axis.y * axis.z, axis.z * axis.x};
  const double cosine = std::min(std::abs(to_jar), 1.0);
  angle_ += weight * math::atan2(std::sqrt(1 - cosine * cosine), cosine);
}

double Alignment::nematic_order() const {
  if (!(time_ > 0)) return std::numeric_limits<double>::quiet_NaN();
  const Vec3 &s = squares_, &p = products_;
  geometry::Matrix3 mean{{{s.x, p.x, p.z}, {p.x, s.y, p.y}, {p.z, p.y, s.z}}};
  geometry::diagonalise(mean);
  const double most = std::max({mean[0][0], mean[1][1], mean[2][2]}) / time_;
  return std::clamp(1.5 * most - 0.5, 0.0, 1.0);  // rounding
}

double Alignment::mean_angle() const {
  return time_ > 0 ? angle_ / time_ : std::numeric_limits<double>::quiet_NaN();
}

void Alignment::merge(const Alignment& other) {
  time_ += other.time_;
  squares_ += other.squares_;
  products_ += other.products_;
  angle_ += other.angle_;
}

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/lifter_cylinder.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::geometry {

Gap LifterCylinder::bar(int which, const Vec3& p, double within) const {
  const double reach = 0.5 * diameter - lifter_height - within;
  if (reach > 0 && p.x * p.x + p.y * p.y < reach * reach) return {not_near, {0, 0, 1}, 0};
  return section().gap(bars[static_cast<std::size_t>(which)], p, within);
}

/// The shell less the bars. The cross section of a bar is a trapezoid on the chord between its
/// feet, and the segment of the circle under the chord (geo.14).
double LifterCylinder::volume() const {
  const double r = 0.5 * diameter,
               slope = math::cos(lifter_face_angle) / math::sin(lifter_face_angle);
  // Where a side meets the shell: half_foot = width/2 - slope s, s = r - sqrt(r^2 - half_foot^2).
  double half_base = 0.5 * lifter_width;
  for (int i = 0; i < 60; ++i)
    half_base = 0.5 * lifter_width - slope * (r - std::sqrt(r * r - half_base * half_base));
  const double sagitta = r - std::sqrt(r * r - half_base * half_base);
  const double angle = 2 * math::asin(half_base / r);
  const double trapezoid = (half_base + half_top()) * (lifter_height - sagitta);
  const double segment = 0.5 * r * r * (angle - math::sin(angle));
  return shell().volume() - lifters * (trapezoid + segment) * height;
}

std::string LifterCylinder::flaw() const {
  const double r = 0.5 * diameter, half = 0.5 * lifter_width;
  if (lifters != std::floor(lifters)) return "lifters must be a whole number";
  if (lifter_height >= r) return "the lifters reach the middle of the jar";
  if (half >= r || lifters * math::asin(half / r) >= std::numbers::pi)
    return "the lifters are so wide that they cover the whole shell";
  if (half_top() <= 0)
    return "the sides of a lifter meet below its top: it is too high for its width and face angle";
  const double flat = half_top();
  if (lifter_height <= r - std::sqrt(r * r - flat * flat))
    return "the lifters are so low and wide that the shell bulges through their tops";
  if (lifters > 2 &&
      math::asin(std::min(1.0, flat / (r - lifter_height))) >= std::numbers::pi / lifters)
    return "the tops of neighbouring lifters run into each other";
  return "";
}

}  // namespace mahlwerk::geometry

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/lifter_cylinder.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::geometry {

/// Gap to a bar, in the plane across the axis. Coordinates: up towards the axis, and aside from the
/// middle of the bar. The bar is all that is below its top and between its sides (geo.13).
Gap LifterCylinder::bar(int which, const Vec3& p, double within) const {
  const double shell = 0.5 * diameter, reach = shell - lifter_height - within;
  if (reach > 0 && p.x * p.x + p.y * p.y < reach * reach) return {not_near, {0, 0, 1}, 0};
  const SinCos& at = bars[static_cast<std::size_t>(which)];
  const double out = at.cos * p.x + at.sin * p.y, along = at.cos * p.y - at.sin * p.x;
  const double aside = std::abs(along);
  // Relative to the edge between top and side.
  const double up = shell - out - lifter_height, off = aside - top;
  const double from_side = up * side.cos + off * side.sin;
  if (std::max(up, from_side) > within) return {not_near, {0, 0, 1}, 0};
  const double down_side = off * side.cos - up * side.sin;
  double distance = 0, n_up = 0, n_off = 0;
  if (off <= 0 && (up > 0 || up > from_side)) {
    distance = up, n_up = 1;
  } else if (off > 0 && down_side < 0) {
    distance = math::hypot(up, off), n_up = up / distance, n_off = off / distance;
  } else {
    distance = from_side, n_up = side.cos, n_off = side.sin;
  }
  if (along < 0) n_off = -n_off;
  const Vec3 inward{-n_up * at.cos - n_off * at.sin, -n_up * at.sin + n_off * at.cos, 0};
  return {distance, inward, 0};
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

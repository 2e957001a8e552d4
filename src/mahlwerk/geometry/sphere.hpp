// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include "mahlwerk/geometry/lane_gap.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

namespace mahlwerk::geometry {

/// A hollow sphere.
struct Sphere {
  double diameter = 0;  // [m]

  static constexpr std::string_view name = "sphere";
  static constexpr std::string_view about = "a hollow sphere";
  static constexpr int faces = 1;
  static constexpr bool axisymmetric = true;
  static constexpr std::string_view face_name(int) { return "wall"; }
  static constexpr auto fields() {
    return std::array{
        Field<Sphere>{"diameter", "m", &Sphere::diameter, positive, "inner diameter"}.with(
            diameter_of_jar("40 mm"))};
  }

  Gap gap(int, const Vec3& p) const {
    const double r = norm(p), big = 0.5 * diameter;
    return {big - r, r > 0 ? -p / r : Vec3{0, 0, 1}, 1 / big};
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V&, const Vec<V>& p) const {
    const V zero{}, r = sqrt(dot(p, p));
    return {0.5 * diameter - r, inward_from_core<V>(p, r, {zero, zero, zero + 1.0})};
  }
  Vec3 normal_rate(int, const Vec3& p, const Vec3& v) const { return rate_about_core(p, v); }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int, const SafeTimeQuery& c, double radius) const {
    const double room = 0.5 * diameter - radius, e2 = squared(c.position);
    const double along = dot(c.position, c.velocity);
    return {gap_within(room, e2), along,
            core_safe_time(room, e2, along, squared(c.velocity), c.max_acceleration.total)};
  }
  bool can_touch(int, double) const { return true; }
  double volume() const { return std::numbers::pi * diameter * diameter * diameter / 6; }
  double reach() const { return 0.5 * diameter; }
  double inradius() const { return 0.5 * diameter; }
  bool operator==(const Sphere&) const = default;
};

}  // namespace mahlwerk::geometry

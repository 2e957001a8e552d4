// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include "mahlwerk/geometry/lane_gap.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

namespace mahlwerk::geometry {

/// A cylinder closed by two half spheres: the vial of Chen et al. 2016. Its wall is the set of
/// points at one radius from the axis segment, so it is one C1 face (geo.3).
struct Capsule {
  double diameter = 0;  // [m]
  double height = 0;    // [m] of the cylinder, without the caps

  static constexpr std::string_view name = "capsule";
  static constexpr std::string_view about = "a cylinder closed by two half spheres";
  static constexpr int faces = 1;
  static constexpr bool axisymmetric = true;
  static constexpr std::string_view face_name(int) { return "wall"; }
  static constexpr auto fields() {
    return std::array{
        Field<Capsule>{"diameter", "m", &Capsule::diameter, positive, "inner diameter"}.with(
            diameter_of_jar("20 mm")),
        Field<Capsule>{"height", "m", &Capsule::height, not_negative,
                       "height of the cylindrical part, without the caps"}
            .with(height_of_jar("25 mm"))};
  }

  /// Vector from the nearest point of the axis segment (the core) to `p` [m].
  Vec3 from_core(const Vec3& p) const {
    const double h = 0.5 * height;
    return {p.x, p.y, p.z - std::clamp(p.z, -h, h)};
  }
  Gap gap(int, const Vec3& p) const {
    const Vec3 e = from_core(p);
    const double r = norm(e), big = 0.5 * diameter;
    return {big - r, r > 0 ? -e / r : Vec3{1, 0, 0}, 1 / big};
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V&, const Vec<V>& p) const {
    const V zero{}, one = zero + 1.0, h = zero + 0.5 * height;
    const Vec<V> e{p.x, p.y, p.z - select<V>(less(p.z, -h), -h, select<V>(less(h, p.z), h, p.z))};
    const V r = sqrt(dot(e, e));
    return {0.5 * diameter - r, inward_from_core<V>(e, r, {one, zero, zero})};
  }
  Vec3 normal_rate(int, const Vec3& p, const Vec3& v) const {
    const Vec3 e = from_core(p);
    return rate_about_core(e, e.z == 0 ? Vec3{v.x, v.y, 0} : v);  // no curvature along the cylinder
  }
  double time_to_curvature_jump(int, const Vec3& p, const Vec3& v) const {
    return until_crossing(0.5 * height, p.z, v.z);
  }
  SafeTime safe_time(int, const SafeTimeQuery& c, double radius) const {
    const double room = 0.5 * diameter - radius;
    const Vec3 e = from_core(c.position);
    const double e2 = squared(e), along = dot(e, c.velocity), speed2 = squared(c.velocity);
    const double gap = gap_within(room, e2);
    // Between the caps only the motion across the axis counts, until a cap is reached (geo.6).
    if (e.z == 0) {
      const double vz = c.velocity.z, across2 = std::max(speed2 - vz * vz, 0.0);
      const double side = core_safe_time(room, e2, along, across2, c.max_acceleration.across_axis);
      if (stays_between_caps(c, side)) return {gap, along, side};
      const double ball = core_safe_time(room, e2, along, speed2, c.max_acceleration.total);
      return {gap, along, std::max(ball, std::min(side, until_cap(c)))};
    }
    // The sphere of radius `room` about the nearest core point lies inside: safe until then.
    return {gap, along, core_safe_time(room, e2, along, speed2, c.max_acceleration.total)};
  }
  bool can_touch(int, double) const { return true; }
  double volume() const {
    return std::numbers::pi * diameter * diameter * (0.25 * height + diameter / 6);
  }
  double reach() const { return 0.5 * (diameter + height); }
  double inradius() const { return 0.5 * diameter; }
  bool operator==(const Capsule&) const = default;

 private:
  bool stays_between_caps(const SafeTimeQuery& c, double time) const {
    const double ahead = c.position.z + c.velocity.z * time;
    return std::abs(ahead) + 0.5 * c.max_acceleration.components.z * time * time <= 0.5 * height;
  }
  double until_cap(const SafeTimeQuery& c) const {
    const double h = 0.5 * height, z = c.position.z, vz = c.velocity.z;
    return std::min(plane_safe_time(h - z, vz, c.max_acceleration.components.z),
                    plane_safe_time(h + z, -vz, c.max_acceleration.components.z));
  }
};

}  // namespace mahlwerk::geometry

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/lane_gap.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

namespace mahlwerk::geometry {

/// A cylinder with flat ends. Side and ends meet in edges, so they are three faces.
struct Cylinder {
  double diameter = 0;  // [m]
  double height = 0;    // [m]

  static constexpr std::string_view name = "cylinder";
  static constexpr std::string_view about = "a cylinder with flat ends";
  static constexpr int faces = 3;
  static constexpr bool axisymmetric = true;
  static constexpr std::string_view face_name(int face) {
    return face == 0 ? "side" : face == 1 ? "bottom" : "top";
  }
  static constexpr auto fields() {
    return std::array{
        Field<Cylinder>{"diameter", "m", &Cylinder::diameter, positive, "inner diameter"}.with(
            diameter_of_jar("50 mm")),
        Field<Cylinder>{"height", "m", &Cylinder::height, positive, "inner height"}.with(
            height_of_jar("50 mm"))};
  }

  Gap gap(int face, const Vec3& p) const {
    if (face != 0) {
      const double up = face == 1 ? 1 : -1;
      return {0.5 * height + up * p.z, {0, 0, up}, 0};
    }
    const double r = std::sqrt(p.x * p.x + p.y * p.y), big = 0.5 * diameter;
    return {big - r, r > 0 ? Vec3{-p.x / r, -p.y / r, 0} : Vec3{1, 0, 0}, 1 / big};
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V& face, const Vec<V>& p) const {
    const V zero{}, one = zero + 1.0, r = sqrt(p.x * p.x + p.y * p.y);
    const V up = select<V>(less(face, zero + 1.5), one, -one);
    const MaskOf<V> side = less(face, zero + 0.5);
    const Vec<V> from_side = inward_from_core<V>({p.x, p.y, zero}, r, {one, zero, zero});
    return {select<V>(side, 0.5 * diameter - r, 0.5 * height + up * p.z),
            select<V>(side, {from_side.x, from_side.y, zero}, {zero, zero, up})};
  }
  Vec3 normal_rate(int face, const Vec3& p, const Vec3& v) const {
    if (face != 0) return {};
    return rate_about_core({p.x, p.y, 0}, {v.x, v.y, 0});
  }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    const Vec3 &p = c.position, &v = c.velocity;
    if (face != 0) {
      const double up = face == 1 ? 1 : -1;
      const double gap = 0.5 * height + up * p.z - radius;
      return {gap, -up * v.z, plane_safe_time(gap, -up * v.z, c.max_acceleration.components.z)};
    }
    const double room = 0.5 * diameter - radius;
    const double e2 = p.x * p.x + p.y * p.y, along = p.x * v.x + p.y * v.y;
    return {gap_within(room, e2), along,
            core_safe_time(room, e2, along, v.x * v.x + v.y * v.y, c.max_acceleration.across_axis)};
  }
  bool can_touch(int, double) const { return true; }
  double volume() const { return 0.25 * std::numbers::pi * diameter * diameter * height; }
  double reach() const { return 0.5 * math::hypot(diameter, height); }
  double inradius() const { return 0.5 * std::min(diameter, height); }
  bool operator==(const Cylinder&) const = default;
};

}  // namespace mahlwerk::geometry

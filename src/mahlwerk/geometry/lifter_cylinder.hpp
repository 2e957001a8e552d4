// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/surface.hpp"

namespace mahlwerk::geometry {

/// The cross section of a bar of a drum. A bar is all that is below its top and between its sides.
struct BarSection {
  double shell_radius = 0, height = 0;  // [m] of the drum; of the bar above its shell
  double top = 0;                       // [m] half the width of its flat top
  SinCos side{0, 1};                    // of the angle of its sides

  /// Gap to a bar at the angle `at` about the axis (geo.13). Coordinates: up towards the axis, and
  /// aside from the middle of the bar.
  Gap gap(const SinCos& at, const Vec3& p, double within) const {
    const double out = at.cos * p.x + at.sin * p.y, along = at.cos * p.y - at.sin * p.x;
    // Relative to the edge between top and side.
    const double up = shell_radius - out - height, off = std::abs(along) - top;
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
    return {distance, {-n_up * at.cos - n_off * at.sin, -n_up * at.sin + n_off * at.cos, 0}, 0};
  }
};

/// [rad] about the axis, of bar `i`.
constexpr double bar_angle(int i, double bars) {
  return 2 * std::numbers::pi * i / bars;
}

/// A cylinder with flat ends and equal bars along its shell: a drum with lifters, or with a liner
/// of many low bars. Each bar is a face; it is convex, so a ball touches it at one point (geo.13).
struct LifterCylinder {
  double diameter = 0, height = 0;             // [m]
  double lifters = 0;                          // number of bars
  double lifter_height = 0, lifter_width = 0;  // [m] above the shell; at the foot
  double lifter_face_angle = 0;                // [rad] between its sides and its foot
  int faces = 3;
  double top = 0;            // [m] half the width of a bar's flat top
  SinCos side{0, 1};         // of the angle of its sides
  std::vector<SinCos> bars;  // of the angle of each about the axis

  static constexpr std::string_view name = "lifter-cylinder";
  static constexpr std::string_view about = "a cylinder with lifter bars along its shell";
  static constexpr bool axisymmetric = false;
  static std::string face_name(int face) {
    return face < 3 ? std::string(Cylinder::face_name(face)) : "lifter" + std::to_string(face - 2);
  }
  static constexpr auto fields() {
    using L = LifterCylinder;
    constexpr double right = 0.5 * std::numbers::pi;
    return std::array{
        Field<L>{"diameter", "m", &L::diameter, positive, "inner diameter of the shell"}.with(
            diameter_of_jar("200 mm")),
        Field<L>{"height", "m", &L::height, positive, "inner height"}.with(height_of_jar("100 mm")),
        Field<L>{"lifters",
                 "",
                 &L::lifters,
                 {.least = 1, .most = 1000},
                 "how many bars, evenly round the shell"}
            .with({.start = "8"}),
        Field<L>{"lifter_height", "m", &L::lifter_height, positive,
                 "how far a bar stands out from the shell, at its middle"}
            .with({.start = "10 mm"}),
        Field<L>{"lifter_width", "m", &L::lifter_width, positive, "width of a bar at its foot"}
            .with({.start = "15 mm"}),
        Field<L>{"lifter_face_angle",
                 "rad",
                 &L::lifter_face_angle,
                 {.least = right / 9, .most = right},
                 "between the sides of a bar and its foot",
                 right,
                 "90 deg: rectangular bars"}};
  }
  /// Computes the members that follow from the fields.
  void complete() {
    faces = 3 + static_cast<int>(lifters);
    top = half_top();
    side = sin_cos(lifter_face_angle);
    bars.clear();
    for (int i = 0; i < faces - 3; ++i) bars.push_back(sin_cos(bar_angle(i, lifters)));
  }
  /// Why the jar is impossible; empty if it is valid.
  std::string flaw() const;

  Gap gap(int face, const Vec3& p) const { return gap(face, p, never); }
  Gap gap(int face, const Vec3& p, double within) const {
    return face < 3 ? shell().gap(face, p) : bar(face - 3, p, within);
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V& face, const Vec<V>& p) const {
    const LaneGap<V> at_shell = shell().gaps(face, p);
    const MaskOf<V> of_bar = less(V{} + 2.5, face);
    if (!any(of_bar)) return at_shell;
    const LaneGap<V> at_bar = bar_gaps(face, p);
    return {select<V>(of_bar, at_bar.distance, at_shell.distance),
            select<V>(of_bar, at_bar.inward, at_shell.inward)};
  }
  Vec3 normal_rate(int face, const Vec3& p, const Vec3& v) const {
    return face < 3 ? shell().normal_rate(face, p, v) : Vec3{};  // bars are flat
  }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    if (face < 3) return shell().safe_time(face, c, radius);
    const double gap = bar(face - 3, c.position, never).distance - radius, speed = norm(c.velocity);
    return {gap, speed, plane_safe_time(gap, speed, c.max_acceleration.total)};
  }
  bool can_touch(int, double) const { return true; }
  double volume() const;
  double reach() const { return shell().reach(); }
  double inradius() const { return 0.5 * std::min(diameter - 2 * lifter_height, height); }
  Vec3 middle() const { return {}; }
  Extent extent() const {
    const Vec3 half{0.5 * diameter, 0.5 * diameter, 0.5 * height};
    return {-half, half};
  }
  Cylinder shell() const { return {diameter, height}; }
  BarSection section() const { return {0.5 * diameter, lifter_height, top, side}; }
  bool operator==(const LifterCylinder&) const = default;

 private:
  double half_top() const {
    return 0.5 * lifter_width -
           lifter_height * math::cos(lifter_face_angle) / math::sin(lifter_face_angle);
  }
  Gap bar(int which, const Vec3& p, double within) const;
  /// bar() in registers; lanes of other faces have any numbers.
  template <class V>
  [[gnu::always_inline]] LaneGap<V> bar_gaps(const V& face, const Vec<V>& p) const {
    const auto of_face = [&](double SinCos::*part) __attribute__((always_inline)) {
      return lanes_from<V>([&](int l) __attribute__((always_inline)) {
        return bars[static_cast<std::size_t>(std::max(face[l] - 3, 0.0))].*part;
      });
    };
    const V zero{}, cos = of_face(&SinCos::cos), sin = of_face(&SinCos::sin);
    const V out = cos * p.x + sin * p.y, along = cos * p.y - sin * p.x;
    const V up = 0.5 * diameter - out - lifter_height, off = abs(along) - top;
    const V from_side = up * side.cos + off * side.sin, down_side = off * side.cos - up * side.sin;
    const V from_edge = sqrt(up * up + off * off);
    const MaskOf<V> beside = less(zero, off);
    const MaskOf<V> above = ~beside & (less(zero, up) | less(from_side, up));
    const MaskOf<V> at_edge = beside & less(down_side, zero);
    const auto choose = [&](const V& a, const V& e, const V& s) __attribute__((always_inline)) {
      return select<V>(above, a, select<V>(at_edge, e, s));
    };
    const V n_up = choose(zero + 1.0, up / from_edge, zero + side.cos);
    V n_off = choose(zero, off / from_edge, zero + side.sin);
    n_off = select<V>(less(along, zero), -n_off, n_off);
    return {choose(up, from_edge, from_side),
            {-n_up * cos - n_off * sin, -n_up * sin + n_off * cos, zero}};
  }
};

}  // namespace mahlwerk::geometry

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/geometry/cylinder.hpp"

namespace mahlwerk::geometry {

/// A piece of an infinitely long cylinder, without ends: periodic along its axis (geo.17). For a
/// long drum whose ends do not matter. Soft engine only.
struct PeriodicCylinder {
  double diameter = 0;  // [m]
  double length = 0;    // [m] period along the axis

  static constexpr std::string_view name = "periodic-cylinder";
  static constexpr std::string_view about =
      "a cylinder without ends, periodic along its axis: a piece of a long drum";
  static constexpr int faces = 1;
  static constexpr bool axisymmetric = true;
  static constexpr std::string_view face_name(int) { return "side"; }
  static constexpr auto fields() {
    using P = PeriodicCylinder;
    return std::array{Field<P>{"diameter", "m", &P::diameter, positive, "inner diameter"}.with(
                          diameter_of_jar("200 mm")),
                      Field<P>{"length", "m", &P::length, positive, "period along the axis"}.with(
                          {.start = "100 mm"})};
  }
  void complete() {}

  Vec3 periods() const { return {never, never, length}; }
  Gap gap(int, const Vec3& p) const { return side().gap(0, p); }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V& face, const Vec<V>& p) const {
    return side().gaps(face, p);
  }
  Vec3 normal_rate(int, const Vec3& p, const Vec3& v) const { return side().normal_rate(0, p, v); }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int, const SafeTimeQuery& c, double radius) const {
    return side().safe_time(0, c, radius);
  }
  bool can_touch(int, double) const { return true; }
  double volume() const { return side().volume(); }
  double reach() const { return side().reach(); }
  double inradius() const { return 0.5 * diameter; }
  bool operator==(const PeriodicCylinder&) const = default;

 private:
  Cylinder side() const { return {diameter, length}; }
};

}  // namespace mahlwerk::geometry

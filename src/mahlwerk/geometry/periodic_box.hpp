// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "mahlwerk/geometry/shape.hpp"

namespace mahlwerk::geometry {

/// A box without walls, with periodic boundaries: a ball that leaves through one side enters
/// through the opposite one (geo.8). For the physics of collisions alone, without a mill.
struct PeriodicBox {
  double width = 0, depth = 0, height = 0;  // [m] along x, y, z

  static constexpr std::string_view name = "periodic-box";
  static constexpr std::string_view about =
      "a box without walls: what leaves by one side comes in by the opposite one";
  static constexpr int faces = 0;
  static constexpr bool axisymmetric = false;
  static constexpr std::string_view face_name(int) { return "none"; }
  static constexpr auto fields() {
    using P = PeriodicBox;
    return std::array{
        Field<P>{"width", "m", &P::width, positive, "period along x"}.with({.start = "50 mm"}),
        Field<P>{"depth", "m", &P::depth, positive, "period along y"}.with({.start = "50 mm"}),
        Field<P>{"height", "m", &P::height, positive, "period along z"}.with(
            height_of_jar("50 mm"))};
  }

  Vec3 periods() const { return {width, depth, height}; }
  Gap gap(int, const Vec3&) const { return {never, {0, 0, 1}, 0}; }
  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int, const SafeTimeQuery&, double) const { return {never, 0, never}; }
  bool can_touch(int, double) const { return false; }
  double volume() const { return width * depth * height; }
  double reach() const { return 0.5 * norm(periods()); }
  double inradius() const { return 0.5 * std::min({width, depth, height}); }
  bool operator==(const PeriodicBox&) const = default;
};

}  // namespace mahlwerk::geometry

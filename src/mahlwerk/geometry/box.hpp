// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "mahlwerk/geometry/lane_gap.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

namespace mahlwerk::geometry {

/// A box with sharp edges: six planes, of which a ball in a corner touches three (geo.7).
struct Box {
  double width = 0;   // [m] along x
  double depth = 0;   // [m] along y
  double height = 0;  // [m] along z

  static constexpr std::string_view name = "box";
  static constexpr std::string_view about = "a box with sharp edges";
  static constexpr int faces = 6;
  static constexpr bool axisymmetric = false;
  static constexpr std::string_view face_name(int face) {
    constexpr std::array<std::string_view, faces> names{"left", "right",  "front",
                                                        "back", "bottom", "top"};
    return names[static_cast<std::size_t>(face)];
  }
  static constexpr auto fields() {
    return std::array{
        Field<Box>{"width", "m", &Box::width, positive, "inner width, along the jar's own x"}.with(
            {.start = "50 mm"}),
        Field<Box>{"depth", "m", &Box::depth, positive, "inner depth, along the jar's own y"}.with(
            {.start = "50 mm"}),
        Field<Box>{"height", "m", &Box::height, positive, "inner height, along the jar's axis"}
            .with(height_of_jar("50 mm"))};
  }

  Gap gap(int face, const Vec3& p) const {
    const Vec3 inward = into(face);
    return {half(face) + dot(p, inward), inward, 0};
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V& face, const Vec<V>& p) const {
    const V zero{}, one = zero + 1.0;
    const auto below = [&](double limit) { return less(face, zero + limit); };
    const MaskOf<V> x = below(1.5), y = ~x & below(3.5), z = ~(x | y);
    const V up = select<V>(below(0.5) | (y & below(2.5)) | (z & below(4.5)), one, -one);
    const Vec<V> inward{where<V>(x, up), where<V>(y, up), where<V>(z, up)};
    const V half = 0.5 * select<V>(x, zero + width, select<V>(y, zero + depth, zero + height));
    return {half + dot(p, inward), inward};
  }
  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    const double up = face % 2 == 0 ? 1 : -1;
    const double gap = half(face) + up * part(face, c.position) - radius;
    const double closing = -up * part(face, c.velocity);
    return {gap, closing, plane_safe_time(gap, closing, part(face, c.max_acceleration.components))};
  }
  bool can_touch(int, double) const { return true; }
  double radius_about_axis() const { return 0.5 * std::min(width, depth); }
  double volume() const { return width * depth * height; }
  double reach() const { return 0.5 * norm(Vec3{width, depth, height}); }
  double inradius() const { return 0.5 * std::min({width, depth, height}); }
  bool operator==(const Box&) const = default;

 private:
  /// The component of `a` normal to `face`.
  static double part(int face, const Vec3& a) { return face < 2 ? a.x : face < 4 ? a.y : a.z; }
  static Vec3 into(int face) {
    const double up = face % 2 == 0 ? 1 : -1;
    return face < 2 ? Vec3{up, 0, 0} : face < 4 ? Vec3{0, up, 0} : Vec3{0, 0, up};
  }
  double half(int face) const { return 0.5 * part(face, {width, depth, height}); }
};

}  // namespace mahlwerk::geometry

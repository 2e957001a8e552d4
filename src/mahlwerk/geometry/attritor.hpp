// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/surface.hpp"

namespace mahlwerk::geometry {

/// A vessel with a stirrer: a shaft from above along the axis with arms through it, one above the
/// other, each at right angles to the one below. The stirrer rotates relative to the vessel. Shaft
/// and arms are convex, and each is a face, so a ball touches each at one point (geo.15).
struct Attritor {
  double diameter = 0, height = 0;                 // [m] of the vessel
  double shaft_diameter = 0, shaft_clearance = 0;  // [m] diameter; between its end and the bottom
  double arms = 0;                                 // number of arms
  double arm_diameter = 0, arm_span = 0;           // [m] diameter; from tip to tip
  double arm_clearance = 0, arm_spacing = 0;       // [m] lowest axis to bottom; between axes
  double rotor_speed = 0;                          // [rad/s] about z
  int faces = 4;

  static constexpr std::string_view name = "attritor";
  static constexpr std::string_view about = "a vessel with a stirrer: a shaft with arms that turns";
  static constexpr bool axisymmetric = false;
  static constexpr int first_rotor_face = 3;  // this face and those after it belong to the stirrer
  static std::string face_name(int face) {
    if (face < 3) return std::string(Cylinder::face_name(face));
    return face == 3 ? "shaft" : "arm" + std::to_string(face - 3);
  }
  static constexpr auto fields() {
    using A = Attritor;
    return std::array{
        Field<A>{"diameter", "m", &A::diameter, positive, "inner diameter of the vessel"}.with(
            diameter_of_jar("100 mm")),
        Field<A>{"height", "m", &A::height, positive, "inner height of the vessel"}.with(
            height_of_jar("120 mm")),
        Field<A>{"shaft_diameter", "m", &A::shaft_diameter, positive, "diameter of the shaft"}.with(
            {.start = "20 mm"}),
        Field<A>{"shaft_clearance", "m", &A::shaft_clearance, not_negative,
                 "between the shaft's end and the bottom"}
            .with({.start = "10 mm"}),
        Field<A>{"arms",
                 "",
                 &A::arms,
                 {.least = 1, .most = 1000},
                 "how many bars go through the shaft, each square to the one below"}
            .with({.start = "4"}),
        Field<A>{"arm_diameter", "m", &A::arm_diameter, positive,
                 "diameter of an arm, round at its tips"}
            .with({.start = "8 mm"}),
        Field<A>{"arm_span", "m", &A::arm_span, positive, "from tip to tip of an arm"}.with(
            {.start = "80 mm"}),
        Field<A>{"arm_clearance", "m", &A::arm_clearance, positive,
                 "between the bottom and the axis of the lowest arm"}
            .with({.start = "20 mm"}),
        Field<A>{"arm_spacing", "m", &A::arm_spacing, positive, "between the axes of two arms"}
            .with({.start = "20 mm"}),
        Field<A>{"rotor_speed", "rad/s", &A::rotor_speed, any_number,
                 "of the stirrer about the vessel's axis, relative to the vessel"}
            .with({.start = "300 rpm"})};
  }
  void complete() { faces = 4 + static_cast<int>(arms); }
  std::string flaw() const;

  /// For the stirrer's faces at its initial angle, with the first arm along x.
  Gap gap(int face, const Vec3& p) const {
    if (face < first_rotor_face) return vessel().gap(face, p);
    if (face == first_rotor_face) return from_shaft(p + Vec3{0, 0, 0.5 * height - shaft_clearance});
    const Vec3 e = from_core(face, p);
    const double far = norm(e), radius = 0.5 * arm_diameter;
    return {far - radius, far > 0 ? e / far : Vec3{0, 0, 1}, -1 / radius};
  }
  Vec3 normal_rate(int face, const Vec3& p, const Vec3& v) const;
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    if (face < first_rotor_face) return vessel().safe_time(face, c, radius);
    const double gap = this->gap(face, c.position).distance - radius, speed = norm(c.velocity);
    return {gap, speed, plane_safe_time(gap, speed, c.max_acceleration.total)};
  }
  bool can_touch(int, double) const { return true; }
  double volume() const;
  double reach() const { return vessel().reach(); }
  double inradius() const { return largest_ball().second; }
  Vec3 middle() const { return largest_ball().first; }
  Extent extent() const {
    const Vec3 half{0.5 * diameter, 0.5 * diameter, 0.5 * height};
    return {-half, half};
  }
  /// Largest distance of the stirrer from the axis [m].
  double rotor_reach() const { return 0.5 * std::max(arm_span, shaft_diameter); }
  bool operator==(const Attritor&) const = default;

 private:
  Cylinder vessel() const { return {diameter, height}; }
  /// Gap to the shaft: a solid cylinder about z with a flat end at z = 0, without end upwards.
  Gap from_shaft(const Vec3& p) const {
    const double radius = 0.5 * shaft_diameter;
    const double r = math::hypot(p.x, p.y), out = r - radius, below = -p.z;
    const Vec3 side = r > 0 ? Vec3{p.x / r, p.y / r, 0} : Vec3{1, 0, 0};
    if (out > 0 && below > 0) {
      const double far = math::hypot(out, below);
      return {far, out / far * side - Vec3{0, 0, below / far}, 0};
    }
    if (below > out) return {below, {0, 0, -1}, 0};
    return {out, side, -1 / radius};
  }
  /// Vector from the nearest point of an arm's axis to `p` [m].
  Vec3 from_core(int face, const Vec3& p) const {
    const int arm = face - first_rotor_face - 1;
    const double half = 0.5 * (arm_span - arm_diameter);
    const double z = p.z + 0.5 * height - arm_clearance - arm * arm_spacing;
    return arm % 2 == 0 ? Vec3{p.x - std::clamp(p.x, -half, half), p.y, z}
                        : Vec3{p.x, p.y - std::clamp(p.y, -half, half), z};
  }
  std::pair<Vec3, double> largest_ball() const;
};

}  // namespace mahlwerk::geometry

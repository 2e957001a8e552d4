// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/cylinder.hpp"

namespace mahlwerk::geometry {

/// A cylinder whose ends meet its side in a fillet, as in most milling jars. A ball smaller than
/// the fillet touches one C1 wall, the points at the distance `fillet` from the flat core. A larger
/// ball never reaches the fillet and touches side and ends as in a plain cylinder (geo.3).
struct RoundedCylinder {
  double diameter = 0;  // [m]
  double height = 0;    // [m]
  double fillet = 0;    // [m]

  static constexpr std::string_view name = "rounded-cylinder";
  static constexpr std::string_view about = "a cylinder whose ends meet its side in a fillet";
  static constexpr int faces = 4;
  static constexpr bool axisymmetric = true;
  static constexpr std::string_view face_name(int face) {
    return face == 3 ? "wall" : Cylinder::face_name(face);
  }
  static constexpr auto fields() {
    using R = RoundedCylinder;
    return std::array{
        Field<R>{"diameter", "m", &R::diameter, positive, "inner diameter"}.with(
            diameter_of_jar("50 mm")),
        Field<R>{"height", "m", &R::height, positive, "inner height"}.with(height_of_jar("50 mm")),
        Field<R>{"fillet", "m", &R::fillet, positive,
                 "radius of the fillet between side and ends, at most half the diameter and height"}
            .with({.start = "8 mm"})};
  }

  Gap gap(int face, const Vec3& p) const {
    if (face != 3) return plain().gap(face, p);
    const Vec3 e = from_core(p);
    const double r = norm(e);
    if (r > 0) return {fillet - r, -e / r, 1 / fillet};
    return plain().gap(nearest_plain_face(p), p);
  }
  Vec3 normal_rate(int face, const Vec3& p, const Vec3& v) const {
    const Vec3 e = from_core(p);
    if (face != 3) return plain().normal_rate(face, p, v);
    if (squared(e) == 0) return plain().normal_rate(nearest_plain_face(p), p, v);
    const double rho = math::hypot(p.x, p.y);
    if (rho == 0) return {};
    // e = over(rho) out + z part; its rate without the motion of the nearest core point around it.
    const Vec3 out{p.x / rho, p.y / rho, 0}, around{-out.y, out.x, 0};
    const double over = dot(e, out);
    const Vec3 u{over > 0 ? dot(v, out) * out.x : 0, over > 0 ? dot(v, out) * out.y : 0,
                 e.z != 0 ? v.z : 0};
    const double swept = over * dot(v, around) / rho;  // the normal turns with the azimuth
    return rate_about_core(e, u + swept * around);
  }
  double time_to_curvature_jump(int face, const Vec3& p, const Vec3& v) const {
    if (face != 3) return never;
    const double rho = math::hypot(p.x, p.y), out = (p.x * v.x + p.y * v.y) / (rho > 0 ? rho : 1);
    return std::min(until_crossing(0.5 * height - fillet, p.z, v.z),
                    until_crossing(0.5 * diameter - fillet, rho, out));
  }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    if (face != 3) return plain().safe_time(face, c, radius);
    const Vec3 e = from_core(c.position);
    const double room = fillet - radius, e2 = squared(e),
                 max_acceleration = c.max_acceleration.total;
    if (e2 > 0) {
      const double along = dot(e, c.velocity);
      return {gap_within(room, e2), along,
              core_safe_time(room, e2, along, squared(c.velocity), max_acceleration)};
    }
    const double gap = std::min(0.5 * diameter - math::hypot(c.position.x, c.position.y),
                                0.5 * height - std::abs(c.position.z)) -
                       radius;
    const double speed = norm(c.velocity);
    return {gap, speed, plane_safe_time(gap, speed, max_acceleration)};
  }
  bool can_touch(int face, double radius) const { return (face == 3) == (radius < fillet); }
  double volume() const {
    // Pappus: at both ends a square of side `fillet` less its quarter disc, rotated about the axis.
    const double big = 0.5 * diameter, f = fillet, pi = std::numbers::pi;
    const double quarter = 0.25 * pi * f * f, quarter_arm = big - f + 4 * f / (3 * pi);
    const double lost = 2 * pi * (f * f * (big - 0.5 * f) - quarter * quarter_arm);
    return plain().volume() - 2 * lost;
  }
  double reach() const {
    return math::hypot(0.5 * diameter - fillet, 0.5 * height - fillet) + fillet;
  }
  double inradius() const { return plain().inradius(); }
  bool operator==(const RoundedCylinder&) const = default;

 private:
  Cylinder plain() const { return {diameter, height}; }
  int nearest_plain_face(const Vec3& p) const {
    const int end = p.z < 0 ? 1 : 2;
    return plain().gap(0, p).distance < plain().gap(end, p).distance ? 0 : end;
  }
  /// Vector [m] to `p` from the nearest point of the core, a cylinder one fillet inside the wall.
  Vec3 from_core(const Vec3& p) const {
    const double rho = math::hypot(p.x, p.y), over = rho - (0.5 * diameter - fillet);
    const double h = 0.5 * height - fillet;
    const double share = over > 0 ? over / rho : 0;
    return {share * p.x, share * p.y, p.z - std::clamp(p.z, -h, h)};
  }
};

}  // namespace mahlwerk::geometry

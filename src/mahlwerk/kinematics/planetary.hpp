// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A rotating jar on a rotating disc, both axes vertical (physics of Mhadhbi 2021) (kin.3).
struct Planetary {
  double orbit_radius = 0;  // [m]
  double speed = 0;         // [rad/s] of the disc
  double ratio = 0;         // jar speed relative to the disc over disc speed; "1:-2" is -2

  static constexpr std::string_view name = "planetary";
  static constexpr std::string_view about =
      "a jar that turns about its own axis on a disc that turns about a parallel one";
  static constexpr Vec3 jar_axis = upright;
  static constexpr auto fields() {
    using P = Planetary;
    return std::array{
        Field<P>{"orbit_radius", "m", &P::orbit_radius, positive,
                 "distance between the axes of disc and jar"}
            .plausible_within("", "2 m")
            .with({.start = "100 mm", .usual = {"20 mm", "300 mm"}}),
        Field<P>{"speed", "rad/s", &P::speed, not_zero,
                 "speed of the disc; a negative one turns the mill the other way"}
            .plausible_within("", "5000 rpm")
            .with(speed_of_mill("300 rpm")),
        Field<P>{"ratio", "", &P::ratio, any_number,
                 "jar speed over disc speed, relative to the disc unless "
                 "ratio_convention says otherwise; \"1:-2\" is -2"}
            .plausible_within("", "20")
            .with(
                {.label = "speed ratio", .symbol = "$k$", .start = "1:-2", .usual = {"-4", "2"}})};
  }

  double jar_spin() const { return speed * (1 + ratio); }
  FrameMotion frame_motion(double t) const {
    const SinCos at = sin_cos(speed * t);
    const double c = orbit_radius * at.cos, s = orbit_radius * at.sin, w = speed;
    return {{c, s, 0}, {-w * s, w * c, 0}, {-w * w * c, -w * w * s, 0}};
  }
  Rotation rotation(double t) const { return rotation_about({0, 0, 1}, jar_spin() * t); }
  Vec3 spin(double) const { return {0, 0, jar_spin()}; }
  Vec3 angular_acceleration(double) const { return {}; }
  Vec3 fixed_axis() const { return {0, 0, jar_spin() == 0 ? 0.0 : 1.0}; }
  Bounds bounds() const {
    const double a = speed * speed * orbit_radius;
    return {.speed = std::abs(speed) * orbit_radius,
            .acceleration = {a, a, 0},
            .jerk = a * std::abs(speed),
            .spin = std::abs(jar_spin())};
  }
  double period() const { return 2 * std::numbers::pi / std::abs(speed); }
  bool operator==(const Planetary&) const = default;
};

}  // namespace mahlwerk::kinematics

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A jar moved on a horizontal circle without rotation (kin.5).
struct Circular : NonRotating {
  double radius = 0;  // [m]
  double speed = 0;   // [rad/s]

  static constexpr std::string_view name = "circular";
  static constexpr std::string_view about = "a jar moved on a horizontal circle without turning";
  static constexpr Vec3 jar_axis = upright;
  static constexpr auto fields() {
    using C = Circular;
    return std::array{
        Field<C>{"radius", "m", &C::radius, positive, "radius of the circle"}
            .plausible_within("", "0.5 m")
            .with({.start = "15 mm"}),
        Field<C>{"speed", "rad/s", &C::speed, not_zero,
                 "turns of the circle per unit of time; a negative one goes the other way round"}
            .plausible_within("", "5000 rpm")
            .with(speed_of_mill("1000 rpm"))};
  }

  FrameMotion frame_motion(double t) const {
    const SinCos at = sin_cos(speed * t);
    const double c = radius * at.cos, s = radius * at.sin, w = speed;
    return {{c, s, 0}, {-w * s, w * c, 0}, {-w * w * c, -w * w * s, 0}};
  }
  Bounds bounds() const {
    const double a = speed * speed * radius;
    return {
        .speed = std::abs(speed) * radius, .acceleration = {a, a, 0}, .jerk = a * std::abs(speed)};
  }
  double period() const { return 2 * std::numbers::pi / std::abs(speed); }
  bool operator==(const Circular&) const = default;
};

}  // namespace mahlwerk::kinematics

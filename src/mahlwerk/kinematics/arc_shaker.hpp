// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A jar at the end of an arm that swings in a horizontal arc and rotates with the arm: mixer mills
/// (kin.6).
struct ArcShaker {
  double frequency = 0;  // [Hz]
  double arm = 0;        // [m]
  double swing = 0;      // [rad]

  static constexpr std::string_view name = "arc-shaker";
  static constexpr std::string_view about =
      "a lying jar at the end of an arm that swings in a horizontal arc";
  static constexpr Vec3 jar_axis = lying;
  static constexpr auto fields() {
    using A = ArcShaker;
    return std::array{
        Field<A>{"frequency", "Hz", &A::frequency, positive, "swings to and fro per second"}
            .plausible_within("", "200 Hz")
            .with({.symbol = "$f$", .start = "25 Hz", .usual = frequencies}),
        Field<A>{"arm", "m", &A::arm, positive, "length of the arm, pivot to jar centre"}
            .plausible_within("", "2 m")
            .with({.label = "length of the arm", .start = "136 mm", .usual = {"50 mm", "400 mm"}}),
        Field<A>{"swing",
                 "rad",
                 &A::swing,
                 {.least = 0, .most = std::numbers::pi / 2},
                 "largest angle of the arm to either side"}
            .with({.label = "swing to either side",
                   .start = "3.8 deg",
                   .usual = {"0.5 deg", "20 deg"}})};
  }

  double omega() const { return 2 * std::numbers::pi * frequency; }
  /// Angle of the arm and its two derivatives.
  struct Arc {
    double angle, rate, angular_acceleration;
  };
  Arc arc(double t) const {
    const double w = omega();
    const auto [s, c] = sin_cos(w * t);
    return {swing * s, swing * w * c, -swing * w * w * s};
  }
  FrameMotion frame_motion(double t) const {
    const Arc a = arc(t);
    const SinCos at = sin_cos(a.angle);
    const double c = arm * at.cos, s = arm * at.sin, r2 = a.rate * a.rate;
    return {{s, arm - c, 0},
            {c * a.rate, s * a.rate, 0},
            {c * a.angular_acceleration - s * r2, s * a.angular_acceleration + c * r2, 0}};
  }
  Rotation rotation(double t) const { return rotation_about(upright, arc(t).angle); }
  Vec3 spin(double t) const { return {0, 0, arc(t).rate}; }
  Vec3 angular_acceleration(double t) const { return {0, 0, arc(t).angular_acceleration}; }
  Vec3 fixed_axis() const { return upright; }
  Bounds bounds() const {
    const double w = omega(), rate = swing * w, angular_acceleration = swing * w * w;
    const double a = arm * math::hypot(angular_acceleration, rate * rate);
    return {.speed = arm * rate,
            .acceleration = {a, a, 0},
            .jerk = arm * (angular_acceleration * w + 3 * rate * angular_acceleration +
                           rate * rate * rate),
            .spin = rate,
            .angular_acceleration = angular_acceleration};
  }
  double period() const { return 1 / frequency; }
  bool operator==(const ArcShaker&) const = default;
};

}  // namespace mahlwerk::kinematics

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A shaker whose jar oscillates at the frequency f along its axis and at 2 f across it while the
/// axis rocks (kin.7).
struct FigureEight {
  double frequency = 0;      // [Hz]
  double stroke_along = 0;   // [m]
  double stroke_across = 0;  // [m]
  double stroke_up = 0;      // [m]
  double phase_across = 0;   // [rad]
  double phase_up = 0;       // [rad]
  double rock = 0;           // [rad]
  double phase_rock = 0;     // [rad]
  double pivot = 0;          // [m]

  static constexpr std::string_view name = "figure-eight";
  static constexpr std::string_view about =
      "a lying jar that runs through a figure of eight while its axis rocks";
  static constexpr Vec3 jar_axis = lying;
  static constexpr auto fields() {
    using F = FigureEight;
    constexpr std::string_view none = "no such motion unless said";
    return std::array{
        Field<F>{"frequency", "Hz", &F::frequency, positive, "cycles per second"}
            .plausible_within("", "200 Hz")
            .with({.symbol = "$f$", .start = "17.5 Hz", .usual = frequencies}),
        Field<F>{"stroke_along", "m", &F::stroke_along, not_negative,
                 "semi-amplitude along x, the jar's axis, at the frequency"}
            .plausible_within("", "0.5 m")
            .with({.start = "30 mm"}),
        Field<F>{"stroke_across", "m", &F::stroke_across, not_negative,
                 "semi-amplitude along y, across, at twice the frequency"}
            .plausible_within("", "0.5 m")
            .with({.start = "12.5 mm"}),
        Field<F>{"stroke_up", "m", &F::stroke_up, not_negative,
                 "semi-amplitude along z, upwards, at the frequency", 0.0, none}
            .plausible_within("", "0.5 m"),
        Field<F>{"phase_across", "rad", &F::phase_across, any_number, "phase of the motion across",
                 0.0, none},
        Field<F>{"phase_up", "rad", &F::phase_up, any_number, "phase of the motion upwards", 0.0,
                 none},
        Field<F>{"rock",
                 "rad",
                 &F::rock,
                 {.least = 0, .most = std::numbers::pi / 2},
                 "largest angle of the jar's axis to either side, about z",
                 0.0,
                 none},
        Field<F>{"phase_rock", "rad", &F::phase_rock, any_number, "phase of the rocking", 0.0,
                 none},
        Field<F>{"pivot", "m", &F::pivot, not_negative,
                 "distance from the jar's centre back along x to the axis it rocks about", 0.0,
                 none}};
  }

  double omega() const { return 2 * std::numbers::pi * frequency; }
  /// Rocking angle and its two derivatives.
  struct Rock {
    double angle, rate, angular_acceleration;
  };
  Rock rocking(double t) const {
    const double w = omega();
    const auto [s, c] = sin_cos(w * t + phase_rock);
    return {rock * s, rock * w * c, -rock * w * w * s};
  }
  FrameMotion frame_motion(double t) const {
    const double w = omega(), w2 = 2 * w;
    const SinCos along = sin_cos(w * t), across = sin_cos(w2 * t + phase_across),
                 up = sin_cos(w * t + phase_up);
    const Vec3 s{stroke_along * along.sin, stroke_across * across.sin, stroke_up * up.sin};
    const Vec3 c{w * stroke_along * along.cos, w2 * stroke_across * across.cos,
                 w * stroke_up * up.cos};
    const Rock r = rocking(t);
    const SinCos turned = sin_cos(r.angle);
    const double px = pivot * turned.cos, py = pivot * turned.sin, r2 = r.rate * r.rate;
    return {
        s + Vec3{px - pivot, py, 0}, c + Vec3{-py * r.rate, px * r.rate, 0},
        Vec3{-w * w * s.x, -w2 * w2 * s.y, -w * w * s.z} +
            Vec3{-py * r.angular_acceleration - px * r2, px * r.angular_acceleration - py * r2, 0}};
  }
  Rotation rotation(double t) const { return rotation_about(upright, rocking(t).angle); }
  Vec3 spin(double t) const { return {0, 0, rocking(t).rate}; }
  Vec3 angular_acceleration(double t) const { return {0, 0, rocking(t).angular_acceleration}; }
  Vec3 fixed_axis() const { return rock == 0 ? Vec3{} : upright; }
  Bounds bounds() const {
    const double w = omega(), w2 = 2 * w, rate = rock * w, angular_acceleration = rock * w * w;
    const double swing = pivot * math::hypot(angular_acceleration, rate * rate);
    return {
        .speed = norm({w * stroke_along, w2 * stroke_across, w * stroke_up}) + pivot * rate,
        .acceleration = {w * w * stroke_along + swing, w2 * w2 * stroke_across + swing,
                         w * w * stroke_up},
        .jerk =
            norm({w * w * w * stroke_along, w2 * w2 * w2 * stroke_across, w * w * w * stroke_up}) +
            pivot *
                (angular_acceleration * w + 3 * rate * angular_acceleration + rate * rate * rate),
        .spin = rate,
        .angular_acceleration = angular_acceleration};
  }
  double period() const { return 1 / frequency; }
  bool operator==(const FigureEight&) const = default;
};

}  // namespace mahlwerk::kinematics

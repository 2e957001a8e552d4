// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A jar that vibrates sinusoidally along a straight line (Chen et al. 2016, eq. 1) (kin.2).
struct Vibration : NonRotating {
  double frequency = 0;  // [Hz]
  double amplitude = 0;  // [m]
  double tilt = 0;       // [rad]
  double heading = 0;    // [rad]

  static constexpr std::string_view name = "vibration";
  static constexpr std::string_view about = "a jar shaken sinusoidally along a straight line";
  static constexpr Vec3 jar_axis = upright;
  static constexpr auto fields() {
    using V = Vibration;
    return std::array{
        Field<V>{"frequency", "Hz", &V::frequency, positive, "oscillations per second"}
            .plausible_within("", "200 Hz")
            .with({.label = "vibration frequency",
                   .symbol = "$f$",
                   .start = "25 Hz",
                   .usual = frequencies}),
        Field<V>{"amplitude", "m", &V::amplitude, not_negative,
                 "half the stroke: the jar moves this far to either side"}
            .plausible_within("", "0.5 m")
            .with({.label = "vibration amplitude",
                   .symbol = "$A$",
                   .start = "5 mm",
                   .usual = {"0.5 mm", "60 mm"}}),
        Field<V>{"tilt",
                 "rad",
                 &V::tilt,
                 {0, std::numbers::pi},
                 "angle of the line from the vertical",
                 0.0,
                 "vertical, as in Chen et al. 2016"}
            .with({.usual = {"0 deg", "90 deg"}}),
        Field<V>{"heading", "rad", &V::heading, any_number,
                 "direction of a tilted line around the vertical, from x", 0.0, "along x"}};
  }

  Vec3 line() const {
    if (tilt == 0) return upright;  // the usual case, evaluated at every search step
    return {math::sin(tilt) * math::cos(heading), math::sin(tilt) * math::sin(heading),
            math::cos(tilt)};
  }
  FrameMotion frame_motion(double t) const {
    const double w = 2 * std::numbers::pi * frequency;
    const auto [s, c] = sin_cos(w * t);
    const Vec3 stroke = amplitude * line();
    return {s * stroke, w * c * stroke, -w * w * s * stroke};
  }
  Bounds bounds() const {
    const double w = 2 * std::numbers::pi * frequency;
    return {.speed = w * amplitude,
            .acceleration = w * w * amplitude * componentwise_abs(line()),
            .jerk = w * w * w * amplitude};
  }
  double period() const { return 1 / frequency; }
  bool operator==(const Vibration&) const = default;
};

}  // namespace mahlwerk::kinematics

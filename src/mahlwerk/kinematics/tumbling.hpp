// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A drum that rotates about its own horizontal axis (kin.4).
struct Tumbling {
  double speed = 0;  // [rad/s]

  static constexpr std::string_view name = "tumbling";
  static constexpr std::string_view about = "a drum that turns about its own horizontal axis";
  static constexpr Vec3 jar_axis = lying;
  static constexpr auto fields() {
    return std::array{Field<Tumbling>{"speed", "rad/s", &Tumbling::speed, any_number,
                                      "speed of the drum, or % of its critical speed"}
                          .plausible_within("", "1000 rpm")
                          .with(speed_of_mill("70 %", {"5 %", "130 %"}))};
  }

  FrameMotion frame_motion(double) const { return {}; }
  Rotation rotation(double t) const { return rotation_about(lying, speed * t); }
  Vec3 spin(double) const { return speed * lying; }
  Vec3 angular_acceleration(double) const { return {}; }
  Vec3 fixed_axis() const { return speed == 0 ? Vec3{} : lying; }
  Bounds bounds() const { return {.spin = std::abs(speed)}; }
  double period() const { return no_period; }
  bool operator==(const Tumbling&) const = default;
};

}  // namespace mahlwerk::kinematics

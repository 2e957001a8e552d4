// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <limits>
#include <numbers>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/base/vec3.hpp"

// A mill is one rigid motion of the jar, in laboratory axes with z up: the position of the jar's
// centre and the rotation of the jar since mounting (kin.1).
namespace mahlwerk::kinematics {

/// Motion of the jar's centre at an instant.
struct FrameMotion {
  Vec3 centre;        ///< [m]
  Vec3 velocity;      ///< [m/s]
  Vec3 acceleration;  ///< [m/s2]
};

/// Upper bounds on magnitudes that hold at all times.
struct Bounds {
  double speed = 0;                 ///< [m/s] of the centre
  Vec3 acceleration{};              ///< [m/s2] of the centre, component by component
  double jerk = 0;                  ///< [m/s3] of the centre
  double spin = 0;                  ///< [rad/s] of the jar
  double angular_acceleration = 0;  ///< [rad/s2] of the jar
};

/// Usual frequencies of shaken mills, and how the speed of a rotating one is presented.
constexpr UsualRange frequencies{"1 Hz", "60 Hz"};
constexpr Presentation speed_of_mill(std::string_view start,
                                     UsualRange usual = {"10 rpm", "1100 rpm"}) {
  return {.label = "speed of the mill", .symbol = "$ω$", .start = start, .usual = usual};
}

/// A motion. `rotation(t)` is the rotation since mounting, `spin(t)` the angular velocity,
/// `angular_acceleration(t)` its derivative. `period()` [s] is that of the frame motion and spin,
/// infinite if there is none. `fixed_axis()` is the constant unit direction of the spin, zero if
/// the jar does not rotate or its axis changes. `jar_axis` is the direction of the mounted jar's
/// axis unless the case says otherwise.
template <class M>
concept Motion = requires(const M m, double t) {
  { M::name } -> std::convertible_to<std::string_view>;
  { M::about } -> std::convertible_to<std::string_view>;
  { M::jar_axis } -> std::convertible_to<Vec3>;
  { m.frame_motion(t) } -> std::same_as<FrameMotion>;
  { m.rotation(t) } -> std::same_as<Rotation>;
  { m.spin(t) } -> std::same_as<Vec3>;
  { m.angular_acceleration(t) } -> std::same_as<Vec3>;
  { m.bounds() } -> std::same_as<Bounds>;
  { m.period() } -> std::same_as<double>;
  { m.fixed_axis() } -> std::same_as<Vec3>;
};

constexpr double no_period = std::numeric_limits<double>::infinity();
constexpr Vec3 upright{0, 0, 1}, lying{1, 0, 0};

/// Base of all motions without rotation.
struct NonRotating {
  static constexpr Rotation rotation(double) { return {}; }
  static constexpr Vec3 spin(double) { return {}; }
  static constexpr Vec3 angular_acceleration(double) { return {}; }
  static constexpr Vec3 fixed_axis() { return {}; }
  bool operator==(const NonRotating&) const = default;
};

}  // namespace mahlwerk::kinematics

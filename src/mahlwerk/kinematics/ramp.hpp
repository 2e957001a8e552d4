// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <numbers>

#include "mahlwerk/kinematics/motion.hpp"

// A mill that comes to its speed from rest (kin.21): its motion is that of the running mill,
// X(s), by a clock s(t) that begins slowly.
namespace mahlwerk::kinematics {

/// Time of the running mill, and its two derivatives with the time of the run.
struct Clock {
  double time = 0;          ///< s [s]
  double rate = 1;          ///< ds/dt [1]
  double acceleration = 0;  ///< d2s/dt2 [1/s]
};

/// The clock of a mill that takes `ramp_time` [s] > 0. With u = t / ramp_time its rate is
/// 3 u^2 - 2 u^3, so that the acceleration of the mill is continuous.
constexpr Clock ramp_clock(double t, double ramp_time) {
  if (t >= ramp_time) return {t - 0.5 * ramp_time};
  if (t <= 0) return {0, 0, 0};
  const double u = t / ramp_time, u2 = u * u;
  return {ramp_time * u * (u2 - 0.5 * u * u2), u2 * (3 - 2 * u), 6 * u * (1 - u) / ramp_time};
}

/// Bounds of the running mill, widened so that they hold on the ramp: the derivatives of its clock
/// are at most 1, 1.5 / ramp_time and 6 / ramp_time^2.
inline Bounds ramp_bounds(Bounds b, double ramp_time) {
  const double second = 1.5 / ramp_time, third = 6 / (ramp_time * ramp_time);
  const double largest = std::max({b.acceleration.x, b.acceleration.y, b.acceleration.z});
  b.jerk += 3 * std::numbers::sqrt3 * largest * second + b.speed * third;
  b.acceleration = b.acceleration + b.speed * second * Vec3{1, 1, 1};
  b.angular_acceleration += b.spin * second;
  return b;
}

}  // namespace mahlwerk::kinematics

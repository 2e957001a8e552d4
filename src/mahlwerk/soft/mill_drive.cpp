// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/mill_drive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::soft {

void advance_drive(kinematics::Drive& drive, double time, double given, bool keep) {
  drive.advance(time, -given, keep);
  if (!drive.too_fast()) return;
  throw RunError(fmt::format(
      "at {:.4g} s the balls turn the mill at {:.4g} rpm, more than {} times its speed without "
      "load "
      "and at the start; give a higher mill.speed, or a larger drive.inertia",
      time, std::abs(drive.speed(time)) * 30 / std::numbers::pi, kinematics::Drive::largest_rate));
}

void add_drive(scene::EnergyBalance& a, const kinematics::Drive& drive, double time) {
  a.mill_speed = drive.speed(time);
  a.mill_angle = drive.angle(time);
  a.drive_kinetic = drive.kinetic(time);
  a.motor_work = drive.motor_work(time);
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/mill_drive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::soft {

void start_drive(kinematics::Drive& drive, double time, double time_step) {
  constexpr double fewest = 10;  // advances in which the motor alone brings the mill to its speed
  const double least = fewest * drive_interval * time_step;
  if (drive.shortest_time() < least)
    throw InputError(Fault{
        "drive.inertia",
        fmt::format("with an inertia of {:.3g} kg m2 the motor would bring the mill to its speed "
                    "within {:.2g} s, less than {:.0f} time steps",
                    drive.motor().inertia, drive.shortest_time(), fewest * drive_interval),
        fmt::format("give the inertia of jar and drive, {:.2g} kg m2 or more here, or a shorter "
                    "run.time_step",
                    1.05 * drive.motor().inertia * least / drive.shortest_time()),
        "drive-not-possible"});
  drive.restart(time);
}

void advance_drive(kinematics::Drive& drive, double time, double given, bool keep) {
  drive.advance(time, -given, keep);
  if (!drive.too_fast()) return;
  throw RunError(fmt::format(
      "at {:.4g} s the balls turn the mill at {:.4g} rpm, more than {} times its speed without "
      "load; "
      "give a higher speed without load, or a larger drive.inertia",
      time, std::abs(drive.speed(time)) * 30 / std::numbers::pi, kinematics::Drive::largest_rate));
}

void add_drive(scene::EnergyBalance& a, const kinematics::Drive& drive, double time) {
  a.mill_speed = drive.speed(time);
  a.mill_angle = drive.angle(time);
  a.drive_kinetic = drive.kinetic(time);
  a.motor_work = drive.motor_work(time);
}

}  // namespace mahlwerk::soft

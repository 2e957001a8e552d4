// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/kinematics/drive.hpp"
#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::soft {

/// Steps between two advances of a mill that a motor turns: short against a contact, so that the
/// lag of the torque does not excite a light drum.
constexpr std::int64_t drive_interval = 4;

/// Begins a run at `time` [s]. Throws InputError if steps of `time_step` [s] are too long for it.
void start_drive(kinematics::Drive& drive, double time, double time_step);

/// Advances a drive to `time` [s]; `given` [N m s] is what the mill has given the balls about its
/// axis so far. Throws RunError if the mill turns too fast for the neighbour lists.
void advance_drive(kinematics::Drive& drive, double time, double given, bool keep);

/// Adds the drive at `time` [s] to the energies.
void add_drive(scene::EnergyBalance& a, const kinematics::Drive& drive, double time);

}  // namespace mahlwerk::soft

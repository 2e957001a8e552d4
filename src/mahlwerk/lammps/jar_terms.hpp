// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/scene/chamber.hpp"

// Jars as regions of LAMMPS, and mills as body forces and turning walls.
namespace mahlwerk::lammps {

/// Whether the jar's own z axis lies along x of the jar frame; else it is upright.
bool is_lying(const scene::Chamber& chamber);

bool has_region(const geometry::AnyShape& shape);
/// The jars of has_region(), as words of a case.
std::string known_regions();

bool has_body_force(const kinematics::AnyMotion& motion);
/// The mills of has_body_force(), as words of a case.
std::string known_motions();

/// Commands that make the region `jar` and the variables of its motion and of the force on a ball
/// by its mass, in the jar frame (lmp.5, lmp.6). `time_step` [s].
std::string jar_commands(const scene::Chamber& chamber, double time_step);

/// A formula that tells with which faces of the jar a ball is in contact: a power of two for each.
/// It reads the ball's radius as `c_radius`.
std::string touch_formula(const scene::Chamber& chamber);

/// Commands that make the variables `wall_power` and `body_power` [W]: the work of the turning wall
/// and of the body force on the balls by time (lmp.7). The torque of the wall follows from all
/// forces on the balls, as those between balls cancel.
std::string power_commands(const scene::Chamber& chamber);

}  // namespace mahlwerk::lammps

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"

// Quantities derived from the jar and the balls of a case.
namespace mahlwerk::cases {

double jar_volume(const Jar& jar);                       ///< [m3]
double ball_volume(const BallSet& set);                  ///< [m3] of one ball
double balls_mass(const std::vector<BallSet>& balls);    ///< [kg] without grains of the powder
double balls_volume(const std::vector<BallSet>& balls);  ///< [m3] without grains of the powder
std::int64_t balls_count(const std::vector<BallSet>& balls);
bool has_bodies(const Case& c);  ///< whether some balls are no spheres
/// Which ball sets are bodies with an axis of revolution; none if no set is.
std::vector<bool> sets_with_axis(const Case& c);
double largest_ball(const std::vector<BallSet>& balls);  ///< [m] diameter; NaN if one is unknown
/// [m] Diameter of the smallest ball, without grains of the powder; infinite without balls.
double smallest_ball(const std::vector<BallSet>& balls);
/// [1] Share of voids in a bed at rest, of balls and of powder, by convention (Austin, Klimpel and
/// Luckie 1984).
constexpr double bed_porosity = 0.4;
/// [1] J: bulk volume of the balls over the volume of the jar (obs.14).
double bulk_filling(const std::vector<BallSet>& balls, const Jar& jar);
/// [1] U: bulk volume of the powder over the voids between the balls (obs.15); no value without
/// powder or its density.
std::optional<double> void_filling(const Case& c);
/// [kg/m3] Mass of the balls over their bulk volume.
double bulk_density(const std::vector<BallSet>& balls);
/// [m/s2] The part of gravity across the axis of a drum, which is the x axis of its mill.
double across_axis(const Vec3& gravity);
/// [rad/s] Critical speed, at which the largest ball centrifuges on the wall of a tumbling jar
/// (kin.11); `gravity` is that across the axis.
double critical_speed(const Jar& jar, const std::vector<BallSet>& balls, double gravity);
/// [rad/s] Speed of the shaft that drives a drum, the disc of a planetary mill or a stirrer; no
/// value where no shaft turns steadily.
std::optional<double> shaft_speed(const Case& c);
/// The speed over time of [mill], or the ramp of [run]; empty: the full speed throughout.
kinematics::SpeedProgram speed_program(const Case& c);
/// Whether the speed of a run is another one than that of the case: [drive], or a speed over time.
bool speed_varies(const Case& c);
/// The first part of the only shaft of turning parts: all turn about one line, at one speed, in one
/// frame. Null if there is none, or if there are several.
const MachinePart* shaft_part(const Case& c);
/// [rad/s] Speed without load of what [drive] turns: a drum, or in a jar at rest its stirrer, of an
/// attritor or of turning parts; 0 if there is no such thing.
double speed_without_load(const Case& c);
/// The motion of a drum: a tumbling jar that turns about its own axis. Null for other mills, and
/// for a tumbler that turns its jar end over end.
const kinematics::Tumbling* drum_motion(const Case& c);

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/cases/case.hpp"

// Quantities derived from the jar and the balls of a case.
namespace mahlwerk::cases {

double jar_volume(const Jar& jar);                       ///< [m3]
double ball_volume(const BallSet& set);                  ///< [m3] of one ball
double balls_mass(const std::vector<BallSet>& balls);    ///< [kg] without grains of the powder
double balls_volume(const std::vector<BallSet>& balls);  ///< [m3] without grains of the powder
std::int64_t balls_count(const std::vector<BallSet>& balls);
double largest_ball(const std::vector<BallSet>& balls);  ///< [m] diameter; NaN if one is unknown
/// [m] Diameter of the smallest ball, without grains of the powder; infinite without balls.
double smallest_ball(const std::vector<BallSet>& balls);
/// [rad/s] Critical speed, at which the largest ball centrifuges on the wall of a tumbling jar
/// (kin.11).
double critical_speed(const Jar& jar, const std::vector<BallSet>& balls, double gravity);

}  // namespace mahlwerk::cases

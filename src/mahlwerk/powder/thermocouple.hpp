// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace mahlwerk::powder {

/// Readings of a thermocouple of time constant `lag` [s] >= 0, whose surroundings have the
/// temperatures `around` [K] at `times` [s], which do not decrease, and temperatures between them
/// in between. Exact for such temperatures (sns.8). The first reading is that of the surroundings.
std::vector<double> thermocouple_readings(std::span<const double> times,
                                          std::span<const double> around, double lag);

/// [K] Temperature of a gas without heat capacity between balls and wall: the mean of theirs, by
/// area [m2] (sns.7).
double gas_temperature(double balls, double balls_area, double wall, double wall_area);

}  // namespace mahlwerk::powder

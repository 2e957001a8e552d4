// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "mahlwerk/measure/finding.hpp"

// Restitution from drop tests.
namespace mahlwerk::measure {

/// One impact.
struct Bounce {
  double speed = 0;        ///< [m/s] before it
  double restitution = 0;  ///< speed after it over speed before it
  bool first = false;      ///< after a fall from a known height, onto fresh powder
};

/// [m/s2]
constexpr double standard_gravity = 9.81;

/// An impact from the height of the fall and that of the rebound [m] (mea.13).
Bounce bounce_of_heights(double fall, double rebound);

/// Impacts of one or several drops from the times [s] of all impacts (mea.14): between two impacts
/// the ball flies, and a flight longer than the last begins a new drop. Flights below 20 ms are
/// left out. `height` [m] of the fall of each drop; NaN: not known, then the first impact of a drop
/// has no restitution. Throws InputError for less than two flights.
std::vector<Bounce> bounces_of_times(const std::vector<double>& times,
                                     double height = std::numeric_limits<double>::quiet_NaN());

/// Mean restitution and speed: over first impacts if there are any, else over all. Throws
/// InputError for fewer than three impacts or a restitution that is not between 0 and 1.
Findings restitution_of(const std::vector<Bounce>& bounces);

}  // namespace mahlwerk::measure

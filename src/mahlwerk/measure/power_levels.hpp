// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/measure/finding.hpp"

// Levels in the log of a power meter.
namespace mahlwerk::measure {

/// The level of a plateau.
struct PowerLevel {
  observe::Estimate power = {};  ///< [W] median, with the half-width of the mean of a correlated
                                 ///< series and that of the meter's resolution (mea.11)
  double drift = 0;              ///< [W] from begin to end, 0 if it is not beyond chance
  std::size_t readings = 0;
};

/// The level of readings [W] of one state of a mill; NaN are left out. Throws InputError for fewer
/// than 10 readings.
PowerLevel power_level(std::span<const double> readings);

/// Readings of an idle and a loaded mill in one log.
struct TwoLevels {
  std::vector<double> idle, load;  ///< [W]
};

/// Splits a log in two by the threshold that makes both parts most uniform (Otsu 1979); the part
/// with more power is the loaded mill. Readings at the borders of plateaus, and those of a mill
/// that is off (below a fifth of the largest), are left out. Throws InputError if there are not
/// clearly two levels.
TwoLevels two_levels(std::span<const double> readings);

}  // namespace mahlwerk::measure

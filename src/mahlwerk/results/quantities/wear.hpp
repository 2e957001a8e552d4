// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// Wear and temperatures of balls and jar (docs/theory/wear-heat.md).
namespace mahlwerk::results {

/// [m3/s] Wear of the jar's wall, from sums per second over its hits. The case must have [wear].
double wall_wear_rate(const cases::Case& mill_case, double slid, double erosion);

/// Wear of balls and jar, and contamination of the powder; empty without [wear].
Measures wear_measures();
/// wear.csv: a row per ball set and face of the jar; no rows without [wear].
Table wear(const Outcome& outcome);

/// Temperatures at the end of milling; empty without [heat].
Measures heat_measures();
/// temperature.csv: temperatures over milling and pauses; no rows without [heat].
Table temperatures(const Outcome& outcome);

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// Force, torque and power of the parts in the jar (obs.22).
namespace mahlwerk::results {

/// Power and torque of all parts.
Measures part_measures();

/// Each part with its quantities; empty without parts or without a counted time.
std::vector<PartSummary> by_part(const Outcome& outcome);
/// parts.csv: a row for each part.
Table parts_table(const std::vector<PartSummary>& parts);

}  // namespace mahlwerk::results

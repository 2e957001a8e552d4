// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// [1] Overlap over a ball's radius above which contact laws are less accurate.
constexpr double soft_overlap = 0.01;

/// What an overlap above soft_overlap means, and what helps: with a softening of 1 the stiffness is
/// that of the material.
std::string overlap_advice(const cases::Case& mill_case);

/// Warnings of a run: a run cut short or stopped, an energy balance that does not close and others
/// (docs/warnings.md). Made once from `outcome.summary` when the run ends, and kept in
/// `Outcome::notices`.
Notices warnings(const Outcome& outcome);

/// Says when counting began, and warns if the counted part of the run is not that of a settled
/// mill, not a whole period, or holds few hits.
Notices settling_warnings(const Outcome& outcome);

/// Names the quantities that contact.softening changes, with the size of the change.
Notices softened_quantities(const Outcome& outcome);
/// What a drive whose sense of rotation changes ([milling] reverse) means for the result.
Notices reversal_notices(const Outcome& outcome);

}  // namespace mahlwerk::results

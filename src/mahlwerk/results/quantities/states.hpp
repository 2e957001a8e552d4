// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/observe/groups.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

// Replicates that fall into two states by their dissipated power
// (docs/theory/statistics.md, "Two states").
namespace mahlwerk::results {

/// The two groups of powers [W] whose means differ by more than a fifth of the larger one; nothing
/// if there is one group, or `rounding` [W] exceeds both means.
std::optional<observe::TwoGroups> power_groups(const std::vector<double>& powers, double rounding);

/// The two states, or nothing if the replicates show one state or are too few. `each` holds the
/// values of every replicate.
std::optional<TwoStates> two_states(const Outcome& outcome, const std::vector<Measure>& measures,
                                    const std::vector<std::vector<double>>& each);

/// The warning about two states; empty where there is one state.
Notices state_notices(const Summary& summary);

}  // namespace mahlwerk::results

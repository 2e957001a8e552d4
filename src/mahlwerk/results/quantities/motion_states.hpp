// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// States of motion of the balls in a lying jar that is shaken (obs.20).
namespace mahlwerk::results {

/// Whether a case has such states.
bool has_motion_states(const cases::Case& c);

/// Shares of the balls' time in the states, changes of state, turns round the jar's axis, axial
/// travel.
Measures motion_state_measures();

/// The states that have at least a hundredth of the time of the averaged replicates, the longest
/// first, with what happens in each.
std::vector<MotionStateSummary> motion_states(const Outcome& outcome);

/// The states with at least a tenth of the time of these replicates, the longest first: "circling",
/// "circling and bouncing"; empty where nothing was counted.
std::string motion_word(const std::vector<const Replicate*>& replicates);
/// "circling for 79 % of the time, 1.3 turns round the jar's axis in a period; bouncing for 21 %".
std::string motion_reason(const std::vector<MotionStateSummary>& states);

/// The warning that means are taken over several states; empty where they are over one, or where
/// the states do not differ in power or hits.
Notices motion_state_notices(const Outcome& outcome);

}  // namespace mahlwerk::results

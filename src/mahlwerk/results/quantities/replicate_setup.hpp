// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/outcome.hpp"

// Helpers of programs that run a case and fill an Outcome.
namespace mahlwerk::results {

/// An empty replicate of the case: its kinds of pairs, its wall grid and its factors from losses to
/// wear and flash temperatures.
Replicate empty_replicate(const cases::Case& mill_case);
/// The result of a replicate that did not run, packed.
Replicate unrun_replicate(const cases::Case& mill_case);

/// Merges each two neighbouring windows into one; an odd last window is left out.
std::vector<Window> merge_window_pairs(const std::vector<Window>& windows);

}  // namespace mahlwerk::results

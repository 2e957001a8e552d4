// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/outcome.hpp"

// What whoever runs a case needs to fill an Outcome.
namespace mahlwerk::results {

/// A replicate of that case before anything has happened: which pairs are told apart, how the wall
/// is cut into cells, what turns losses into wear.
Replicate empty_replicate(const cases::Case& what);

/// Each two neighbouring windows as one; an odd one at the end is left out.
std::vector<Window> merge_window_pairs(const std::vector<Window>& windows);

}  // namespace mahlwerk::results

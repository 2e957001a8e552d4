// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// A replicate that is drawn for all replicates in the same state of motion.
struct Representative {
  std::size_t replicate = 0;  ///< its index in the outcome
  std::string words;          ///< "cataracting, replicate 3 of 8"
};

/// The replicates to draw: one for each regime that occurs among the averaged replicates (obs.8);
/// if all have the same, one for each of two groups by the speed of the balls, if these are
/// significant (sta.7) and differ by a fifth; else one for all. The most frequent group comes
/// first. It is the replicate with the median speed (of an even number the slower of the middle
/// two). Where balls have no such speed, the dissipated power counts.
std::vector<Representative> representatives(const results::Outcome& outcome);

}  // namespace mahlwerk::report

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

/// The replicates to draw: one for each regime that occurs among the averaged replicates (obs.8,
/// the most frequent first), else, for each of two states by the dissipated power (sta.7), else one
/// for all. It is the one with the median speed of the balls (of an even number the slower of the
/// middle two), without such a quantity with the median dissipated power.
std::vector<Representative> representatives(const results::Outcome& outcome);

}  // namespace mahlwerk::report

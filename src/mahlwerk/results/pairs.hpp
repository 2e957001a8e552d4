// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/summary.hpp"

// Collisions by kind of pair: ball set with ball set, ball set with jar.
namespace mahlwerk::results {

/// The quantities of one kind of pair (docs/formats.md, "_pairs").
struct PairSummary {
  std::string one, other;  ///< "balls.1", "powder", "jar"
  std::vector<Quantity> quantities;
};

/// Every kind of pair there can be; none where there is one only (a single ball) or no time was
/// counted.
std::vector<PairSummary> by_pair(const Outcome& outcome);

std::string collisions_by_pair_csv(const std::vector<PairSummary>& pairs);
/// A row per kind of pair and bin of normal energy that holds collisions.
std::string spectra_by_pair_csv(const Outcome& outcome);
/// sizes.csv: the sizes of balls of each set; empty where each set has one size.
std::string sizes_csv(const cases::Case& what);

}  // namespace mahlwerk::results

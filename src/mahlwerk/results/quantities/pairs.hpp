// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"

// Collisions by kind of pair: ball set with ball set, ball set with jar.
namespace mahlwerk::results {

/// Every kind of pair there can be; none where there is one only (a single ball) or no time was
/// counted.
std::vector<PairSummary> by_pair(const Outcome& outcome);

/// collisions_by_pair.csv: a row per kind of pair.
Table collisions_by_pair(const std::vector<PairSummary>& pairs);
/// The first two columns of a table by kind of pair, and the cells of a row in them.
std::vector<Column> pair_columns();
std::vector<double> pair_cells(Table& table, const std::array<std::string, 2>& names);
/// Who the two are: ball sets, a face of the jar as in [[contact.pairs]] ("jar.side"), or "jar"
/// where faces are not told apart.
std::array<std::string, 2> pair_names(const cases::Case& what,
                                      const observe::StatisticsByPair& pairs, int pair);

/// sizes.csv: the sizes of balls of each set; no rows where each set has one size.
Table sizes(const cases::Case& what);

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/traits.hpp"
#include "mahlwerk/results/table.hpp"

// Collisions by kind of pair: ball set with ball set, ball set with jar.
namespace mahlwerk::results {

/// Sums over the collisions of one kind of pair in one replicate.
struct PairTotals {
  observe::PairSums all, above;
};

/// The record of a quantity of one kind of pair, in one replicate whose counted time is `time` [s].
struct PairMeasure {
  std::string name, unit, about;
  double (*compute)(const PairTotals& tally, double time);
  QuantityTraits traits = {};  ///< of quantities that all collisions together do not have
};
const std::vector<PairMeasure>& pair_measures();

/// Summaries of all possible kinds of pairs; empty for a single kind (one ball) and without counted
/// time.
std::vector<PairSummary> by_pair(const Outcome& outcome);

/// collisions_by_pair.csv: a row per kind of pair.
Table collisions_by_pair(const std::vector<PairSummary>& pairs);
/// The first two columns of a table by kind of pair; `pair_cells` gives a row's cells in them.
std::vector<Column> pair_columns();
std::vector<double> pair_cells(Table& table, const std::array<std::string, 2>& names);
/// Number of the distinguished faces that are the jar's; each part is one of those after them.
int distinguished_jar_faces(const cases::Case& mill_case, const observe::StatisticsByPair& pairs);
/// The part that is the distinguished face `face`; null for a face of the jar.
const cases::MachinePart* part_of(const cases::Case& mill_case,
                                  const observe::StatisticsByPair& pairs, int face);
/// Names of the two bodies: ball sets, a face of the jar or a part as in [[contact.pairs]]
/// ("jar.side", "parts.stirrer"), or "jar" where its faces are not distinguished.
std::array<std::string, 2> pair_names(const cases::Case& mill_case,
                                      const observe::StatisticsByPair& pairs, int pair);

/// sizes.csv: the ball sizes of each set; no rows if each set has one size.
Table sizes(const cases::Case& mill_case);

}  // namespace mahlwerk::results

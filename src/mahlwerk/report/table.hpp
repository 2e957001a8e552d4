// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::report {

/// A row of the table of results: a quantity over all collisions and, if there is one, its
/// counterpart over collisions above the threshold.
struct Row {
  const results::Quantity* all = nullptr;
  const results::Quantity* above = nullptr;
  std::string_view group = {};  ///< heading of its group if it is the group's first row; else empty

  bool only_above = false;  ///< `all` covers collisions above the threshold only

  std::string all_text() const;    ///< both in the same multiple of their unit
  std::string above_text() const;  ///< empty without counterpart
};
std::vector<Row> rows(const std::vector<results::Quantity>& quantities);

/// The table for the terminal, with half-widths and units. The threshold [m/s] is in the head of
/// its column.
std::string table(const std::vector<results::Quantity>& quantities, double threshold);

/// Head and rows of the table of pairs, a row for each kind of pair: rates, mean normal energies
/// and powers. Pairs without collisions are omitted.
std::vector<std::string> pair_heading(double threshold);
std::vector<std::vector<std::string>> pair_rows(const std::vector<results::PairSummary>& pairs);

/// The same for the terminal; empty if there are no pairs.
std::string pair_table(const std::vector<results::PairSummary>& pairs, double threshold);

}  // namespace mahlwerk::report

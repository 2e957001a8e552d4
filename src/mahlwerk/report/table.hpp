// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::report {

/// A line of the table that people read: a quantity over all collisions and, where there is one,
/// its twin over those above the threshold.
struct Row {
  const results::Quantity* all = nullptr;
  const results::Quantity* above = nullptr;
  std::string_view group = {};  ///< heading of the rows that it is the first of; else empty

  bool only_above = false;  ///< `all` is over collisions above the threshold, and has no twin

  std::string all_text() const;    ///< both in the same multiple of their unit
  std::string above_text() const;  ///< empty without a twin
};
std::vector<Row> rows(const std::vector<results::Quantity>& quantities);

/// The table for the terminal, with half-widths and readable units. `threshold` [m/s] heads its
/// column.
std::string table(const std::vector<results::Quantity>& quantities, double threshold);

/// The head of the table of pairs, and a line for each kind: who with whom, rates, mean normal
/// energies and powers. Rows in which nothing collided are left out.
std::vector<std::string> pair_heading(double threshold);
std::vector<std::vector<std::string>> pair_rows(const std::vector<results::PairSummary>& pairs);

/// The same for the terminal; empty if there are no pairs.
std::string pair_table(const std::vector<results::PairSummary>& pairs, double threshold);

}  // namespace mahlwerk::report

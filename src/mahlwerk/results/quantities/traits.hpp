// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "mahlwerk/cases/case.hpp"

// What tables, pages, axes and intervals need to know of a quantity, by its name.
namespace mahlwerk::results {

struct Window;

/// The values that a quantity can have, in its unit.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};
constexpr Range any_value{}, not_negative{.least = 0}, share_of_whole{.least = 0, .most = 1};

/// What is known of a quantity besides its name, unit, description and function. That of a quantity
/// over all collisions holds for its twin over those above the threshold, too: label, symbol,
/// range.
struct QuantityTraits {
  Range range = not_negative;         ///< any_value for signed quantities and temperatures in degC
  std::string_view label = {};        ///< in tables and on axes; empty: the name with blanks
  std::string_view symbol = {};       ///< on axes: "$E_{n}$"
  std::string_view equation = {};     ///< its label in docs/theory: "obs.13"
  std::string_view heading = {};      ///< of the group that begins with this quantity
  int key = 0;                        ///< place among the key numbers, from 1; 0: not one of them
  int column = 0;                     ///< place among the columns of a campaign's table, from 1
  std::string_view column_head = {};  ///< there; empty: the label
  bool above_threshold = false;  ///< of collisions above the threshold, which the name leaves out
  bool worst = false;            ///< the largest value over replicates, not the mean
  double (*over_time)(const Window&) = nullptr;        ///< value in a window of time
  bool (*applies)(const cases::Case&) = nullptr;       ///< whether a case has it; null: every case
  std::string_view only = {};                          ///< which cases have it, in words
  std::string (*about)(const cases::Case&) = nullptr;  ///< description that depends on the case
};

/// The traits of a quantity of summary.json or of one kind of pair, those of the same quantity over
/// all collisions where it has none; of unknown names, any value.
const QuantityTraits& traits_of(std::string_view quantity);

/// Range of a quantity: rates, energies, sizes and powers are at least 0, shares of a whole are in
/// [0, 1]. A mill in its steady state draws what the charge dissipates; a drawn power below 0 is
/// that of a charge that still slows down.
inline Range range_of(std::string_view quantity) {
  return traits_of(quantity).range;
}

/// "mean normal energy above threshold"; of unknown names, the name with blanks.
std::string label_of(std::string_view quantity);

}  // namespace mahlwerk::results

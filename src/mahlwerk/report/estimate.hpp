// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/json_value.hpp"
#include "mahlwerk/results/outcome.hpp"

// The first answers of a run, each with the band in which it lies and what makes the band wide.
namespace mahlwerk::report {

/// What an assumed value does to one quantity, at the ends of its plausible range.
struct BandCause {
  std::string key;
  std::array<std::string, 2> ends;  ///< of the value
  std::array<double, 2> at_ends{};  ///< of the quantity
};

/// A quantity and its band: over the values that were assumed, one at a time, and over replicates.
struct Band {
  results::Quantity quantity;
  double low = 0, high = 0;
  std::vector<BandCause> causes;  ///< beyond chance, the largest first
};

/// The bands of power, hits, their energy and the dose, as far as the run has them.
std::vector<Band> bands(const results::Outcome& outcome);

/// The bands as a table, what to measure to narrow them, and the warnings of the run.
std::string estimate_words(const results::Outcome& outcome);

/// The same as JSON; `case_text` is the case that was run.
results::Json estimate_json(const results::Outcome& outcome, std::string_view case_text,
                            std::string_view version);

}  // namespace mahlwerk::report

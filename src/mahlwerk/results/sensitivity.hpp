// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What the assumed values of a case do to its result (docs/theory/statistics.md, "Assumed values").
namespace mahlwerk::results {

/// Key quantities at the two ends of the plausible range of one assumed key.
struct AssumedInfluence {
  std::string key, value;           ///< as in cases::Origin
  std::array<std::string, 2> ends;  ///< of the range, as written in a case file
  std::string source;               ///< of the value and its range
  /// Values of Sensitivity::quantities at each end: those of the result times the ratio of the run
  /// at the end to the same run with the assumed value. NaN where a run has none.
  std::array<std::vector<double>, 2> at_ends;
};

/// Runs of one replicate at the ends of the plausible ranges of assumed keys, one key at a time,
/// relative to the same run with the assumed values.
struct Sensitivity {
  double time = 0;                      ///< [s] counted time of each run
  std::int64_t replicates = 1;          ///< of each run
  std::vector<std::string> quantities;  ///< names, the first decides the order of the keys
  /// Of each quantity, the difference that two such runs have by chance in 95 of 100 cases, from
  /// the scatter of the replicates; 0 if that is not known.
  std::vector<double> scatter;
  std::vector<AssumedInfluence> keys;  ///< the largest influence first
  std::vector<std::string> left_out;   ///< assumed keys for which no run was made

  /// Whether a value of the quantity of that index differs from that of the result, `value`, by
  /// more than chance makes.
  bool beyond_chance(std::size_t quantity, double at_end, double value) const {
    return std::abs(at_end - value) > scatter[quantity];
  }
  /// Least and largest value over all keys whose influence exceeds the scatter, and of the result
  /// itself, `value`; none for a quantity that is not among `quantities`.
  std::optional<std::pair<double, double>> range(std::string_view quantity, double value) const;
};

}  // namespace mahlwerk::results

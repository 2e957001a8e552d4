// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/sweep/designs.hpp"

// How much each key does to an outcome, from the points of a design (docs/theory/sensitivity.md).
// Outcomes are given by row of the design, NaN where a run failed: what rests on it is left out.
// `errors` are their standard errors, `ci95` half-widths of their 95 % intervals; empty: not known.
// What a key does is `significant` if it is more than chance makes; nothing: that is not known. It
// is `inactive` if no outcome changes, not by a digit, where it alone moves. Wrong numbers of rows
// throw std::invalid_argument.
namespace mahlwerk::campaign {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Standard errors of outcomes from half-widths over so many replicates each (sen.10). Empty if one
/// is not known of a row that has an outcome.
std::vector<double> standard_errors(const std::vector<double>& outcomes,
                                    const std::vector<double>& ci95,
                                    const std::vector<double>& replicates);

/// A number with its 95 % interval; NaN where there is none.
struct IntervalEstimate {
  double value = 0, low = 0, high = 0;
};

/// What a key does alone, in units of the outcome.
struct Swing {
  IntervalEstimate at_low, at_high;  ///< the outcome with the key at 0 and at 1
  std::optional<bool>
      significant;  ///< one of them differs from the base by more than their intervals
  bool inactive = false;
};
struct Swings {
  IntervalEstimate base;
  std::vector<Swing> keys;
  int failed = 0;  ///< rows
};
Swings swings(const std::vector<double>& outcomes, const std::vector<double>& ci95);

/// Change of an outcome over the whole range of a key, here and there in the ranges of the others.
struct KeyEffects {
  IntervalEstimate mean_absolute;   ///< mu* (sen.3)
  IntervalEstimate mean;            ///< mu (sen.3)
  IntervalEstimate deviation;       ///< sigma (sen.4): what it does bends, or hangs on other keys
  double of_noise = 0;              ///< mu* that errors alone would give (sen.5); NaN: not known
  std::size_t count = 0;            ///< of steps that both have outcomes
  std::optional<bool> significant;  ///< mu* is surely more than errors alone would give
  bool inactive = false;
};
struct ElementaryEffects {
  std::vector<KeyEffects> keys;
  int failed = 0;
};
ElementaryEffects elementary_effects(const DesignMatrix& design,
                                     const std::vector<double>& outcomes,
                                     const std::vector<double>& errors);

/// A key's shares of the variance that an outcome has over all ranges. Estimates may fall a little
/// below 0.
struct SobolIndices {
  IntervalEstimate first;           ///< what is lost if it alone is known (sen.8)
  IntervalEstimate total;           ///< what is left if all but it are known (sen.9)
  std::size_t count = 0;            ///< of groups used
  std::optional<bool> significant;  ///< the total is surely above 0, and errors are taken off
  bool inactive = false;
};
struct VarianceDecomposition {
  std::vector<SobolIndices> keys;
  double variance = 0;  ///< of the outcome, without that of errors (sen.7)
  double noise = 0;     ///< share of errors in the variance seen; NaN: not known, or none is seen
  int failed = 0;
};
/// Rows as of `saltelli_design`; intervals by drawing groups anew (Efron 1979), the same for the
/// same seed. All NaN if the outcome varies no more than its errors.
VarianceDecomposition variance_decomposition(std::size_t keys, const std::vector<double>& outcomes,
                                             const std::vector<double>& errors,
                                             std::uint64_t seed = 1);

}  // namespace mahlwerk::campaign

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/points/designs.hpp"
#include "mahlwerk/cases/sweep.hpp"
#include "mahlwerk/observe/statistics.hpp"

// Sensitivity of an outcome to each key, from the points of a design (docs/theory/sensitivity.md).
// Outcomes are given by row of the design, NaN where a run failed; effects that need a failed run
// are left out. `errors` are standard errors of the outcomes, `ci95` half-widths of their 95 %
// intervals; empty: not known. Wrong numbers of rows throw std::invalid_argument.
namespace mahlwerk::campaign {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Standard errors of outcomes from half-widths over the given numbers of replicates (sen.10).
/// Empty if that of any row with an outcome is not known.
std::vector<double> standard_errors(const std::vector<double>& outcomes,
                                    const std::vector<double>& ci95,
                                    const std::vector<double>& replicates);

/// Effect of a key on a quantity. The members that are set depend on the design; NaN: unknown.
/// Numbers of the first two designs are in the quantity's unit; an elementary effect is over the
/// whole range of the key.
struct Effect {
  std::string key = {};
  std::string low_end = {}, high_end = {};        ///< ends of its range: "200 rpm", "400 rpm"
  observe::IntervalEstimate low = {}, high = {};  ///< one at a time: value at the ends
  observe::IntervalEstimate mean_absolute = {};   ///< Morris: mu* (sen.3)
  observe::IntervalEstimate mean = {};            ///< mu (sen.3)
  /// sigma (sen.4): nonlinearity, or interaction with other keys
  observe::IntervalEstimate deviation = {};
  double of_noise = unknown;  ///< mu* that errors alone would give (sen.5)
  /// Sobol: first-order index (sen.8). Estimates may be slightly below 0.
  observe::IntervalEstimate first_order = {};
  observe::IntervalEstimate total = {};  ///< total index, with interactions (sen.9)
  std::size_t count = 0;                 ///< Morris: effects used; Sobol: groups
  /// Whether it differs significantly from zero: an end differs from the base by more than the
  /// joint half-width, the interval of mu* lies above of_noise, or that of the total index above 0
  /// with known errors; nullopt: unknown.
  std::optional<bool> significant = std::nullopt;
  bool inactive = false;  ///< no result changes if only this key changes
};

/// Sensitivity of a quantity to the keys.
struct Sensitivity {
  std::string quantity = {}, unit = {};  ///< of summary.json, in SI
  cases::Design design = cases::Design::one_at_a_time;
  observe::IntervalEstimate base = {};  ///< of the base case, or the mean over all points
  double variance = unknown;            ///< Sobol: variance without that of errors (sen.7)
  double noise = unknown;               ///< Sobol: share of errors in the observed variance
  std::vector<Effect> effects = {};     ///< by key
  int failed = 0;                       ///< rows without an outcome
};

/// Mean of the outcomes over all points that have one.
observe::IntervalEstimate mean_of_points(const std::vector<double>& outcomes);

/// Effects of one key at a time; rows as of `one_at_a_time_design`.
Sensitivity one_at_a_time_effects(const std::vector<double>& outcomes,
                                  const std::vector<double>& ci95);

/// Elementary effects of a design as of `morris_design`: changes of an outcome over the whole range
/// of a key, at several points in the ranges of the other keys.
Sensitivity elementary_effects(const DesignMatrix& design, const std::vector<double>& outcomes,
                               const std::vector<double>& errors);

/// Shares of the keys in the variance of an outcome over all ranges. Rows as of `saltelli_design`;
/// intervals by bootstrap over groups (Efron 1979), the same for the same seed. All NaN if the
/// outcome varies no more than its errors.
Sensitivity variance_decomposition(std::size_t keys, const std::vector<double>& outcomes,
                                   const std::vector<double>& errors, std::uint64_t seed = 1);

}  // namespace mahlwerk::campaign

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/points/designs.hpp"
#include "mahlwerk/observe/statistics.hpp"

// Sensitivity of an outcome to each key, from the points of a design (docs/theory/sensitivity.md).
// Outcomes are given by row of the design, NaN where a run failed; effects that need a failed run
// are left out. `errors` are standard errors of the outcomes, `ci95` half-widths of their 95 %
// intervals; empty: not known. An effect is `significant` if it exceeds the noise; empty: not
// known. A key is `inactive` if all outcomes stay identical where only this key changes. Wrong
// numbers of rows throw std::invalid_argument.
namespace mahlwerk::campaign {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Standard errors of outcomes from half-widths over the given numbers of replicates (sen.10).
/// Empty if that of any row with an outcome is not known.
std::vector<double> standard_errors(const std::vector<double>& outcomes,
                                    const std::vector<double>& ci95,
                                    const std::vector<double>& replicates);

/// Effect of one key alone, in units of the outcome.
struct Swing {
  observe::IntervalEstimate at_low, at_high;  ///< the outcome with the key at 0 and at 1
  std::optional<bool>
      significant;  ///< an end differs from the base by more than the joint half-width
  bool inactive = false;
};
struct Swings {
  observe::IntervalEstimate base;
  std::vector<Swing> keys;
  int failed = 0;  ///< rows
};
/// Effects of one key at a time; rows as of `one_at_a_time_design`.
Swings swings(const std::vector<double>& outcomes, const std::vector<double>& ci95);

/// Elementary effects of a key: changes of an outcome over its whole range, at several points in
/// the ranges of the other keys.
struct KeyEffects {
  observe::IntervalEstimate mean_absolute;  ///< mu* (sen.3)
  observe::IntervalEstimate mean;           ///< mu (sen.3)
  observe::IntervalEstimate
      deviation;                    ///< sigma (sen.4): nonlinearity, or interaction with other keys
  double of_noise = 0;              ///< mu* that errors alone would give (sen.5); NaN: not known
  std::size_t count = 0;            ///< of steps with outcomes at both ends
  std::optional<bool> significant;  ///< the interval of mu* lies above of_noise
  bool inactive = false;
};
struct ElementaryEffects {
  std::vector<KeyEffects> keys;
  int failed = 0;
};
/// Elementary effects of a design as of `morris_design`.
ElementaryEffects elementary_effects(const DesignMatrix& design,
                                     const std::vector<double>& outcomes,
                                     const std::vector<double>& errors);

/// Sobol' indices of a key: its shares of the variance of an outcome over all ranges. Estimates may
/// be slightly below 0.
struct SobolIndices {
  observe::IntervalEstimate first;  ///< first-order index (sen.8)
  observe::IntervalEstimate total;  ///< total index (sen.9)
  std::size_t count = 0;            ///< of groups used
  std::optional<bool> significant;  ///< the interval of `total` lies above 0, and errors are known
  bool inactive = false;
};
struct VarianceDecomposition {
  std::vector<SobolIndices> keys;
  double variance = 0;  ///< of the outcome, without that of errors (sen.7)
  double noise = 0;  ///< share of errors in the observed variance; NaN: not known, or no variance
  int failed = 0;
};
/// Rows as of `saltelli_design`; intervals by bootstrap over groups (Efron 1979), the same for the
/// same seed. All NaN if the outcome varies no more than its errors.
VarianceDecomposition variance_decomposition(std::size_t keys, const std::vector<double>& outcomes,
                                             const std::vector<double>& errors,
                                             std::uint64_t seed = 1);

}  // namespace mahlwerk::campaign

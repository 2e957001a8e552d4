// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/wear/worn_case.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Wear per second of operation of each body of a stage.
struct WearRates {
  std::vector<std::vector<double>> sections;  ///< [m2/s] area that each side loses, smoothed
  std::vector<std::vector<double>> surfaces;  ///< [m3/s] volume that each vertex loses, smoothed
  double shell = 0, ends = 0;                 ///< [m3/s] of a round jar
  double jar = 0, parts = 0;                  ///< [m3/s] of all faces of the jar, of all parts
  std::vector<std::vector<double>> balls;     ///< [m3/s] of each ball of a cohort, by set
};

using RecordedWear = std::vector<std::shared_ptr<observe::WearSums>>;  ///< of each replicate

/// The observers' tables for a stage.
std::shared_ptr<const observe::LoadFactors> load_factors(const cases::Case& stage);

/// Means over the replicates.
WearRates wear_rates(const WornCase& of, const WornState& state, const results::Outcome& outcome,
                     const RecordedWear& recorded);

/// [1/s] The largest relative movement: of a side over the height of its profile, of a vertex or a
/// shell over the largest ball, of a ball's diameter over that of a fresh one (wea.9).
double largest_change_rate(const WornCase& of, const WornState& state, const WearRates& rates);

/// The state after `time` [s] of these rates (wea.10). None if a profile would cross itself.
std::optional<WornState> worn_after(const WornCase& of, const WornState& state,
                                    const WearRates& rates, double time);

}  // namespace mahlwerk::campaign

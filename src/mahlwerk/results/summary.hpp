// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/sensitivity.hpp"

// The numbers of a result that files, tables and pages show.
namespace mahlwerk::results {

/// One number of a result, under its name in summary.json.
struct Quantity {
  std::string name;
  double value = 0;
  double ci95 = 0;  ///< half-width over replicates; NaN with fewer than two
  std::string unit;
  std::string about;  ///< description
  /// Half-width of the 95 % confidence interval from the scatter over time within replicates; NaN
  /// where there is no time series.
  double ci95_time = std::numeric_limits<double>::quiet_NaN();

  /// The half-width to show: over replicates, else over time.
  double half_width() const { return std::isfinite(ci95) ? ci95 : ci95_time; }
};

/// The quantity of that name. Throws std::out_of_range if there is none.
const Quantity& named(const std::vector<Quantity>& list, std::string_view name);

/// The quantities of one kind of pair (docs/formats.md, "_pairs").
struct PairSummary {
  std::string one, other;  ///< "balls.1", "powder", "jar"
  std::vector<Quantity> quantities;
};

/// A subset of the replicates, and the quantities of summary.json over this subset.
struct State {
  std::vector<std::size_t> replicates;  ///< their numbers, from 1
  std::vector<Quantity> quantities;
};

/// Replicates that fall into two states by their dissipated power
/// (docs/theory/statistics.md, "Two states").
struct TwoStates {
  std::array<State, 2> states;  ///< the state of lower power first
  double p_value = 0;           ///< [1] p-value of the split (sta.7)

  /// [1] Share of the averaged replicates that are in the state.
  double share(const State& state) const;
};

/// What the charge of a lying, shaken jar does in one state of its motion (obs.20), with 95 %
/// half-widths over the replicates.
struct MotionStateSummary {
  std::string name;               ///< "circling"
  observe::Estimate share;        ///< [1] of the time
  int replicates = 0;             ///< that have the state
  double visit = 0;               ///< [s] mean time until it changes to another state, or the end
  observe::Estimate power;        ///< [W] dissipated
  observe::Estimate hit_rate;     ///< [1/s] of collisions above the threshold
  observe::Estimate hit_energy;   ///< [J] mean normal energy of these
  observe::Estimate turns;        ///< [1] turns of a ball round the jar's axis in a period
  observe::Estimate axial_ratio;  ///< [1] axial travel of a ball over that of the jar
};

/// What a part in the jar does to the balls (obs.22).
struct PartSummary {
  std::string name;
  std::vector<Quantity> quantities;
};

/// All numbers of an outcome.
struct Summary {
  std::vector<Quantity> quantities;  ///< in the order of summary.json (docs/formats.md)
  /// Values of the quantities in each replicate. The last quantities, which exist only for all
  /// replicates together, are left out.
  std::vector<std::vector<double>> by_replicate;
  std::vector<PairSummary> pairs;  ///< empty if there is only one kind of pair
  std::vector<PartSummary> parts;  ///< in the jar, in the order of the case
  std::optional<TwoStates> two_states;
  std::vector<MotionStateSummary> motion_states;  ///< the longest first
  std::optional<Sensitivity> sensitivity;         ///< to assumed values; only of a single run
  std::string regime, regime_reason;              ///< (results/quantities/regime.hpp)
};

}  // namespace mahlwerk::results

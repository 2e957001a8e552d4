// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/wear/worn_case.hpp"
#include "mahlwerk/campaign/wear/worn_state.hpp"
#include "mahlwerk/results/outcome.hpp"

// Wear over the time of operation: a run with the present shapes, a step of these along its wear,
// the next run (docs/theory/wear-heat.md).
namespace mahlwerk::campaign {

/// A number with its 95 % half-width.
struct WearNumber {
  double value = 0, ci95 = 0;
};

/// One run, and the step of the shapes that follows it.
struct WearStage {
  WornState state = {};  ///< of the run
  double duration = 0;   ///< [s] of operation with these shapes; 0 at the end
  WearNumber dissipated_power = {};
  WearNumber drawn_power = {};  ///< [W]
  WearNumber wear_rate_balls = {};
  WearNumber wear_rate_jar = {};
  WearNumber wear_rate_parts = {};                    ///< [kg/s]
  WearNumber contamination_rate = {};                 ///< [ug/g/h]; NaN without powder
  std::vector<double> heights = {};                   ///< [m] of the profiles
  std::vector<std::vector<double>> depth_rates = {};  ///< [m/s] of the sides of each
  std::vector<std::vector<double>> ball_rates = {};   ///< [m3/s] of each cohort's balls
  std::vector<double> spectrum_energies = {};         ///< [J] edges of bins
  std::vector<double> spectrum_rates = {};            ///< [1/s] collisions in them

  void serialize(Archive& archive);
};

/// When a profile is worn out.
struct WearLife {
  std::string profile;
  double time = 0;            ///< [s] of operation; NaN if its height does not fall
  bool extrapolated = false;  ///< beyond the time computed, at the last rate
};

struct WearEvolution {
  std::string title;
  cases::Wear wear;
  std::vector<std::string> profiles, sets;  ///< names, "balls.1"
  std::vector<double> fresh_heights;        ///< [m] of the profiles
  std::vector<double> fresh_sizes;          ///< [m] of the balls of the sets
  std::vector<WearStage> stages;            ///< the last one has duration 0 if it is complete
  std::vector<WearLife> lives;              ///< of the profiles
  Notices notices;
  bool complete = false;    ///< false if it was interrupted, or a run stopped
  std::string stop_reason;  ///< of a run that physics stopped, or of a shape that is worn away
};

struct WearOptions {
  RunOptions run;
  /// Takes the outcome of a stage, before its step is kept.
  std::function<void(std::size_t stage, const results::Outcome& outcome)> done;
  /// Takes what a later call continues from.
  std::function<void(std::string state)> keep;
  std::string kept;  ///< such a state, or empty
  /// Called before a run, with the time of operation [s].
  std::function<void(std::size_t stage, double time)> begin;
};

/// Follows the wear of a case with [wear] evolve over its time. Stages that `kept` holds are not
/// run again. Throws InputError for a case that cannot be run.
WearEvolution evolve_wear(const cases::Case& mill_case, const WearOptions& options);

}  // namespace mahlwerk::campaign

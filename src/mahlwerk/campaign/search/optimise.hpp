// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/campaign/search/gaussian_process.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"

// Bayesian optimisation of a noisy outcome over settings (docs/theory/optimum.md). A setting is a
// point with coordinates 0 to 1, one for each key's range. Texts are as in a case: "412 rpm".
namespace mahlwerk::campaign {

/// Bound of a further outcome.
struct Bound {
  bool below = true;
  double value = 0;
};

struct Goal {
  std::size_t keys = 1;  ///< 1 to 8
  bool maximise = true;
  std::vector<Bound> bounds = {};  ///< of the outcomes after the first
  int settings = 40;               ///< maximum number tried
  int replicates = 16;             ///< maximum per setting; at least 2
  std::uint64_t seed = 1;
  /// The point that is run for a requested one (whole numbers of balls); empty: the same point.
  std::function<DesignPoint(const DesignPoint&)> snap = {};
};

/// Requests replicates `first` to `first + count - 1` of a setting.
struct TrialRequest {
  std::size_t setting = 0;  ///< its index, from 0
  DesignPoint point;
  int first = 0, count = 0;
};
struct TrialResult {
  /// By replicate: the objective, then the bounded outcomes; NaN where an outcome does not exist.
  std::vector<std::vector<double>> replicates;
  std::string failure;   ///< why the setting cannot be run; empty: it can
  Notices notices = {};  ///< of the run
};
/// Returns results in the order of the requests; may run them concurrently. The same request always
/// gives the same result.
using Simulation = std::function<std::vector<TrialResult>(const std::vector<TrialRequest>&)>;

/// A setting that was tried.
struct Trial {
  DesignPoint point;
  std::vector<std::vector<double>> replicates;
  std::string failure;
  int round = 0;  ///< of its first request; 0: initial design
  std::vector<observe::Estimate> observed =
      {};  ///< means of its replicates, by outcome; half-widths need two (sta.1)
  observe::Estimate model = {};          ///< posterior of the objective
  double probability_feasible = 1;       ///< probability that it satisfies all bounds, by the model
  double probability_best = 0;           ///< probability that it is the best of those tried
  Notices notices = {};                  ///< of its runs, each code once
  std::vector<std::string> values = {};  ///< of the keys, as text
  std::vector<double> x = {};            ///< the same as numbers, in the keys' units

  /// Mean of an outcome over its replicates: the objective is the first; unknown if it has none.
  observe::Estimate outcome(std::size_t number) const;
  /// Whether its results are outside the validity of the engine that ran it.
  bool invalid() const;
};

/// Positions along a key as values of the case.
struct KeyTexts {
  std::string from = {}, to = {};             ///< the range
  std::string best = {}, model = {};          ///< at the best setting tried, at the model's optimum
  std::string low = {}, high = {};            ///< 95 % interval of the optimum's location
  std::string good_low = {}, good_high = {};  ///< this key varied alone: value within 2 %
};

/// Position of the optimum along a key.
struct KeyOptimum {
  double low = 0, high = 1;            ///< 95 % interval (opt.8)
  double good_low = 0, good_high = 1;  ///< within 2 % of the best, only this key varied
  bool flat = false;                   ///< the good range is more than half of the key's range
  bool at_low_end = false, at_high_end = false;  ///< position of the model's optimum
  /// Through the model's optimum, this key at 0, 1/40 ... 1.
  std::vector<observe::Estimate> slice = {};
  std::string key = {}, unit = {};  ///< unit of `x`; empty: a plain number
  bool logarithmic = false;
  std::vector<double> x = {};  ///< values of the key along the slice
  KeyTexts text = {};

  /// Location of the optimum as text: "12 Hz to 13 Hz", "at the end of its range".
  std::string range_text() const;
};

/// Limit of an outcome.
struct OptimumLimit {
  std::string quantity = {}, unit = {}, text = {};  ///< "below 1 mg/h"
  bool binds = false;  ///< the model's optimum without bounds violates it
};

/// The best setting, run with the recommended engine.
struct OptimumCheck {
  cases::EngineName engine = cases::EngineName::soft;
  observe::Estimate value = {};  ///< of the optimised quantity, by that engine
  int replicates = 0;
  std::string failure = {};  ///< reason why there is no value; empty: there is one
};

enum class StopReason {
  settings,   ///< the maximum number of settings was tried
  converged,  ///< no improvement beyond the noise is expected (opt.7)
  failed      ///< no setting gave an outcome
};

/// An outcome that settings are judged by.
struct SearchOutcome {
  std::string name = {}, unit = {}, about = {};  ///< as in summary.json
};

struct Optimum {
  std::string title = {}, case_file = {};
  SearchOutcome outcome = {};  ///< what is optimised
  bool maximise = true;
  std::vector<Trial> trials = {};
  std::optional<std::size_t> best =
      std::nullopt;                    ///< index of the best, likely feasible trial; empty: none
  DesignPoint model_point = {};        ///< optimum of the model
  observe::Estimate model_value = {};  ///< a prediction: it was not run
  std::vector<KeyOptimum> keys = {};
  std::vector<OptimumLimit> limits = {};  ///< by bound
  double expected_gain = 0;  ///< acquisition of one more setting, at the end (opt.5, opt.6)
  double expected_loss = 0;  ///< of choosing `best` if another trial is better
  int failed = 0, rounds = 0;
  StopReason stop_reason = StopReason::settings;
  results::NoticeCounts notices = {};                ///< of the trials
  std::optional<OptimumCheck> check = std::nullopt;  ///< if the event engine ran the best

  int runs() const;  ///< total number of replicates
  /// Whether the best setting tried is distinguished from all others, by valid runs.
  bool certain() const;
  /// Whether check and search differ by more than their intervals.
  bool disagrees() const;
};

/// Settings of a batch: a constant, so that the result does not depend on the number of cores.
constexpr int batch = 4;

/// Finds the best setting: a Sobol design first, then batches by the acquisition function of a
/// Gaussian process, then replicates of the candidates until the best is determined. Deterministic.
/// Throws std::invalid_argument if the goal is out of range.
Optimum optimise(const Goal& goal, const Simulation& simulation);

}  // namespace mahlwerk::campaign

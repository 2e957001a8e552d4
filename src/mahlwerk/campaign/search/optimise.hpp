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

// The settings for which a noisy outcome is best (docs/theory/optimum.md). Settings are points, 0
// to 1 in each key's range.
namespace mahlwerk::campaign {

/// A further outcome must stay below, or above, a value.
struct Bound {
  bool below = true;
  double value = 0;
};

struct Goal {
  std::size_t keys = 1;  ///< 1 to 8
  bool maximise = true;
  std::vector<Bound> bounds = {};  ///< of the outcomes that follow the first
  int settings = 40;               ///< tried at most
  int replicates = 16;             ///< of one setting at most; at least 2
  std::uint64_t seed = 1;
  /// The point that is really run for one asked for (whole numbers of balls); empty: itself.
  std::function<DesignPoint(const DesignPoint&)> snap = {};
};

/// Replicates `first` to `first + count - 1` of a setting, asked for.
struct TrialRequest {
  std::size_t setting = 0;  ///< number of it, from 0
  DesignPoint point;
  int first = 0, count = 0;
};
struct TrialResult {
  /// By replicate: what is to be best, then what is bounded; NaN where it does not exist.
  std::vector<std::vector<double>> replicates;
  std::string failure;   ///< why the setting cannot be run; empty: it can
  Notices notices = {};  ///< of the run
};
/// Answers in the order asked; may work on all at once. The same question has the same answer.
using Simulation = std::function<std::vector<TrialResult>(const std::vector<TrialRequest>&)>;

struct MeanCi95 {
  double mean = 0, ci95 = 0;
};

/// A setting that was tried.
struct Trial {
  DesignPoint point;
  std::vector<std::vector<double>> replicates;
  std::string failure;
  int round = 0;  ///< in which it was tried first; 0: of the start
  std::vector<MeanCi95> observed =
      {};                           ///< means of its replicates, by outcome; of two or more (sta.1)
  MeanCi95 model = {};              ///< what the model says, all settings together
  double probability_feasible = 1;  ///< how likely it keeps all bounds, by the model
  double probability_best = 0;      ///< how likely it is the best of those tried
  Notices notices = {};             ///< of its runs, each code once

  /// Its numbers lie outside the validity of the engine that ran it.
  bool invalid() const;
};

/// Where along a key the optimum lies.
struct KeyOptimum {
  double low = 0, high = 1;                      ///< with 95 % (opt.8)
  double good_low = 0, good_high = 1;            ///< this key alone moved: within 2 % of the best
  bool flat = false;                             ///< that is more than half of the range
  bool at_low_end = false, at_high_end = false;  ///< the model's best lies there
  std::vector<MeanCi95> slice;  ///< the model through its best, this key at 0, 1/40 ... 1
};

enum class StopReason {
  settings,   ///< as many were tried as allowed
  converged,  ///< nothing better is expected beyond the noise (opt.7)
  failed      ///< no setting gave an outcome
};

struct Optimum {
  std::vector<Trial> trials;
  std::optional<std::size_t> best;  ///< of those tried and likely allowed; none: there is none
  DesignPoint model_point;          ///< where the model is best
  MeanCi95 model_value;             ///< a prediction: it was not run
  std::vector<KeyOptimum> keys;
  std::vector<bool> binds;   ///< by bound: without it the model's best would lie elsewhere
  double expected_gain = 0;  ///< of one more setting, when it ended (opt.5)
  double expected_loss = 0;  ///< that another setting tried is better than `best`
  int failed = 0, rounds = 0;
  StopReason stop_reason = StopReason::settings;
};

/// So many settings are tried at once, however many cores there are, so that the answer does not
/// depend on them.
constexpr int batch = 4;

/// Looks for the best setting: spread over the ranges first, then where a Gaussian process expects
/// most, replicates where it must be told what is best. The same for the same input. Throws
/// std::invalid_argument for a goal out of its ranges.
Optimum optimise(const Goal& goal, const Simulation& simulation);

}  // namespace mahlwerk::campaign

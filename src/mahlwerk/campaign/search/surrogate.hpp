// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/campaign/search/optimise.hpp"

// What settings tried say of those not tried (docs/theory/optimum.md).
namespace mahlwerk::campaign {

/// E[max(0, f - best)] of a normal guess of f (opt.5).
double expected_improvement(const Posterior& guess, double best);

/// One outcome: a Gaussian process of (value - centre)/unit.
struct OutcomeModel {
  GaussianProcess process;
  double centre = 0, scale = 1;
  double noise = 0;  ///< variance of the mean of two replicates, in units squared

  Posterior at(const DesignPoint& point) const;  ///< of the value itself
};

/// Which setting tried is the best of those.
struct BestProbabilities {
  std::vector<double> by_trial;  ///< by setting
  /// By how much the best allowed one is expected to be better than `best`; 0 without that.
  double expected_loss = 0;
};

/// Models of all outcomes, and of whether a setting can be run. Higher is better throughout: what
/// is minimised has its sign turned.
class Surrogate {
 public:
  /// At least one setting has outcomes.
  Surrogate(const Goal& goal, const std::vector<Trial>& trials);

  const OutcomeModel& objective() const { return models_.front(); }
  const OutcomeModel& constraint(std::size_t bound) const { return models_[bound + 1]; }
  Posterior objective_at(const DesignPoint& point) const { return models_.front().at(point); }
  /// How likely a setting can be run and keeps all bounds.
  double probability_feasible(const DesignPoint& point) const;
  double probability_runnable(const DesignPoint& point) const;

  /// The number of the best setting tried: by mean, of those rather allowed than not; nothing if
  /// there is none.
  std::optional<std::size_t> best() const;
  BestProbabilities best_probabilities() const;

  /// Expected improvement on the best, times how likely it is allowed and the share of news in what
  /// would be seen (opt.6); without a best only how likely it is allowed.
  double acquisition(const DesignPoint& point) const;
  /// The setting tried from which a point should differ by less than half the noise of two
  /// replicates; nothing if there is none.
  std::optional<std::size_t> indistinguishable_trial(const DesignPoint& point) const;
  /// Where that is highest.
  DesignPoint highest_acquisition() const;
  /// Where the mean is highest among what is rather allowed; `bounds` false: of what can be run.
  DesignPoint highest_mean(bool bounds = true) const;
  /// As if a point had been tried, with what is expected; a doubtful one cannot be run.
  void add_fantasy(const DesignPoint& point);

  /// By draws of models and of functions: where the best allowed setting may be (opt.8).
  std::vector<DesignPoint> optimum_samples(int kernels, int paths) const;

 private:
  const Goal& goal_;
  const std::vector<Trial>& trials_;
  std::vector<std::size_t> successful_;  // numbers of those with outcomes
  std::vector<OutcomeModel> models_;
  std::optional<GaussianProcess> success_;  // 0 where settings run, -2 where not, about a mean of 1
  std::optional<std::size_t> best_;
  double best_mean_ = 0;
};

}  // namespace mahlwerk::campaign

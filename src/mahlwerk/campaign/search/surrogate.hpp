// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/campaign/search/outcome_model.hpp"

// Surrogate model: outcomes of settings not tried, from those tried (docs/theory/optimum.md).
namespace mahlwerk::campaign {

/// Expected improvement E[max(0, f - best)] for a normal posterior of f (opt.5).
double expected_improvement(const Posterior& guess, double best);

/// Probability of each setting tried to be the best of them.
struct BestProbabilities {
  std::vector<double> by_trial;  ///< by index of the trial
  /// Expected difference between the best feasible setting and `best`; 0 without `best`.
  double expected_loss = 0;
};

/// Models of all outcomes, and of whether a setting can be run. Higher is better throughout: the
/// sign of a minimised outcome is reversed.
class Surrogate {
 public:
  /// At least one setting must have outcomes.
  Surrogate(const Goal& goal, const std::vector<Trial>& trials);

  const OutcomeModel& objective() const { return models_.front(); }
  const OutcomeModel& constraint(std::size_t bound) const { return models_[bound + 1]; }
  Posterior objective_at(const DesignPoint& point) const { return models_.front().at(point); }
  /// Probability that a setting can be run and satisfies all bounds.
  double probability_feasible(const DesignPoint& point) const;
  double probability_runnable(const DesignPoint& point) const;

  /// Index of the best setting tried: the highest mean among those that satisfy all bounds with a
  /// probability of at least 0.5; empty if there is none.
  std::optional<std::size_t> best() const;
  BestProbabilities best_probabilities() const;

  /// Acquisition function: expected improvement times the probability of feasibility and the noise
  /// factor (opt.6); without a best setting only that probability.
  double acquisition(const DesignPoint& point) const;
  /// The nearest setting tried whose expected difference from `point` is below half the noise of
  /// two replicates; empty if there is none.
  std::optional<std::size_t> indistinguishable_trial(const DesignPoint& point) const;
  /// The point of the highest acquisition.
  DesignPoint highest_acquisition() const;
  /// The point of the highest mean among feasible ones; with `bounds` false, among those that can
  /// be run.
  DesignPoint highest_mean(bool bounds = true) const;
  /// Adds a fantasy observation of the posterior mean at `point`; a point that is unlikely to run
  /// counts as failed.
  void add_fantasy(const DesignPoint& point);

  /// Samples of the position of the best feasible setting, from sampled kernels and sample paths
  /// (opt.8).
  std::vector<DesignPoint> optimum_samples(int kernels, int paths) const;

 private:
  const Goal& goal_;
  const std::vector<Trial>& trials_;
  std::vector<std::size_t> successful_;  // indices of trials with outcomes
  std::vector<OutcomeModel> models_;
  std::optional<GaussianProcess> success_;  // of y - 1, where y = 1 if a setting ran, -1 if not
  std::optional<std::size_t> best_;
  double best_mean_ = 0;
};

}  // namespace mahlwerk::campaign

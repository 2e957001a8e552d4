// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/optimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "mahlwerk/campaign/search/surrogate.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double normal95 = 1.959963984540054;
constexpr int slice_steps = 40;

observe::Estimate observed_mean(const Trial& setting, std::size_t outcome) {
  std::vector<double> values;
  for (const auto& replicate : setting.replicates)
    if (std::isfinite(replicate[outcome])) values.push_back(replicate[outcome]);
  return observe::estimate(values);
}

/// The model's prediction, in the sign of the outcome itself.
observe::Estimate prediction(const Goal& goal, const Surrogate& model, const DesignPoint& point) {
  const Posterior b = model.objective_at(point);
  return {goal.maximise ? b.mean : -b.mean, normal95 * b.deviation};
}

void describe_trials(const Goal& goal, const Surrogate& model, Optimum& found) {
  const BestProbabilities probabilities = model.best_probabilities();
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    Trial& t = found.trials[i];
    for (std::size_t outcome = 0; outcome <= goal.bounds.size(); ++outcome)
      t.observed.push_back(observed_mean(t, outcome));
    t.model = prediction(goal, model, t.point);
    t.probability_feasible = t.failure.empty()
                                 ? model.probability_feasible(t.point) /
                                       std::max(1e-9, model.probability_runnable(t.point))
                                 : 0;
    t.probability_best = probabilities.by_trial[i];
  }
  found.expected_loss = probabilities.expected_loss;
}

/// The 2.5 and 97.5 % quantiles.
std::pair<double, double> middle(std::vector<double> values) {
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * last + 0.5)];
  };
  return {at(0.025), at(0.975)};
}

/// The model along one key through its optimum, and the range of good values.
void slice(const Goal& goal, const Surrogate& model, const Optimum& found, std::size_t key,
           KeyOptimum& made) {
  constexpr double good = 0.02, edge = 5e-3;
  constexpr int steps = 400;
  const double best = model.objective_at(found.model_point).mean;
  const double low_enough = best - good * std::abs(best);
  const auto at = [&](double position) {
    DesignPoint x = found.model_point;
    x[key] = position;
    return x;
  };
  const double here = found.model_point[key];
  const auto reach = [&](double end) {
    double last = here;
    for (int i = 1; i <= steps; ++i) {
      const double position = std::lerp(here, end, static_cast<double>(i) / steps);
      if (model.objective_at(at(position)).mean < low_enough ||
          model.probability_feasible(at(position)) < 0.5)
        break;
      last = position;
    }
    return last;
  };
  made.good_low = reach(0);
  made.good_high = reach(1);
  made.flat = made.good_high - made.good_low > 0.5;
  made.at_low_end = here < edge;
  made.at_high_end = here > 1 - edge;
  for (int i = 0; i <= slice_steps; ++i)
    made.slice.push_back(prediction(goal, model, at(static_cast<double>(i) / slice_steps)));
}

}  // namespace

void conclude(const Goal& goal, Optimum& found) {
  constexpr int kernels = 10, paths = 20;
  found.failed = static_cast<int>(
      std::ranges::count_if(found.trials, [](const Trial& t) { return !t.failure.empty(); }));
  found.keys.assign(goal.keys, {});
  found.limits.assign(goal.bounds.size(), {});
  if (found.failed == static_cast<int>(found.trials.size())) {
    found.stop_reason = StopReason::failed;
    return;
  }
  const Surrogate model(goal, found.trials);
  found.best = model.best();
  describe_trials(goal, model, found);
  found.model_point = model.highest_mean();
  found.model_value = prediction(goal, model, found.model_point);
  const DesignPoint free = model.highest_mean(false);
  for (std::size_t b = 0; b < goal.bounds.size(); ++b) {
    const double value = model.constraint(b).at(free).mean;
    found.limits[b].binds =
        goal.bounds[b].below ? value > goal.bounds[b].value : value < goal.bounds[b].value;
  }
  const std::vector<DesignPoint> drawn = model.optimum_samples(kernels, paths);
  for (std::size_t key = 0; key < goal.keys; ++key) {
    std::vector<double> points;
    for (const DesignPoint& point : drawn) points.push_back(point[key]);
    KeyOptimum& made = found.keys[key];
    std::tie(made.low, made.high) = middle(std::move(points));  // (opt.8)
    slice(goal, model, found, key, made);
  }
}

}  // namespace mahlwerk::campaign

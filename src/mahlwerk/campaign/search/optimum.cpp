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

Guess seen(const Tried& setting, std::size_t outcome) {
  std::vector<double> values;
  for (const auto& replicate : setting.replicates)
    if (std::isfinite(replicate[outcome])) values.push_back(replicate[outcome]);
  if (values.empty())
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const observe::Estimate e = observe::estimate(values);
  return {e.mean, e.ci95};
}

/// In the sign of the outcome itself.
Guess guess(const Goal& goal, const Surrogate& model, const Place& place) {
  const Belief b = model.better(place);
  return {goal.maximise ? b.mean : -b.mean, normal95 * b.deviation};
}

void describe_tried(const Goal& goal, const Surrogate& model, Optimum& found) {
  const Chances chance = model.chances();
  for (std::size_t i = 0; i < found.tried.size(); ++i) {
    Tried& t = found.tried[i];
    for (std::size_t outcome = 0; outcome <= goal.bounds.size(); ++outcome)
      t.seen.push_back(seen(t, outcome));
    t.model = guess(goal, model, t.place);
    t.allowed =
        t.failure.empty() ? model.allowed(t.place) / std::max(1e-9, model.runs(t.place)) : 0;
    t.chance = chance.of[i];
  }
  found.expected_loss = chance.loss;
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

/// The model through its best place, one key moved alone, and how far that may be.
void slice(const Goal& goal, const Surrogate& model, const Optimum& found, std::size_t key,
           KeyOptimum& made) {
  constexpr double good = 0.02, edge = 5e-3;
  constexpr int steps = 400;
  const double best = model.better(found.model_place).mean;
  const double low_enough = best - good * std::abs(best);
  const auto at = [&](double place) {
    Place x = found.model_place;
    x[key] = place;
    return x;
  };
  const double here = found.model_place[key];
  const auto reach = [&](double end) {
    double last = here;
    for (int i = 1; i <= steps; ++i) {
      const double place = std::lerp(here, end, static_cast<double>(i) / steps);
      if (model.better(at(place)).mean < low_enough || model.allowed(at(place)) < 0.5) break;
      last = place;
    }
    return last;
  };
  made.good_low = reach(0);
  made.good_high = reach(1);
  made.flat = made.good_high - made.good_low > 0.5;
  made.at_low_end = here < edge;
  made.at_high_end = here > 1 - edge;
  for (int i = 0; i <= slice_steps; ++i)
    made.slice.push_back(guess(goal, model, at(static_cast<double>(i) / slice_steps)));
}

}  // namespace

void conclude(const Goal& goal, Optimum& found) {
  constexpr int kernels = 10, paths = 20;
  found.failed = static_cast<int>(
      std::ranges::count_if(found.tried, [](const Tried& t) { return !t.failure.empty(); }));
  found.keys.assign(goal.keys, {});
  found.binds.assign(goal.bounds.size(), false);
  if (found.failed == static_cast<int>(found.tried.size())) {
    found.ended = Ended::failed;
    return;
  }
  const Surrogate model(goal, found.tried);
  found.best = model.best();
  describe_tried(goal, model, found);
  found.model_place = model.highest_mean();
  found.model_value = guess(goal, model, found.model_place);
  const Place free = model.highest_mean(false);
  for (std::size_t b = 0; b < goal.bounds.size(); ++b) {
    const double value = model.bounded(b).at(free).mean;
    found.binds[b] =
        goal.bounds[b].below ? value > goal.bounds[b].value : value < goal.bounds[b].value;
  }
  const std::vector<Place> drawn = model.draws_of_best(kernels, paths);
  for (std::size_t key = 0; key < goal.keys; ++key) {
    std::vector<double> places;
    for (const Place& place : drawn) places.push_back(place[key]);
    KeyOptimum& made = found.keys[key];
    std::tie(made.low, made.high) = middle(std::move(places));  // (opt.8)
    slice(goal, model, found, key, made);
  }
}

}  // namespace mahlwerk::campaign

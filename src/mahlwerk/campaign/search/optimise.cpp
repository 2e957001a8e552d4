// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/optimise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "mahlwerk/campaign/points/designs.hpp"
#include "mahlwerk/campaign/search/optimum.hpp"
#include "mahlwerk/campaign/search/surrogate.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int first_replicates = 2;
constexpr double best_determined = 0.95, still_possible = 0.05, small_loss = 0.01;
constexpr double same_point = 1e-4;

/// Runs requested settings, and keeps their results.
class Trials {
 public:
  Trials(const Goal& goal, const Simulation& simulation) : goal_(goal), simulation_(simulation) {}

  std::vector<Trial>& all() { return trials_; }
  int left() const { return goal_.settings - static_cast<int>(trials_.size() + fresh_); }
  bool ran() const {
    return std::ranges::any_of(trials_, [](const Trial& t) { return t.failure.empty(); });
  }

  /// Requests a point, or more replicates of an existing setting; false if neither is possible.
  bool ask(const DesignPoint& wanted) {
    const DesignPoint point = goal_.snap ? goal_.snap(wanted) : wanted;
    const auto same = [&](const DesignPoint& other) {
      for (std::size_t i = 0; i < point.size(); ++i)
        if (std::abs(point[i] - other[i]) > same_point) return false;
      return true;
    };
    for (std::size_t i = 0; i < trials_.size(); ++i)
      if (same(trials_[i].point)) return ask_more(i);
    for (const TrialRequest& one : requests_)
      if (same(one.point)) return false;
    if (left() <= 0) return false;
    requests_.push_back({trials_.size() + fresh_, point, 0, first_replicates});
    ++fresh_;
    return true;
  }

  /// Requests as many replicates of a setting as it has; false if it has all.
  bool ask_more(std::size_t setting) {
    const Trial& t = trials_[setting];
    const int have = static_cast<int>(t.replicates.size());
    const int more = std::min(have, goal_.replicates - have);
    if (!t.failure.empty() || more <= 0) return false;
    for (const TrialRequest& one : requests_)
      if (one.setting == setting) return false;
    requests_.push_back({setting, t.point, have, more});
    return true;
  }

  /// Runs all requests; false if there is none.
  bool run(int round) {
    if (requests_.empty()) return false;
    const std::vector<TrialResult> answers = simulation_(requests_);
    if (answers.size() != requests_.size())
      throw std::logic_error("a simulation returned a wrong number of results");
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const TrialRequest& one = requests_[i];
      if (one.setting >= trials_.size())
        trials_.push_back({.point = one.point, .replicates = {}, .failure = {}, .round = round});
      keep(trials_[one.setting], answers[i]);
    }
    requests_.clear();
    fresh_ = 0;
    return true;
  }

 private:
  void keep(Trial& setting, const TrialResult& result) {
    setting.replicates.insert(setting.replicates.end(), result.replicates.begin(),
                              result.replicates.end());
    setting.failure = result.failure;
    results::merge(setting.notices, result.notices);
    for (std::size_t outcome = 0; outcome <= goal_.bounds.size(); ++outcome)
      if (setting.failure.empty() && std::ranges::none_of(setting.replicates, [&](const auto& r) {
            return std::isfinite(r[outcome]);
          }))
        setting.failure = "no replicate gave a value of every requested quantity";
  }

  const Goal& goal_;
  const Simulation& simulation_;
  std::vector<Trial> trials_;
  std::vector<TrialRequest> requests_;
  std::size_t fresh_ = 0;  // new settings among the requests
};

/// Settings that may still be the best, by decreasing probability.
std::vector<std::size_t> rivals(const std::vector<double>& chance) {
  std::vector<std::size_t> order(chance.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return chance[a] > chance[b]; });
  std::erase_if(order, [&](std::size_t i) { return chance[i] < still_possible; });
  return order;
}

/// Expected improvement below which the search ends (opt.7).
double improvement_threshold(const Surrogate& model, const std::vector<Trial>& trials) {
  const std::optional<std::size_t> best = model.best();
  if (!best) return 0;
  return std::max(0.1 * model.objective_at(trials[*best].point).deviation,
                  1e-4 * model.objective().scale);
}

/// Requests a batch: settings of the highest acquisition, the last one at the model's highest mean,
/// and replicates of the two settings most likely to be the best. False if nothing is requested, or
/// nothing is worth a run.
bool ask_round(Trials& trials, const Goal& goal, Optimum& found) {
  Surrogate model(goal, trials.all());
  const DesignPoint first = model.highest_acquisition();
  found.expected_gain = model.acquisition(first);
  if (model.best() && found.expected_gain < improvement_threshold(model, trials.all())) {
    return false;
  }
  const std::vector<std::size_t> close = rivals(model.best_probabilities().by_trial);
  bool any = false;
  for (int slot = 0; slot < batch; ++slot) {
    const bool refine = slot == batch - 1 && model.best();
    const DesignPoint point = slot == 0 ? first
                              : refine  ? model.highest_mean()
                                        : model.highest_acquisition();
    const std::optional<std::size_t> same = model.indistinguishable_trial(point);
    any = (same ? trials.ask_more(*same) : trials.ask(point)) || any;
    model.add_fantasy(point);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(2, close.size()) && close.size() > 1; ++i)
    any = trials.ask_more(close[i]) || any;
  return any;
}

/// Runs replicates of settings that may be the best until one is determined, the expected loss is
/// small, or all have their replicates (opt.10).
void decide(Trials& trials, const Goal& goal, int& round) {
  for (bool more = true; more;) {
    const Surrogate model(goal, trials.all());
    const BestProbabilities probabilities = model.best_probabilities();
    if (*std::ranges::max_element(probabilities.by_trial) >= best_determined ||
        (model.best() && probabilities.expected_loss < small_loss * model.objective().scale))
      return;
    more = false;
    int asked = 0;
    for (const std::size_t i : rivals(probabilities.by_trial))
      if (asked < batch && trials.ask_more(i)) ++asked;
    if (asked > 0) more = trials.run(++round);
  }
}

void check(const Goal& goal) {
  constexpr std::size_t max_keys = 8;
  if (goal.keys < 1 || goal.keys > max_keys)
    throw std::invalid_argument("an optimisation takes 1 to 8 keys");
  if (goal.settings < 1 || goal.replicates < first_replicates)
    throw std::invalid_argument(
        "an optimisation takes at least one setting, and two replicates of each");
}

}  // namespace

Optimum optimise(const Goal& goal, const Simulation& simulation) {
  check(goal);
  Optimum found{.maximise = goal.maximise};
  Trials trials(goal, simulation);
  for (const DesignPoint& point : sobol_points(goal.keys, 4 + 2 * goal.keys)) trials.ask(point);
  trials.run(0);
  int round = 0;
  while (trials.left() > 0) {
    if (!trials.ran()) {  // none ran: try other points
      const DesignMatrix more = sobol_points(goal.keys, trials.all().size() + batch);
      bool any = false;
      for (std::size_t i = trials.all().size(); i < more.size(); ++i)
        any = trials.ask(more[i]) || any;
      if (!any || !trials.run(++round)) break;
      continue;
    }
    if (!ask_round(trials, goal, found)) {
      found.stop_reason = StopReason::converged;
      break;
    }
    trials.run(++round);
  }
  if (trials.ran()) decide(trials, goal, round);
  found.trials = std::move(trials.all());
  found.rounds = round;
  conclude(goal, found);
  return found;
}

}  // namespace mahlwerk::campaign

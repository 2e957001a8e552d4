// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/campaign/points/designs.hpp"
#include "mahlwerk/campaign/search/maximum.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::uint32_t chance_stream = 0x50000000, kernel_stream = 0x51000000,
                        path_stream = 0x52000000;

double objective_sign(const Goal& goal, std::size_t outcome) {
  return outcome == 0 && !goal.maximise ? -1 : 1;
}

/// Samples of an outcome at the settings that ran.
OutcomeModel model_of(const std::vector<Trial>& trials, std::size_t outcome, double sign) {
  std::vector<SettingSample> samples;
  for (const Trial& trial : trials) {
    std::vector<double> values;
    for (const auto& replicate : trial.replicates) values.push_back(sign * replicate[outcome]);
    SettingSample one = sample_of(trial.point, values);
    if (one.count > 0 && trial.failure.empty()) samples.push_back(std::move(one));
  }
  return outcome_model(samples);
}

std::optional<GaussianProcess> success_of(const Goal& goal, const std::vector<Trial>& trials) {
  if (std::ranges::all_of(trials, [](const Trial& t) { return t.failure.empty(); }))
    return std::nullopt;
  Kernel kernel{.amplitude = 1, .length_scales = {}, .constant = 0};
  kernel.length_scales.assign(goal.keys, 0.25 * std::sqrt(static_cast<double>(goal.keys)));
  std::vector<Observation> observations;
  for (const Trial& t : trials)
    observations.push_back(
        {.point = t.point, .value = t.failure.empty() ? 0.0 : -2.0, .variance = 0.01});
  return GaussianProcess(std::move(kernel), std::move(observations));
}

double probability_satisfied(const Bound& bound, const Posterior& guess) {
  const double room = bound.below ? bound.value - guess.mean : guess.mean - bound.value;
  return guess.deviation > 0 ? normal_cdf(room / guess.deviation) : (room >= 0 ? 1 : 0);
}

/// By how much a value violates a bound; 0 if it does not.
double violation(const Bound& bound, double value) {
  return std::max(0.0, bound.below ? value - bound.value : bound.value - value);
}

int global_budget(std::size_t keys) {
  return 200 * static_cast<int>(keys);
}

}  // namespace

double expected_improvement(const Posterior& guess, double best) {
  const double gain = guess.mean - best;
  if (!(guess.deviation > 0)) return std::max(0.0, gain);
  const double z = gain / guess.deviation;
  const double density = math::exp(-z * z / 2) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
  return std::max(0.0, gain * normal_cdf(z) + guess.deviation * density);  // (opt.5)
}

Surrogate::Surrogate(const Goal& goal, const std::vector<Trial>& trials)
    : goal_(goal), trials_(trials), success_(success_of(goal, trials)) {
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (trials[i].failure.empty()) successful_.push_back(i);
  for (std::size_t outcome = 0; outcome <= goal.bounds.size(); ++outcome)
    models_.push_back(model_of(trials, outcome, objective_sign(goal, outcome)));
  best_ = best();
  if (best_) best_mean_ = objective_at(trials_[*best_].point).mean;
}

double Surrogate::probability_runnable(const DesignPoint& point) const {
  if (!success_) return 1;
  const Posterior guess = success_->at(point);
  return normal_cdf((1 + guess.mean) / std::max(1e-9, guess.deviation));
}

double Surrogate::probability_feasible(const DesignPoint& point) const {
  double share = probability_runnable(point);
  for (std::size_t i = 0; i < goal_.bounds.size(); ++i)
    share *= probability_satisfied(goal_.bounds[i], constraint(i).at(point));
  return share;
}

std::optional<std::size_t> Surrogate::best() const {
  std::optional<std::size_t> found;
  double highest_one = -std::numeric_limits<double>::infinity();
  for (const std::size_t i : successful_) {
    double kept = 1;  // the trial ran
    for (std::size_t b = 0; b < goal_.bounds.size(); ++b)
      kept *= probability_satisfied(goal_.bounds[b], constraint(b).at(trials_[i].point));
    const double mean = objective_at(trials_[i].point).mean;
    if (kept < 0.5 || mean <= highest_one) continue;
    highest_one = mean;
    found = i;
  }
  return found;
}

BestProbabilities Surrogate::best_probabilities() const {
  constexpr int count = 1000;
  std::vector<DesignPoint> points;
  for (const std::size_t i : successful_) points.push_back(trials_[i].point);
  std::vector<std::vector<std::vector<double>>> drawn;  // by outcome
  for (std::size_t outcome = 0; outcome < models_.size(); ++outcome) {
    Random random(goal_.seed, chance_stream + static_cast<std::uint32_t>(outcome));
    drawn.push_back(models_[outcome].process.joint_samples(points, count, random));
  }
  const auto kept = [&](std::size_t draw, std::size_t k) {
    for (std::size_t b = 0; b < goal_.bounds.size(); ++b) {
      const OutcomeModel& model = constraint(b);
      if (violation(goal_.bounds[b], model.centre + model.scale * drawn[b + 1][draw][k]) > 0)
        return false;
    }
    return true;
  };
  BestProbabilities made{.by_trial = std::vector<double>(trials_.size(), 0), .expected_loss = 0};
  for (std::size_t draw = 0; draw < count; ++draw) {
    const std::vector<double>& values = drawn.front()[draw];
    std::optional<std::size_t> top;
    double chosen = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < successful_.size(); ++k) {
      if (successful_[k] == best_) chosen = values[k];
      if (kept(draw, k) && (!top || values[k] > values[*top])) top = k;
    }
    if (!top) continue;
    made.by_trial[successful_[*top]] += 1.0 / count;
    if (best_)
      made.expected_loss += std::max(0.0, values[*top] - chosen) * objective().scale / count;
  }
  return made;
}

double Surrogate::acquisition(const DesignPoint& point) const {
  const double share = probability_feasible(point);
  if (!best_) return share;
  const Posterior guess = objective_at(point);
  const double noise = objective().scale * std::sqrt(objective().noise);
  const double whole = math::hypot(guess.deviation, noise);
  const double news = whole > 0 ? 1 - noise / whole : 0;  // (opt.6)
  return share * news * expected_improvement(guess, best_mean_);
}

std::optional<std::size_t> Surrogate::indistinguishable_trial(const DesignPoint& point) const {
  const OutcomeModel& model = objective();
  const Kernel& kernel = model.process.kernel();
  const double own = covariance(kernel, point, point);
  std::optional<std::size_t> nearest;
  double least = 0.25 * model.noise;  // (opt.12)
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    const double apart = 2 * (own - covariance(kernel, point, trials_[i].point));
    if (apart > least) continue;
    least = apart;
    nearest = i;
  }
  return nearest;
}

DesignPoint Surrogate::highest_acquisition() const {
  std::vector<DesignPoint> starts;
  if (best_) starts.push_back(trials_[*best_].point);
  return find_maximum([this](const DesignPoint& x) { return acquisition(x); },
                      DesignPoint(goal_.keys, 0.0), DesignPoint(goal_.keys, 1.0), starts,
                      {.global = global_budget(goal_.keys), .local = global_budget(goal_.keys) / 4})
      .point;
}

DesignPoint Surrogate::highest_mean(bool bounds) const {
  const double far = 1e3 * objective().scale;  // penalty: any feasible point is better
  const auto value = [&](const DesignPoint& x) {
    return objective_at(x).mean -
           far * std::max(0.0, 0.5 - (bounds ? probability_feasible(x) : probability_runnable(x)));
  };
  std::vector<DesignPoint> starts;
  if (best_) starts.push_back(trials_[*best_].point);
  return find_maximum(value, DesignPoint(goal_.keys, 0.0), DesignPoint(goal_.keys, 1.0), starts,
                      {.global = global_budget(goal_.keys), .local = global_budget(goal_.keys) / 2})
      .point;
}

void Surrogate::add_fantasy(const DesignPoint& point) {
  constexpr double likely = 0.9;
  for (OutcomeModel& model : models_)
    model.process = model.process.with_fantasy(point, model.noise);
  if (success_ && probability_runnable(point) <
                      likely) {  // pessimistic, so that a batch does not fail as a whole
    std::vector<Observation> observations = success_->observations();
    observations.push_back({.point = point, .value = -2, .variance = 0.01});
    success_ = GaussianProcess(success_->kernel(), std::move(observations));
  }
}

std::vector<DesignPoint> Surrogate::optimum_samples(int kernels, int paths) const {
  std::vector<std::vector<Kernel>> drawn;  // by outcome
  for (std::size_t outcome = 0; outcome < models_.size(); ++outcome) {
    Random random(goal_.seed, kernel_stream + static_cast<std::uint32_t>(outcome));
    const GaussianProcess& process = models_[outcome].process;
    drawn.push_back(sample_kernels(process.observations(), process.kernel(), kernels, random));
  }
  DesignMatrix starts = sobol_points(goal_.keys, 64 * goal_.keys);
  for (const std::size_t i : successful_) starts.push_back(trials_[i].point);
  starts.push_back(highest_mean());

  std::vector<DesignPoint> found;
  for (int k = 0; k < kernels; ++k) {
    std::vector<GaussianProcess> processes;
    for (std::size_t outcome = 0; outcome < models_.size(); ++outcome)
      processes.emplace_back(drawn[outcome][static_cast<std::size_t>(k)],
                             models_[outcome].process.observations());
    for (int p = 0; p < paths; ++p) {
      Random random(goal_.seed, path_stream + static_cast<std::uint32_t>(k * paths + p));
      std::vector<SamplePath> path;
      for (const GaussianProcess& process : processes) path.push_back(process.sample_path(random));
      const auto value = [&](const DesignPoint& x) {
        double broken = std::max(0.0, 0.5 - probability_runnable(x));
        for (std::size_t b = 0; b < goal_.bounds.size(); ++b) {
          const OutcomeModel& model = constraint(b);
          broken +=
              violation(goal_.bounds[b], model.centre + model.scale * path[b + 1](x)) / model.scale;
        }
        return broken > 0 ? -1e3 * (1 + broken) : path.front()(x);
      };
      const Maximum start =
          find_maximum(value, DesignPoint(goal_.keys, 0.0), DesignPoint(goal_.keys, 1.0), starts,
                       {.global = 0, .local = 0});
      found.push_back(find_maximum(value, DesignPoint(goal_.keys, 0.0),
                                   DesignPoint(goal_.keys, 1.0), {start.point},
                                   {.global = 0, .local = 40 * static_cast<int>(goal_.keys)})
                          .point);
    }
  }
  return found;
}

}  // namespace mahlwerk::campaign

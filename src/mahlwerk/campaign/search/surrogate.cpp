// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "mahlwerk/campaign/search/maximum.hpp"
#include "mahlwerk/campaign/sweep/designs.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::uint32_t chance_stream = 0x50000000, kernel_stream = 0x51000000,
                        path_stream = 0x52000000;

double turn(const Goal& goal, std::size_t outcome) {
  return outcome == 0 && !goal.maximise ? -1 : 1;
}

/// Mean and scatter of the replicates of a setting that have an outcome.
struct SettingSample {
  std::size_t setting = 0;
  double count = 0, mean = 0, squares = 0;
};

std::vector<SettingSample> samples_of(const std::vector<Tried>& tried, std::size_t outcome,
                                      double sign) {
  std::vector<SettingSample> made;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    SettingSample one{.setting = i};
    for (const auto& replicate : tried[i].replicates) {
      const double value = sign * replicate[outcome];
      if (!std::isfinite(value)) continue;
      const double off = value - one.mean;
      one.mean += off / ++one.count;
      one.squares += off * (value - one.mean);
    }
    if (one.count > 0 && tried[i].failure.empty()) made.push_back(one);
  }
  return made;
}

/// Replicates of one setting tell little of its own scatter: that of all counts like three more
/// (opt.9).
OutcomeModel model_of(const std::vector<Tried>& tried, std::size_t outcome, double sign) {
  constexpr double pooled_weight = 3, least = 1e-10;
  const std::vector<SettingSample> samples = samples_of(tried, outcome, sign);
  double freedom = 0, squares = 0, centre = 0, spread = 0;
  for (const SettingSample& s : samples) {
    freedom += s.count - 1;
    squares += s.squares;
    centre += s.mean / static_cast<double>(samples.size());
  }
  for (const SettingSample& s : samples) spread += std::pow(s.mean - centre, 2);
  spread = std::sqrt(spread / static_cast<double>(std::max<std::size_t>(1, samples.size() - 1)));
  const double unit = spread > 0 ? spread : std::max(std::abs(centre), 1e-300);
  const double pooled = freedom > 0 ? squares / freedom : 0;
  std::vector<Seen> seen;
  for (const SettingSample& s : samples) {
    const double own = (pooled_weight * pooled + s.squares) / (pooled_weight + s.count - 1);
    seen.push_back({.place = tried[s.setting].place,
                    .value = (s.mean - centre) / unit,
                    .variance = std::max(least, own / s.count / unit / unit)});
  }
  Kernel kernel = likeliest_kernel(seen);
  return {GaussianProcess(std::move(kernel), std::move(seen)), centre, unit,
          std::max(least, pooled / 2 / unit / unit)};
}

std::optional<GaussianProcess> success_of(const Goal& goal, const std::vector<Tried>& tried) {
  if (std::ranges::all_of(tried, [](const Tried& t) { return t.failure.empty(); }))
    return std::nullopt;
  Kernel kernel{.size = 1, .lengths = {}, .level = 0};
  kernel.lengths.assign(goal.keys, 0.25 * std::sqrt(static_cast<double>(goal.keys)));
  std::vector<Seen> seen;
  for (const Tried& t : tried)
    seen.push_back({.place = t.place, .value = t.failure.empty() ? 0.0 : -2.0, .variance = 0.01});
  return GaussianProcess(std::move(kernel), std::move(seen));
}

double keeps(const Bound& bound, const Belief& guess) {
  const double room = bound.below ? bound.value - guess.mean : guess.mean - bound.value;
  return guess.deviation > 0 ? normal_share(room / guess.deviation) : (room >= 0 ? 1 : 0);
}

/// By how much a value breaks a bound; 0 if it does not.
double excess(const Bound& bound, double value) {
  return std::max(0.0, bound.below ? value - bound.value : bound.value - value);
}

int wide_effort(std::size_t keys) {
  return 200 * static_cast<int>(keys);
}

}  // namespace

double expected_improvement(const Belief& guess, double best) {
  const double gain = guess.mean - best;
  if (!(guess.deviation > 0)) return std::max(0.0, gain);
  const double z = gain / guess.deviation;
  const double density = std::exp(-z * z / 2) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
  return std::max(0.0, gain * normal_share(z) + guess.deviation * density);  // (opt.5)
}

Belief OutcomeModel::at(const Place& place) const {
  const Belief guess = process.at(place);
  return {centre + unit * guess.mean, unit * guess.deviation};
}

Surrogate::Surrogate(const Goal& goal, const std::vector<Tried>& tried)
    : goal_(goal), tried_(tried), success_(success_of(goal, tried)) {
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i].failure.empty()) ran_.push_back(i);
  for (std::size_t outcome = 0; outcome <= goal.bounds.size(); ++outcome)
    models_.push_back(model_of(tried, outcome, turn(goal, outcome)));
  best_ = best();
  if (best_) best_mean_ = better(tried_[*best_].place).mean;
}

double Surrogate::runs(const Place& place) const {
  if (!success_) return 1;
  const Belief guess = success_->at(place);
  return normal_share((1 + guess.mean) / std::max(1e-9, guess.deviation));
}

double Surrogate::allowed(const Place& place) const {
  double share = runs(place);
  for (std::size_t i = 0; i < goal_.bounds.size(); ++i)
    share *= keeps(goal_.bounds[i], bounded(i).at(place));
  return share;
}

std::optional<std::size_t> Surrogate::best() const {
  std::optional<std::size_t> found;
  double highest_one = -std::numeric_limits<double>::infinity();
  for (const std::size_t i : ran_) {
    double kept = 1;  // it did run
    for (std::size_t b = 0; b < goal_.bounds.size(); ++b)
      kept *= keeps(goal_.bounds[b], bounded(b).at(tried_[i].place));
    const double mean = better(tried_[i].place).mean;
    if (kept < 0.5 || mean <= highest_one) continue;
    highest_one = mean;
    found = i;
  }
  return found;
}

Chances Surrogate::chances() const {
  constexpr int count = 1000;
  std::vector<Place> places;
  for (const std::size_t i : ran_) places.push_back(tried_[i].place);
  std::vector<std::vector<std::vector<double>>> drawn;  // by outcome
  for (std::size_t outcome = 0; outcome < models_.size(); ++outcome) {
    Random random(goal_.seed, chance_stream + static_cast<std::uint32_t>(outcome));
    drawn.push_back(models_[outcome].process.draws(places, count, random));
  }
  const auto kept = [&](std::size_t draw, std::size_t k) {
    for (std::size_t b = 0; b < goal_.bounds.size(); ++b) {
      const OutcomeModel& model = bounded(b);
      if (excess(goal_.bounds[b], model.centre + model.unit * drawn[b + 1][draw][k]) > 0)
        return false;
    }
    return true;
  };
  Chances made{.of = std::vector<double>(tried_.size(), 0), .loss = 0};
  for (std::size_t draw = 0; draw < count; ++draw) {
    const std::vector<double>& values = drawn.front()[draw];
    std::optional<std::size_t> top;
    double chosen = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < ran_.size(); ++k) {
      if (ran_[k] == best_) chosen = values[k];
      if (kept(draw, k) && (!top || values[k] > values[*top])) top = k;
    }
    if (!top) continue;
    made.of[ran_[*top]] += 1.0 / count;
    if (best_) made.loss += std::max(0.0, values[*top] - chosen) * objective().unit / count;
  }
  return made;
}

double Surrogate::promise(const Place& place) const {
  const double share = allowed(place);
  if (!best_) return share;
  const Belief guess = better(place);
  const double noise = objective().unit * std::sqrt(objective().noise);
  const double whole = std::hypot(guess.deviation, noise);
  const double news = whole > 0 ? 1 - noise / whole : 0;  // (opt.6)
  return share * news * expected_improvement(guess, best_mean_);
}

std::optional<std::size_t> Surrogate::alike(const Place& place) const {
  const OutcomeModel& model = objective();
  const Kernel& kernel = model.process.kernel();
  const double own = covariance(kernel, place, place);
  std::optional<std::size_t> nearest;
  double least = 0.25 * model.noise;  // (opt.12)
  for (std::size_t i = 0; i < tried_.size(); ++i) {
    const double apart = 2 * (own - covariance(kernel, place, tried_[i].place));
    if (apart > least) continue;
    least = apart;
    nearest = i;
  }
  return nearest;
}

Place Surrogate::most_promising() const {
  std::vector<Place> starts;
  if (best_) starts.push_back(tried_[*best_].place);
  return highest([this](const Place& x) { return promise(x); }, Place(goal_.keys, 0.0),
                 Place(goal_.keys, 1.0), starts,
                 {.wide = wide_effort(goal_.keys), .near = wide_effort(goal_.keys) / 4})
      .place;
}

Place Surrogate::highest_mean(bool bounds) const {
  const double far = 1e3 * objective().unit;  // whatever is allowed is better
  const auto value = [&](const Place& x) {
    return better(x).mean - far * std::max(0.0, 0.5 - (bounds ? allowed(x) : runs(x)));
  };
  std::vector<Place> starts;
  if (best_) starts.push_back(tried_[*best_].place);
  return highest(value, Place(goal_.keys, 0.0), Place(goal_.keys, 1.0), starts,
                 {.wide = wide_effort(goal_.keys), .near = wide_effort(goal_.keys) / 2})
      .place;
}

void Surrogate::believe(const Place& place) {
  constexpr double likely = 0.9;
  for (OutcomeModel& model : models_) model.process = model.process.believing(place, model.noise);
  if (success_ && runs(place) < likely) {  // the worst, lest all of a batch fails for one reason
    std::vector<Seen> seen = success_->seen();
    seen.push_back({.place = place, .value = -2, .variance = 0.01});
    success_ = GaussianProcess(success_->kernel(), std::move(seen));
  }
}

std::vector<Place> Surrogate::draws_of_best(int kernels, int paths) const {
  std::vector<std::vector<Kernel>> drawn;  // by outcome
  for (std::size_t outcome = 0; outcome < models_.size(); ++outcome) {
    Random random(goal_.seed, kernel_stream + static_cast<std::uint32_t>(outcome));
    const GaussianProcess& process = models_[outcome].process;
    drawn.push_back(plausible_kernels(process.seen(), process.kernel(), kernels, random));
  }
  Places starts = sobol_points(goal_.keys, 64 * goal_.keys);
  for (const std::size_t i : ran_) starts.push_back(tried_[i].place);
  starts.push_back(highest_mean());

  std::vector<Place> found;
  for (int k = 0; k < kernels; ++k) {
    std::vector<GaussianProcess> processes;
    for (std::size_t outcome = 0; outcome < models_.size(); ++outcome)
      processes.emplace_back(drawn[outcome][static_cast<std::size_t>(k)],
                             models_[outcome].process.seen());
    for (int p = 0; p < paths; ++p) {
      Random random(goal_.seed, path_stream + static_cast<std::uint32_t>(k * paths + p));
      std::vector<Path> path;
      for (const GaussianProcess& process : processes) path.push_back(process.path(random));
      const auto value = [&](const Place& x) {
        double broken = std::max(0.0, 0.5 - runs(x));
        for (std::size_t b = 0; b < goal_.bounds.size(); ++b) {
          const OutcomeModel& model = bounded(b);
          broken +=
              excess(goal_.bounds[b], model.centre + model.unit * path[b + 1](x)) / model.unit;
        }
        return broken > 0 ? -1e3 * (1 + broken) : path.front()(x);
      };
      const Highest start = highest(value, Place(goal_.keys, 0.0), Place(goal_.keys, 1.0), starts,
                                    {.wide = 0, .near = 0});
      found.push_back(highest(value, Place(goal_.keys, 0.0), Place(goal_.keys, 1.0), {start.place},
                              {.wide = 0, .near = 40 * static_cast<int>(goal_.keys)})
                          .place);
    }
  }
  return found;
}

}  // namespace mahlwerk::campaign

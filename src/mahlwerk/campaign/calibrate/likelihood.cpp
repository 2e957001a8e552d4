// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::campaign {
namespace {

/// Range of a relative scatter that is not known (cal.4).
constexpr double least_scatter = 1e-3, most_scatter = 1;

/// Values of an outcome at the settings that ran.
std::vector<std::vector<double>> values_by_trial(const std::vector<Trial>& trials,
                                                 std::size_t outcome) {
  std::vector<std::vector<double>> made;
  for (const Trial& trial : trials) {
    std::vector<double>& values = made.emplace_back();
    if (trial.failure.empty())
      for (const auto& replicate : trial.replicates) values.push_back(replicate[outcome]);
  }
  return made;
}

bool vary_by_factors(const std::vector<std::vector<double>>& values) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto& replicates : values)
    for (const double value : replicates) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  return varies_by_factors(least, most);
}

}  // namespace

std::vector<std::optional<OutcomeEmulator>> emulators(const CalibrationGoal& goal,
                                                      const std::vector<Trial>& trials) {
  std::vector<std::optional<OutcomeEmulator>> made(goal.outcomes);
  for (std::size_t outcome = 0; outcome < goal.outcomes; ++outcome) {
    if (std::ranges::find(goal.data, outcome, &Datum::outcome) == goal.data.end()) continue;
    std::vector<std::vector<double>> values = values_by_trial(trials, outcome);
    const bool positive = std::ranges::all_of(
        goal.data, [&](const Datum& d) { return d.outcome != outcome || d.value > 0; });
    const bool logarithmic = positive && vary_by_factors(values);
    std::vector<SettingSample> samples;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (logarithmic)
        for (double& value : values[i]) value = math::log(value);
      SettingSample one = sample_of(trials[i].point, values[i]);
      if (one.count > 0) samples.push_back(std::move(one));
    }
    if (!samples.empty()) made[outcome] = OutcomeEmulator{outcome_model(samples), logarithmic};
  }
  return made;
}

Likelihood::Likelihood(const CalibrationGoal& goal,
                       const std::vector<std::optional<OutcomeEmulator>>& emulators,
                       double inflation)
    : goal_(goal), emulators_(emulators), inflation_(inflation) {
  std::vector<double> count;
  for (std::size_t i = 0; i < goal.data.size(); ++i) {
    const Datum& datum = goal.data[i];
    if (std::isnan(datum.error)) scatters_ = std::max(scatters_, datum.quantity + 1);
    if (scale_.size() <= datum.quantity) {
      scale_.resize(datum.quantity + 1, 0);
      count.resize(datum.quantity + 1, 0);
    }
    scale_[datum.quantity] += std::abs(datum.value);
    ++count[datum.quantity];
    auto group = std::ranges::find(groups_, datum.outcome, &Group::outcome);
    if (group == groups_.end()) group = groups_.insert(group, {datum.outcome, {}});
    group->data.push_back(i);
  }
  for (std::size_t q = 0; q < scale_.size(); ++q) scale_[q] /= std::max(1.0, count[q]);
}

double Likelihood::scatter(std::size_t quantity, const std::vector<double>& point) const {
  const double position = point[goal_.parameters.size() + quantity];
  return least_scatter * math::exp(position * math::log(most_scatter / least_scatter));
}

/// Standard deviation of a datum, of its logarithm where the emulator has that.
double Likelihood::deviation(const Datum& datum, const std::vector<double>& point) const {
  const bool logarithmic = emulators_[datum.outcome]->logarithmic;
  if (!std::isnan(datum.error)) return inflation_ * datum.error / (logarithmic ? datum.value : 1);
  return scatter(datum.quantity, point) * (logarithmic ? 1 : scale_[datum.quantity]);
}

/// Covariance of the data of an outcome: their own variances, and that of the emulator, which they
/// share. Its inverse by Sherman and Morrison.
Likelihood::Term Likelihood::term(const Group& group, const std::vector<double>& point) const {
  const OutcomeEmulator& emulator = *emulators_[group.outcome];
  const DesignPoint at(point.begin(),
                       point.begin() + static_cast<std::ptrdiff_t>(goal_.parameters.size()));
  const Posterior guess = emulator.model.at(at);
  const double variance = guess.deviation * guess.deviation;
  double weights = 0, first = 0, second = 0, log_determinant = 0;
  for (const std::size_t i : group.data) {
    const double own = deviation(goal_.data[i], point);
    const double off = emulator.transformed(goal_.data[i].value) - guess.mean;
    weights += 1 / (own * own);
    first += off / (own * own);
    second += off * off / (own * own);
    log_determinant += 2 * math::log(own);
  }
  const double shared = 1 + variance * weights;
  return {second - variance * first * first / shared, log_determinant + math::log(shared)};
}

double Likelihood::log_at(const std::vector<double>& point) const {
  double sum = 0;
  for (const Group& group : groups_) {
    const Term t = term(group, point);
    sum -= (t.quadratic + t.log_determinant) / 2;  // (cal.3)
  }
  return sum;
}

double Likelihood::chi_square(const std::vector<double>& point) const {
  double sum = 0;
  for (const Group& group : groups_) sum += term(group, point).quadratic;
  return sum;  // (cal.6)
}

double Likelihood::emulator_share(std::size_t datum, const std::vector<double>& point) const {
  const Datum& d = goal_.data[datum];
  const DesignPoint at(point.begin(),
                       point.begin() + static_cast<std::ptrdiff_t>(goal_.parameters.size()));
  const double guess = emulators_[d.outcome]->model.at(at).deviation, own = deviation(d, point);
  return guess * guess / (guess * guess + own * own);
}

}  // namespace mahlwerk::campaign

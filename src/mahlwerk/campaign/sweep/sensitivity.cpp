// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/quantities/means.hpp"

namespace mahlwerk::campaign {
namespace {

void check(std::size_t rows, const std::vector<double>& outcomes,
           const std::vector<double>& errors) {
  if (outcomes.size() != rows || (!errors.empty() && errors.size() != rows))
    throw std::invalid_argument("a design and its outcomes have different numbers of rows");
}

int count_failed(const std::vector<double>& outcomes) {
  return static_cast<int>(
      std::ranges::count_if(outcomes, [](double y) { return !std::isfinite(y); }));
}

observe::IntervalEstimate mean_of(const std::vector<double>& values) {
  const observe::Estimate e = observe::estimate(values);
  return observe::IntervalEstimate::around(e.mean, e.ci95);
}

/// Standard deviation from the sums of values and of their squares.
double deviation(double sum, double squares, double count) {
  return std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1)));
}

/// Standard deviation with a jackknife interval (Quenouille 1956).
observe::IntervalEstimate deviation_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return {};
  double mean = 0, squares = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double whole = deviation(0, squares, n);
  if (n < 4) return {whole, unknown, unknown};
  double sum = 0, square_sum = 0;
  for (const double v : values) {
    const double x = v - mean, left = deviation(-x, squares - x * x, n - 1);
    sum += left;
    square_sum += left * left;
  }
  const double error = (n - 1) / std::sqrt(n) * deviation(sum, square_sum, n);
  return observe::IntervalEstimate::around(whole,
                                           observe::student95(static_cast<int>(n) - 1) * error);
}

/// True if either is, false if both are known not to be.
std::optional<bool> either(std::optional<bool> one, std::optional<bool> other) {
  if (one.value_or(false) || other.value_or(false)) return true;
  return one && other ? std::optional(false) : std::nullopt;
}

/// Whether mu* exceeds the effect of errors; empty: not known. Without an interval, mu* may be
/// larger by chance.
std::optional<bool> is_significant(double noise, const observe::IntervalEstimate& mean_absolute) {
  if (mean_absolute.value <= (std::isfinite(noise) ? noise : 0)) return false;
  if (!std::isfinite(mean_absolute.low)) return std::nullopt;
  if (std::isfinite(noise)) return mean_absolute.low > noise;
  return mean_absolute.low > 0 ? std::nullopt : std::optional(false);
}

/// Steps of a key along all trajectories.
struct Steps {
  std::vector<double> effects, sizes;
  double noise = 0;  // sum of the squares that errors alone would give
};

std::vector<Steps> steps_of(const DesignMatrix& design, const std::vector<double>& outcomes,
                            const std::vector<double>& errors) {
  const std::size_t keys = design.empty() ? 0 : design.front().size();
  std::vector<Steps> steps(keys);
  for (std::size_t row = 0; row + 1 < design.size(); ++row) {
    if ((row + 1) % (keys + 1) == 0) continue;  // a new trajectory begins
    const double change = outcomes[row + 1] - outcomes[row];
    if (!std::isfinite(change)) continue;
    std::size_t key = 0;
    while (key + 1 < keys && design[row + 1][key] == design[row][key]) ++key;
    const double step = design[row + 1][key] - design[row][key];
    steps[key].effects.push_back(change / step);  // (sen.2)
    steps[key].sizes.push_back(std::abs(change / step));
    const double error =
        errors.empty() ? unknown : math::hypot(errors[row], errors[row + 1]) / step;
    steps[key].noise += error * error;
  }
  return steps;
}

/// Squared errors are unbiased for any number of replicates; errors are not.
double of_noise(const Steps& steps) {
  if (steps.effects.empty()) return unknown;
  const double square = steps.noise / static_cast<double>(steps.effects.size());
  return std::numbers::sqrt2 * std::numbers::inv_sqrtpi * std::sqrt(square);  // (sen.5)
}

}  // namespace

observe::IntervalEstimate mean_of_points(const std::vector<double>& outcomes) {
  results::Quantity mean;
  results::combine(mean, outcomes, results::Interval::of_mean);
  return observe::IntervalEstimate::around(mean.value, mean.ci95);
}

std::vector<double> standard_errors(const std::vector<double>& outcomes,
                                    const std::vector<double>& ci95,
                                    const std::vector<double>& replicates) {
  if (ci95.empty() || replicates.empty()) return {};
  check(outcomes.size(), ci95, replicates);
  constexpr double over_time = 2;  // t_95 of the ten or more batch means of one replicate
  std::vector<double> errors(outcomes.size(), unknown);
  for (std::size_t row = 0; row < outcomes.size(); ++row) {
    if (!std::isfinite(outcomes[row])) continue;
    if (!std::isfinite(ci95[row]) || !(replicates[row] >= 1)) return {};
    const int freedom = static_cast<int>(replicates[row]) - 1;
    errors[row] = ci95[row] / (freedom > 0 ? observe::student95(freedom) : over_time);  // (sen.10)
  }
  return errors;
}

Sensitivity one_at_a_time_effects(const std::vector<double>& outcomes,
                                  const std::vector<double>& ci95) {
  const std::size_t keys = outcomes.size() / 2;
  check(2 * keys + 1, outcomes, ci95);
  const auto at = [&](std::size_t row) {
    return observe::IntervalEstimate::around(outcomes[row], ci95.empty() ? unknown : ci95[row]);
  };
  const auto differs = [&](std::size_t row) -> std::optional<bool> {
    const double change = std::abs(outcomes[row] - outcomes[0]);
    const double joined = ci95.empty() ? unknown : math::hypot(ci95[row], ci95[0]);
    if (!std::isfinite(change) || !std::isfinite(joined)) return std::nullopt;
    return change > joined;
  };
  Sensitivity found{.base = at(0), .failed = count_failed(outcomes)};
  for (std::size_t row = 1; row < outcomes.size(); row += 2)
    found.effects.push_back(
        {.low = at(row),
         .high = at(row + 1),
         .significant = either(differs(row), differs(row + 1)),
         .inactive = outcomes[row] == outcomes[0] && outcomes[row + 1] == outcomes[0]});
  return found;
}

Sensitivity elementary_effects(const DesignMatrix& design, const std::vector<double>& outcomes,
                               const std::vector<double>& errors) {
  check(design.size(), outcomes, errors);
  Sensitivity found{.design = cases::Design::morris,
                    .base = mean_of_points(outcomes),
                    .failed = count_failed(outcomes)};
  for (const Steps& steps : steps_of(design, outcomes, errors)) {
    Effect& effect = found.effects.emplace_back();
    effect.mean_absolute = mean_of(steps.sizes);  // (sen.3)
    effect.mean = mean_of(steps.effects);
    effect.deviation = deviation_of(steps.effects);  // (sen.4)
    effect.of_noise = of_noise(steps);
    effect.count = steps.effects.size();
    effect.significant = is_significant(effect.of_noise, effect.mean_absolute);
    effect.inactive = effect.mean_absolute.value == 0;
  }
  return found;
}

}  // namespace mahlwerk::campaign

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/power_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::measure {
namespace {

InputError power_fault(std::string what, std::string remedy) {
  return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
}

/// The smallest difference of two readings that differ; 0 if all are equal.
double resolution_of(std::vector<double> values) {
  std::ranges::sort(values);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[i - 1] * (1 + 1e-9)) least = std::min(least, values[i] - values[i - 1]);
  return std::isfinite(least) ? least : 0;
}

double middle_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return 0.5 * (values[n / 2] + values[(n - 1) / 2]);
}

/// The threshold that splits sorted values with the largest variance between both parts, and the
/// share of this variance.
std::pair<double, double> otsu(const std::vector<double>& sorted) {
  double sum = 0, squares = 0;
  for (const double v : sorted) {
    sum += v;
    squares += v * v;
  }
  const auto n = static_cast<double>(sorted.size());
  const double variance = squares / n - sum * sum / (n * n);
  double below = 0, best = -1, threshold = sorted.front();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    below += sorted[i - 1];
    const auto k = static_cast<double>(i);
    const double apart = below / k - (sum - below) / (n - k);
    const double between = k * (n - k) / (n * n) * apart * apart;
    if (between > best && sorted[i] > sorted[i - 1]) {
      best = between;
      threshold = 0.5 * (sorted[i] + sorted[i - 1]);
    }
  }
  return {threshold, variance > 0 ? best / variance : 0};
}

}  // namespace

PowerLevel power_level(std::span<const double> readings) {
  std::vector<double> values;
  std::ranges::copy_if(readings, std::back_inserter(values),
                       [](double v) { return !std::isnan(v); });
  if (values.size() < 10)
    throw power_fault(fmt::format("a level has {} readings; at least 10 are needed", values.size()),
                      "record each state of the mill for a minute or more");
  PowerLevel made{.readings = values.size()};
  const observe::Estimate mean = observe::time_series_estimate(values);
  const observe::Trend trend = observe::trend(values);
  if (std::abs(trend.change) > trend.ci95 && std::abs(trend.change) > 0.02 * std::abs(mean.mean))
    made.drift = trend.change;
  const double resolution = resolution_of(values), rounding = 0.5 * resolution;
  const double chance = 1.2533 * mean.ci95;  // a median scatters sqrt(pi/2) times as much
  made.power = {middle_of(std::move(values)), std::sqrt(chance * chance + rounding * rounding)};
  return made;
}

TwoLevels two_levels(std::span<const double> readings) {
  std::vector<double> sorted;
  for (const double v : readings)
    if (!std::isnan(v)) sorted.push_back(v);
  const double most = sorted.empty() ? 0 : std::ranges::max(sorted), off = 0.2 * most;
  std::erase_if(sorted, [&](double v) { return v <= off; });
  std::ranges::sort(sorted);
  const std::pair<double, double> split = sorted.size() < 20 ? std::pair(0.0, 0.0) : otsu(sorted);
  if (!(split.second > 0.8))
    throw power_fault("the log does not show two clear levels, idle and loaded",
                      "give the log of the idle mill, --idle FILE, or the times of both states: "
                      "--idle \"10 s to 60 s\" --load \"80 s to 200 s\"");
  TwoLevels made;
  const auto state = [&](double v) {
    return std::isnan(v) || v <= off ? 0 : v < split.first ? 1 : 2;
  };
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const int here = state(readings[i]);
    const std::size_t margin = 2;  // readings that average over the change
    bool inside = here != 0;
    for (std::size_t j = i - std::min(i, margin); j <= std::min(i + margin, readings.size() - 1);
         ++j)
      inside = inside && state(readings[j]) == here;
    if (inside) (here == 1 ? made.idle : made.load).push_back(readings[i]);
  }
  return made;
}

}  // namespace mahlwerk::measure

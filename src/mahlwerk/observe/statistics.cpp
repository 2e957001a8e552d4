// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::observe {
namespace {

/// Probability that |t| is below sqrt(n) tan(theta), for n degrees of freedom: the finite series
/// of Abramowitz & Stegun 26.7.3 and 26.7.4.
double within(double theta, int n) {
  const double c = math::cos(theta), s = math::sin(theta);
  const bool odd = n % 2 == 1;
  double term = odd ? c : 1, sum = n == 1 ? 0 : term;
  for (int k = odd ? 3 : 2; k < n; k += 2) {
    term *= c * c * (k - 1) / k;
    sum += term;
  }
  return odd ? 2 / std::numbers::pi * (theta + s * sum) : s * sum;
}

double by_bisection(int n) {
  double low = 0, high = std::numbers::pi / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (within(middle, n) < 0.95 ? low : high) = middle;
  }
  return std::sqrt(n) * math::tan(0.5 * (low + high));
}

/// Expansion about the normal quantile, Abramowitz & Stegun 26.7.5; accurate to 1e-6 beyond n = 30.
double by_expansion(int n) {
  constexpr double z = 1.959963984540054, z2 = z * z;
  constexpr double g1 = z * (z2 + 1) / 4;
  constexpr double g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
  constexpr double g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  constexpr double g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  const double r = 1.0 / n;
  return z + r * (g1 + r * (g2 + r * (g3 + r * g4)));
}

double mean_of(const std::vector<double>& values) {
  double mean = values.empty() ? 0 : values.front();  // shifted: equal values give a width of 0
  for (const double v : values) mean += (v - values.front()) / static_cast<double>(values.size());
  return mean;
}

double squares_about(const std::vector<double>& values, double mean) {
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum;
}

/// Lag-one autocorrelation, corrected for its bias of -1/n.
double lag_one_autocorrelation(const std::vector<double>& values) {
  const double mean = mean_of(values), squares = squares_about(values, mean);
  double sum = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
    sum += (values[i] - mean) * (values[i - 1] - mean);
  return squares > 0 ? sum / squares + 1 / static_cast<double>(values.size()) : 0;
}

std::vector<double> batch_means(const std::vector<double>& values, std::size_t of) {
  std::vector<double> batches(values.size() / of);
  for (std::size_t i = 0; i < batches.size() * of; ++i)
    batches[i / of] += values[i] / static_cast<double>(of);
  return batches;
}

}  // namespace

double student95(int freedom) {
  constexpr int few = 30;
  return freedom <= few ? by_bisection(freedom) : by_expansion(freedom);  // (sta.2)
}

Estimate estimate(const std::vector<double>& values) {
  if (values.empty()) return {};
  const double mean = mean_of(values);
  if (values.size() < 2) return {mean, std::numeric_limits<double>::quiet_NaN()};
  const auto n = static_cast<double>(values.size());
  const double error = std::sqrt(squares_about(values, mean) / (n - 1) / n);
  return {mean, student95(static_cast<int>(values.size()) - 1) * error};  // (sta.1)
}

Estimate time_series_estimate(const std::vector<double>& values) {
  constexpr std::size_t fewest = 10;
  if (values.size() < fewest) return {mean_of(values), std::numeric_limits<double>::quiet_NaN()};
  std::vector<double> batches = values;
  double known = lag_one_autocorrelation(batches);
  while (known * std::sqrt(static_cast<double>(batches.size())) >= 1 &&
         batches.size() / 2 >= fewest) {  // (sta.3)
    batches = batch_means(batches, 2);
    known = lag_one_autocorrelation(batches);
  }
  const double left = std::clamp(known, 0.0, 0.9);
  const double wider = std::sqrt((1 + left) / (1 - left));  // (sta.4)
  return {mean_of(values), wider * estimate(batches).ci95};
}

Trend trend(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0, slope = 0, spread = 0, rest = 0;
  for (const double v : values) mean += v / n;
  const auto at = [&](std::size_t i) { return static_cast<double>(i) - 0.5 * (n - 1); };
  for (std::size_t i = 0; i < values.size(); ++i) {
    slope += at(i) * (values[i] - mean);
    spread += at(i) * at(i);
  }
  slope /= spread;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - mean - slope * at(i);
    rest += off * off;
  }
  const double scatter = std::sqrt(rest / (n - 2));
  return {mean, slope * (n - 1),
          student95(static_cast<int>(n) - 2) * scatter / std::sqrt(spread) * (n - 1), scatter};
}

std::size_t transient_length(const std::vector<double>& values) {
  constexpr std::size_t five = 5;
  const std::vector<double> batches = batch_means(values, five);
  std::size_t best = 0;
  double surest = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first <= batches.size() / 2; ++first) {
    const std::vector<double> rest(batches.begin() + static_cast<std::ptrdiff_t>(first),
                                   batches.end());
    const auto n = static_cast<double>(rest.size());
    const double unsure = squares_about(rest, mean_of(rest)) / (n * n);  // (sta.5)
    if (unsure < surest) {
      surest = unsure;
      best = first;
    }
  }
  return five * best;
}

}  // namespace mahlwerk::observe

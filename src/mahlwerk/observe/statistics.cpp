// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/statistics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace mahlwerk::observe {
namespace {

/// Probability that |t| stays below sqrt(n) tan(theta), for n degrees of freedom: the finite series
/// of Abramowitz & Stegun 26.7.3 and 26.7.4.
double within(double theta, int n) {
  const double c = std::cos(theta), s = std::sin(theta);
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
  return std::sqrt(n) * std::tan(0.5 * (low + high));
}

/// Expansion about the normal quantile, Abramowitz & Stegun 26.7.5; beyond n = 30 it is good to
/// 1e-6.
double by_expansion(int n) {
  constexpr double z = 1.959963984540054, z2 = z * z;
  constexpr double g1 = z * (z2 + 1) / 4;
  constexpr double g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
  constexpr double g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  constexpr double g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  const double r = 1.0 / n;
  return z + r * (g1 + r * (g2 + r * (g3 + r * g4)));
}

}  // namespace

double student95(int freedom) {
  constexpr int few = 30;
  return freedom <= few ? by_bisection(freedom) : by_expansion(freedom);  // (sta.2)
}

Estimate estimate(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = values.empty() ? 0 : values.front();  // so that equal values have no width
  for (const double v : values) mean += (v - values.front()) / n;
  if (values.size() < 2) return {mean, std::numeric_limits<double>::quiet_NaN()};
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double error = std::sqrt(squares / (n - 1) / n);
  return {mean, student95(static_cast<int>(values.size()) - 1) * error};  // (sta.1)
}

}  // namespace mahlwerk::observe

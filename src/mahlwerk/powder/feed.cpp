// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/feed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {
namespace {

double sieved(const std::vector<std::array<double, 2>>& rows, double x) {
  const auto next = std::ranges::upper_bound(rows, x, {}, [](const auto& row) { return row[0]; });
  if (next == rows.begin()) return 0;
  if (next == rows.end()) return 1;
  const auto &low = *std::prev(next), &high = *next;
  return std::lerp(low[1], high[1], math::log(x / low[0]) / math::log(high[0] / low[0]));
}

double sieve_of(const std::vector<std::array<double, 2>>& rows, double share) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i][1] >= share && rows[i][1] > rows[i - 1][1]) {
      const double part =
          std::clamp((share - rows[i - 1][1]) / (rows[i][1] - rows[i - 1][1]), 0.0, 1.0);
      return rows[i - 1][0] * math::pow(rows[i][0] / rows[i - 1][0], part);
    }
  return rows.back()[0];
}

double normal_cdf(double z) {
  return 0.5 * math::erfc(-z / std::numbers::sqrt2);
}

/// Quantile of the standard normal distribution for a share in (0, 1).
double normal_quantile(double share) {
  double low = -40, high = 40;
  for (int i = 0; i < 100 && high - low > 1e-14 * (1 + std::abs(low)); ++i) {
    const double middle = 0.5 * (low + high);
    (normal_cdf(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double Feed::undersize(double x) const {
  switch (law) {
    case Law::equal:
      return x >= size ? 1 : 0;
    case Law::sieves:
      return sieved(passing, x);
    case Law::lognormal:
      return x > 0 ? normal_cdf(math::log(x / size) / math::log(spread)) : 0;
    case Law::rosin_rammler:
      return x > 0 ? -math::expm1(-math::pow(x / size, spread)) : 0;
  }
  return 0;
}

double Feed::quantile(double share) const {
  switch (law) {
    case Law::equal:
      return size;
    case Law::sieves:
      return sieve_of(passing, share);
    case Law::lognormal:
      return size * math::pow(spread, normal_quantile(share));
    case Law::rosin_rammler:
      return size * math::pow(-math::log1p(-share), 1 / spread);
  }
  return size;
}

}  // namespace mahlwerk::powder

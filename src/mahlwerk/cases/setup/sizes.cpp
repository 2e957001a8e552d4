// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

using SizeLaw = Distribution::Law;

/// Zeroth and third moment of the number density of diameters between two bounds, up to a common
/// factor.
struct Moments {
  double number = 0, cube = 0;
};

/// Standard normal distribution: the density, and the probability between two bounds.
double density(double z) {
  return math::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
}
double between(double a, double b) {
  return 0.5 * (math::erf(b / std::numbers::sqrt2) - math::erf(a / std::numbers::sqrt2));
}

Moments of_normal(const Distribution& d, double low, double high) {  // (chg.2)
  const double m = d.diameter, s = d.spread * d.diameter;
  const double a = (low - m) / s, b = (high - m) / s;
  const double p = between(a, b), fa = density(a), fb = density(b);
  const double first = fa - fb, second = p + a * fa - b * fb;
  const double third = (a * a + 2) * fa - (b * b + 2) * fb;
  return {p, m * m * m * p + 3 * m * m * s * first + 3 * m * s * s * second + s * s * s * third};
}

Moments of_lognormal(const Distribution& d, double low, double high) {  // (chg.3)
  const double s = math::log(d.spread);
  const double a = math::log(low / d.diameter) / s, b = math::log(high / d.diameter) / s;
  return {between(a, b),
          math::pow(d.diameter, 3) * math::exp(4.5 * s * s) * between(a - 3 * s, b - 3 * s)};
}

Moments of_uniform(double low, double high) {  // (chg.4)
  return {high - low, 0.25 * (math::pow(high, 4) - math::pow(low, 4))};
}

/// Bounds of `parts` classes with linear or logarithmic (`ratios`) spacing.
std::vector<double> edges(double low, double high, std::int64_t parts, bool ratios) {
  std::vector<double> found{low};
  for (std::int64_t i = 1; i < parts; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(parts);
    found.push_back(ratios ? low * math::pow(high / low, t) : low + t * (high - low));
  }
  found.push_back(high);
  return found;
}

std::vector<SizeShare> normalised(std::vector<SizeShare> shares) {
  double all = 0;
  for (const SizeShare& s : shares) all += s.share;
  for (SizeShare& s : shares) s.share /= all;
  return shares;
}

std::vector<SizeShare> of_sieves(const Distribution& d) {  // (chg.5, chg.6)
  std::vector<SizeShare> found;
  for (std::size_t i = 1; i < d.passing.size(); ++i) {
    const auto [low, below] = d.passing[i - 1];
    const auto [high, above] = d.passing[i];
    const double mass = above - below;
    if (!(mass > 0)) continue;
    const double volume =
        3 * math::log(high / low) / (1 / (low * low * low) - 1 / (high * high * high));
    found.push_back({low, high, math::cbrt(volume), mass / volume});
  }
  return normalised(std::move(found));
}

}  // namespace

std::vector<SizeShare> size_shares(const Distribution& of) {
  if (of.law == SizeLaw::sieves) return of_sieves(of);
  const double log_spread = of.law == SizeLaw::lognormal ? math::pow(of.spread, cut_off) : 1;
  const double wide = cut_off * of.spread;
  const double low = of.law == SizeLaw::normal      ? of.diameter * (1 - wide)
                     : of.law == SizeLaw::lognormal ? of.diameter / log_spread
                                                    : of.smallest;
  const double high = of.law == SizeLaw::normal      ? of.diameter * (1 + wide)
                      : of.law == SizeLaw::lognormal ? of.diameter * log_spread
                                                     : of.largest;
  const std::vector<double> edge = edges(low, high, of.classes, of.law == SizeLaw::lognormal);
  std::vector<SizeShare> found;
  for (std::size_t i = 1; i < edge.size(); ++i) {
    const double a = edge[i - 1], b = edge[i];
    const Moments m = of.law == SizeLaw::normal      ? of_normal(of, a, b)
                      : of.law == SizeLaw::lognormal ? of_lognormal(of, a, b)
                                                     : of_uniform(a, b);
    found.push_back({a, b, math::cbrt(m.cube / m.number), m.number});  // (chg.1)
  }
  return normalised(std::move(found));
}

double mean_volume_diameter(const std::vector<SizeShare>& shares) {
  double cube = 0;
  for (const SizeShare& s : shares) cube += s.share * s.diameter * s.diameter * s.diameter;
  return math::cbrt(cube);  // (chg.7)
}

double mean_volume_diameter(const std::vector<SizeClass>& classes) {
  double cube = 0, count = 0;
  for (const SizeClass& c : classes) {
    cube += static_cast<double>(c.count) * c.diameter * c.diameter * c.diameter;
    count += static_cast<double>(c.count);
  }
  return math::cbrt(cube / count);  // (chg.7)
}

std::vector<std::int64_t> apportion(std::int64_t count, const std::vector<SizeShare>& shares) {
  std::vector<std::int64_t> counts;
  std::vector<double> rest;
  for (const SizeShare& s : shares) {
    const double wanted = s.share * static_cast<double>(count);
    counts.push_back(static_cast<std::int64_t>(wanted));
    rest.push_back(wanted - std::floor(wanted));
  }
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return rest[i]; });
  const std::int64_t left = count - std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  for (std::int64_t i = 0; i < left; ++i)  // (chg.8)
    ++counts[order[static_cast<std::size_t>(i) % order.size()]];
  return counts;
}

std::int64_t max_filled_classes(Distribution of, std::int64_t count) {
  for (of.classes = default_classes; of.classes > 1; --of.classes)
    if (std::ranges::min(apportion(count, size_shares(of))) > 0) break;
  return of.classes;
}

const std::vector<std::string>& distribution_words() {
  static const std::vector<std::string> words{"equal", "normal", "lognormal", "uniform", "sieves"};
  return words;
}

std::string passing_text(const std::vector<std::array<double, 2>>& passing) {
  std::string rows;
  for (const auto& [opening, share] : passing)
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", in_quotes(show(opening, "m")),
                        shortest(share));
  return "[" + rows + "]";
}

}  // namespace mahlwerk::cases

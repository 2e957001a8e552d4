// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/gaussian_process.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "mahlwerk/campaign/search/maximum.hpp"
#include "mahlwerk/campaign/search/surrogate.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::gaussian_process_test {
namespace {

using tests::states;
using tests::stays_below;
using Rows = std::vector<std::vector<double>>;

/// Gauss and Jordan's way: the inverse, and ln of the determinant.
double invert(Rows& a) {
  const std::size_t n = a.size();
  double volume = 0;
  for (std::size_t p = 0; p < n; ++p) {
    volume += std::log(a[p][p]);
    const double pivot = 1 / a[p][p];
    for (std::size_t r = 0; r < n; ++r) {
      if (r == p) continue;
      const double share = a[r][p] * pivot;
      for (std::size_t c = 0; c < n; ++c)
        if (c != p) a[r][c] -= share * a[p][c];
      a[r][p] = -share;
    }
    for (std::size_t c = 0; c < n; ++c)
      if (c != p) a[p][c] *= pivot;
    a[p][p] = pivot;
  }
  return volume;
}

std::vector<Seen> some_seen(std::size_t count, std::size_t keys, double noise) {
  std::vector<Seen> seen;
  Random random(3, 0);
  for (std::size_t i = 0; i < count; ++i) {
    Seen one{.place = Place(keys), .value = 0, .variance = noise * noise};
    for (double& x : one.place) x = random.uniform();
    one.value = std::sin(5 * one.place[0]) + noise * normal_number(random);
    seen.push_back(one);
  }
  return seen;
}

TEST(Kernel, is_materns_of_order_five_halves) {
  const Kernel k{.size = 2, .lengths = {0.5}, .level = 3};
  const double r = std::sqrt(5.0) * 0.3 / 0.5;
  states("covariance", covariance(k, {0.2}, {0.5}), 4 * (1 + r + r * r / 3) * std::exp(-r) + 9,
         1e-14, "(opt.1)");
  EXPECT_EQ(covariance(k, {0.2}, {0.2}), 13);
}

TEST(GaussianProcess, agrees_with_two_values_by_hand) {
  // K = [1.1, c; c, 1.2]: its inverse is [1.2, -c; -c, 1.1]/(1.32 - c^2).
  const Kernel kernel{.size = 1, .lengths = {0.6}, .level = 0};
  const GaussianProcess process(kernel, {{{0.0}, 2, 0.1}, {{1.0}, -1, 0.2}});
  const auto c = [&](double a, double b) { return covariance(kernel, {a}, {b}); };
  const double c01 = c(0, 1), k0 = c(0.3, 0), k1 = c(0.3, 1), volume = 1.32 - c01 * c01;
  const Belief found = process.at({0.3});
  states("mean", found.mean, (k0 * (1.2 * 2 + c01) + k1 * (-c01 * 2 - 1.1)) / volume, 1e-8,
         "by hand");
  states("variance", found.deviation * found.deviation,
         1 - (1.2 * k0 * k0 - 2 * c01 * k0 * k1 + 1.1 * k1 * k1) / volume, 1e-8, "by hand");
  states("evidence", process.evidence(),
         -(1.2 * 4 + 4 * c01 + 1.1) / volume / 2 - std::log(volume) / 2 -
             std::log(2 * std::numbers::pi),
         1e-8, "by hand");
}

TEST(GaussianProcess, agrees_with_the_plain_formula) {
  const Kernel kernel{.size = 1.3, .lengths = {0.4, 0.9, 2.0}, .level = 0.7};
  const std::vector<Seen> seen = some_seen(25, 3, 0.1);
  const GaussianProcess process(kernel, seen);
  Rows inverse(25, std::vector<double>(25));
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t j = 0; j < 25; ++j)
      inverse[i][j] =
          covariance(kernel, seen[i].place, seen[j].place) + (i == j ? seen[i].variance : 0);
  const double volume = invert(inverse);
  const Place at{0.3, 0.8, 0.1};
  double mean = 0, variance = covariance(kernel, at, at), fit = 0;
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t j = 0; j < 25; ++j) {
      const double k = covariance(kernel, at, seen[i].place) * inverse[i][j];
      mean += k * seen[j].value;
      variance -= k * covariance(kernel, at, seen[j].place);
      fit += seen[i].value * inverse[i][j] * seen[j].value;
    }
  // The process adds 1e-9 of the variance to its diagonal, noise is 0.01: 2e-7 of it.
  states("mean", process.at(at).mean, mean, 1e-6, "Gauss and Jordan");
  states("deviation", process.at(at).deviation, std::sqrt(variance), 1e-6, "Gauss and Jordan");
  states("evidence", process.evidence(),
         -fit / 2 - volume / 2 - 12.5 * std::log(2 * std::numbers::pi), 1e-4, "Gauss and Jordan");
}

TEST(GaussianProcess, goes_through_values_without_noise) {
  const std::vector<Seen> seen = some_seen(8, 2, 0);
  const GaussianProcess process({.size = 1, .lengths = {0.5, 0.5}, .level = 1}, seen);
  for (const Seen& one : seen) {
    states("value", process.at(one.place).mean, one.value, 1e-5, "as seen");
    stays_below("deviation", process.at(one.place).deviation, 1e-3, "known");
  }
}

TEST(GaussianProcess, draws_scatter_as_it_believes) {
  constexpr int count = 4000;
  const GaussianProcess process({.size = 1, .lengths = {0.3}, .level = 1}, some_seen(4, 1, 0.2));
  const std::vector<Place> places{{0.05}, {0.5}, {0.52}};
  Random random(1, 2);
  const Rows exact = process.draws(places, count, random);
  Rows waves;
  for (int i = 0; i < count; ++i) {
    const Path path = process.path(random);
    waves.push_back({path(places[0]), path(places[1]), path(places[2])});
  }
  for (const Rows* drawn : {&exact, static_cast<const Rows*>(&waves)})
    for (std::size_t k = 0; k < 3; ++k) {
      const Belief belief = process.at(places[k]);
      double sum = 0, squares = 0;
      for (const auto& draw : *drawn) {
        sum += draw[k];
        squares += std::pow(draw[k] - belief.mean, 2);
      }
      states("mean", sum / count, belief.mean, 3.5 * belief.deviation / std::sqrt(count),
             "3.5 standard errors");
      // Paths are normal only given their waves, so squares scatter a little more than a normal's.
      states("variance", squares / count / belief.deviation / belief.deviation, 1,
             3.5 * std::sqrt(2.5 / count), "3.5 standard errors");
    }
  double together = 0;
  for (const auto& draw : exact) together += std::abs(draw[1] - draw[2]) / count;
  stays_below("neighbours apart", together, 0.5 * process.at(places[1]).deviation, "a function");
}

TEST(GaussianProcess, believes_without_changing_its_mind) {
  const GaussianProcess before({.size = 1, .lengths = {0.3}, .level = 1}, some_seen(4, 1, 0.1));
  const GaussianProcess after = before.believing({0.9}, 1e-6);
  states("mean", after.at({0.8}).mean, before.at({0.8}).mean, 1e-6, "as expected");
  EXPECT_LT(after.at({0.9}).deviation, 0.01 * before.at({0.9}).deviation);
}

TEST(LikeliestKernel, is_long_along_a_key_that_does_nothing) {
  const Kernel found = likeliest_kernel(some_seen(30, 2, 0.05));
  EXPECT_GT(found.lengths[1], 2 * found.lengths[0]);
}

TEST(PlausibleKernels, are_drawn_as_likely_as_they_are) {
  const std::vector<Seen> seen = some_seen(6, 1, 0.1);
  double whole = 0, size = 0, length = 0;
  for (double s = -2.95; s < 4; s += 0.05)
    for (double l = -3.95; l < 4; l += 0.05) {
      const GaussianProcess process({.size = std::exp(s), .lengths = {std::exp(l)}, .level = 3},
                                    seen);
      const double usual = (l - std::log(0.6)) / 0.6;
      const double likely =
          std::exp(process.evidence() - s * s / 2 - usual * usual / 2);  // (opt.4)
      whole += likely;
      size += likely * s;
      length += likely * l;
    }
  constexpr int count = 3000;
  Random random(8, 0);
  double found_size = 0, found_length = 0;
  for (const Kernel& k : plausible_kernels(seen, likeliest_kernel(seen), count, random)) {
    found_size += std::log(k.size) / count;
    found_length += std::log(k.lengths[0]) / count;
  }
  // Scatters of 0.5 and less; draws remember some five before them: 0.5/sqrt(600), 3.3 times.
  states("mean ln size", found_size, size / whole, 0.07, "sums over a grid");
  states("mean ln length", found_length, length / whole, 0.07, "sums over a grid");
}

TEST(ExpectedImprovement, is_the_integral_of_what_is_gained) {
  for (const auto& [mean, deviation, best] :
       {std::tuple{1.0, 0.5, 1.2}, {1.0, 0.5, 0.2}, {-1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}}) {
    double gained = 0;
    constexpr int steps = 400000;
    const double step = 20 * deviation / steps;
    for (int i = 0; i < steps; ++i) {
      const double z = -10 + 20 * (i + 0.5) / steps;
      const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi) / deviation;
      gained += std::max(0.0, mean + z * deviation - best) * density * step;
    }
    states("improvement", expected_improvement({mean, deviation}, best), gained, 1e-8, "integral");
  }
  EXPECT_EQ(expected_improvement({2, 0}, 1.5), 0.5);
  EXPECT_EQ(expected_improvement({1, 0}, 1.5), 0);
}

TEST(Highest, is_found_among_many_peaks_and_at_edges) {
  const auto peaks = [](const Place& x) {
    return std::cos(12 * x[0]) - std::pow(x[0] - 0.5, 2) + x[1];
  };
  const Highest found = highest(peaks, {0, 0}, {1, 1}, {{0.05, 0.5}}, {.wide = 400, .near = 200});
  // -12 sin 12x - 2 (x - 1/2) = 0 near pi/6.
  states("first key", found.place[0], std::numbers::pi / 6, 1e-3, "a sixth of a turn");
  EXPECT_EQ(found.place[1], 1);
  const auto broken = [](const Place& x) {
    return x[0] > 0.5 ? std::numeric_limits<double>::quiet_NaN() : x[0];
  };
  states("beside what is not a number",
         highest(broken, {0}, {1}, {{0.1}}, {.wide = 100, .near = 100}).place[0], 0.5, 1e-3, "end");
}

TEST(Highest, lets_exceptions_through) {
  const auto breaks = [](const Place& x) -> double {
    if (x[0] > 0.5) throw std::runtime_error("broken");
    return x[0];
  };
  EXPECT_THROW(highest(breaks, {0}, {1}, {{0.1}}, {.wide = 100, .near = 0}), std::runtime_error);
}

}  // namespace
}  // namespace mahlwerk::campaign::gaussian_process_test

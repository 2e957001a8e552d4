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

/// Gauss-Jordan elimination: inverts the matrix and returns ln of its determinant.
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

std::vector<Observation> some_observations(std::size_t count, std::size_t keys, double noise) {
  std::vector<Observation> observations;
  Random random(3, 0);
  for (std::size_t i = 0; i < count; ++i) {
    Observation one{.point = DesignPoint(keys), .value = 0, .variance = noise * noise};
    for (double& x : one.point) x = random.uniform();
    one.value = std::sin(5 * one.point[0]) + noise * standard_normal(random);
    observations.push_back(one);
  }
  return observations;
}

TEST(Kernel, is_materns_of_order_five_halves) {
  const Kernel k{.amplitude = 2, .length_scales = {0.5}, .constant = 3};
  const double r = std::sqrt(5.0) * 0.3 / 0.5;
  states("covariance", covariance(k, {0.2}, {0.5}), 4 * (1 + r + r * r / 3) * std::exp(-r) + 9,
         1e-14, "(opt.1)");
  EXPECT_EQ(covariance(k, {0.2}, {0.2}), 13);
}

TEST(GaussianProcess, agrees_with_two_values_by_hand) {
  // K = [1.1, c; c, 1.2]: its inverse is [1.2, -c; -c, 1.1]/(1.32 - c^2).
  const Kernel kernel{.amplitude = 1, .length_scales = {0.6}, .constant = 0};
  const GaussianProcess process(kernel, {{{0.0}, 2, 0.1}, {{1.0}, -1, 0.2}});
  const auto c = [&](double a, double b) { return covariance(kernel, {a}, {b}); };
  const double c01 = c(0, 1), k0 = c(0.3, 0), k1 = c(0.3, 1), volume = 1.32 - c01 * c01;
  const Posterior found = process.at({0.3});
  states("mean", found.mean, (k0 * (1.2 * 2 + c01) + k1 * (-c01 * 2 - 1.1)) / volume, 1e-8,
         "by hand");
  states("variance", found.deviation * found.deviation,
         1 - (1.2 * k0 * k0 - 2 * c01 * k0 * k1 + 1.1 * k1 * k1) / volume, 1e-8, "by hand");
  states("evidence", process.log_evidence(),
         -(1.2 * 4 + 4 * c01 + 1.1) / volume / 2 - std::log(volume) / 2 -
             std::log(2 * std::numbers::pi),
         1e-8, "by hand");
}

TEST(GaussianProcess, agrees_with_the_plain_formula) {
  const Kernel kernel{.amplitude = 1.3, .length_scales = {0.4, 0.9, 2.0}, .constant = 0.7};
  const std::vector<Observation> observations = some_observations(25, 3, 0.1);
  const GaussianProcess process(kernel, observations);
  Rows inverse(25, std::vector<double>(25));
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t j = 0; j < 25; ++j)
      inverse[i][j] = covariance(kernel, observations[i].point, observations[j].point) +
                      (i == j ? observations[i].variance : 0);
  const double volume = invert(inverse);
  const DesignPoint at{0.3, 0.8, 0.1};
  double mean = 0, variance = covariance(kernel, at, at), fit = 0;
  for (std::size_t i = 0; i < 25; ++i)
    for (std::size_t j = 0; j < 25; ++j) {
      const double k = covariance(kernel, at, observations[i].point) * inverse[i][j];
      mean += k * observations[j].value;
      variance -= k * covariance(kernel, at, observations[j].point);
      fit += observations[i].value * inverse[i][j] * observations[j].value;
    }
  // The process adds 1e-9 of the variance to its diagonal, which is 2e-7 of the noise of 0.01.
  states("mean", process.at(at).mean, mean, 1e-6, "Gauss and Jordan");
  states("deviation", process.at(at).deviation, std::sqrt(variance), 1e-6, "Gauss and Jordan");
  states("evidence", process.log_evidence(),
         -fit / 2 - volume / 2 - 12.5 * std::log(2 * std::numbers::pi), 1e-4, "Gauss and Jordan");
}

TEST(GaussianProcess, goes_through_values_without_noise) {
  const std::vector<Observation> observations = some_observations(8, 2, 0);
  const GaussianProcess process({.amplitude = 1, .length_scales = {0.5, 0.5}, .constant = 1},
                                observations);
  for (const Observation& one : observations) {
    states("value", process.at(one.point).mean, one.value, 1e-5, "as seen");
    stays_below("deviation", process.at(one.point).deviation, 1e-3, "known");
  }
}

TEST(GaussianProcess, draws_scatter_as_it_believes) {
  constexpr int count = 4000;
  const GaussianProcess process({.amplitude = 1, .length_scales = {0.3}, .constant = 1},
                                some_observations(4, 1, 0.2));
  const std::vector<DesignPoint> points{{0.05}, {0.5}, {0.52}};
  Random random(1, 2);
  const Rows exact = process.joint_samples(points, count, random);
  Rows waves;
  for (int i = 0; i < count; ++i) {
    const SamplePath path = process.sample_path(random);
    waves.push_back({path(points[0]), path(points[1]), path(points[2])});
  }
  for (const Rows* drawn : {&exact, static_cast<const Rows*>(&waves)})
    for (std::size_t k = 0; k < 3; ++k) {
      const Posterior belief = process.at(points[k]);
      double sum = 0, squares = 0;
      for (const auto& draw : *drawn) {
        sum += draw[k];
        squares += std::pow(draw[k] - belief.mean, 2);
      }
      states("mean", sum / count, belief.mean, 3.5 * belief.deviation / std::sqrt(count),
             "3.5 standard errors");
      // Sample paths are normal only for given waves, so squares scatter a little more than a
      // normal's.
      states("variance", squares / count / belief.deviation / belief.deviation, 1,
             3.5 * std::sqrt(2.5 / count), "3.5 standard errors");
    }
  double together = 0;
  for (const auto& draw : exact) together += std::abs(draw[1] - draw[2]) / count;
  stays_below("neighbours apart", together, 0.5 * process.at(points[1]).deviation, "a function");
}

TEST(GaussianProcess, believes_without_changing_its_mind) {
  const GaussianProcess before({.amplitude = 1, .length_scales = {0.3}, .constant = 1},
                               some_observations(4, 1, 0.1));
  const GaussianProcess after = before.with_fantasy({0.9}, 1e-6);
  states("mean", after.at({0.8}).mean, before.at({0.8}).mean, 1e-6, "as expected");
  EXPECT_LT(after.at({0.9}).deviation, 0.01 * before.at({0.9}).deviation);
}

TEST(LikeliestKernel, is_long_along_a_key_that_does_nothing) {
  const Kernel found = most_probable_kernel(some_observations(30, 2, 0.05));
  EXPECT_GT(found.length_scales[1], 2 * found.length_scales[0]);
}

TEST(PlausibleKernels, are_drawn_as_likely_as_they_are) {
  const std::vector<Observation> observations = some_observations(6, 1, 0.1);
  double whole = 0, size = 0, length = 0;
  for (double s = -2.95; s < 4; s += 0.05)
    for (double l = -3.95; l < 4; l += 0.05) {
      const GaussianProcess process(
          {.amplitude = std::exp(s), .length_scales = {std::exp(l)}, .constant = 3}, observations);
      const double usual = (l - std::log(0.6)) / 0.6;
      const double likely =
          std::exp(process.log_evidence() - s * s / 2 - usual * usual / 2);  // (opt.4)
      whole += likely;
      size += likely * s;
      length += likely * l;
    }
  constexpr int count = 3000;
  Random random(8, 0);
  double found_size = 0, found_length = 0;
  for (const Kernel& k :
       sample_kernels(observations, most_probable_kernel(observations), count, random)) {
    found_size += std::log(k.amplitude) / count;
    found_length += std::log(k.length_scales[0]) / count;
  }
  // Standard deviations are at most 0.5. Draws are correlated over about five: 0.5/sqrt(600), 3.3
  // times.
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
  const auto peaks = [](const DesignPoint& x) {
    return std::cos(12 * x[0]) - std::pow(x[0] - 0.5, 2) + x[1];
  };
  const Maximum found =
      find_maximum(peaks, {0, 0}, {1, 1}, {{0.05, 0.5}}, {.global = 400, .local = 200});
  // -12 sin 12x - 2 (x - 1/2) = 0 near pi/6.
  states("first key", found.point[0], std::numbers::pi / 6, 1e-3, "a sixth of a turn");
  EXPECT_EQ(found.point[1], 1);
  const auto broken = [](const DesignPoint& x) {
    return x[0] > 0.5 ? std::numeric_limits<double>::quiet_NaN() : x[0];
  };
  states("beside what is not a number",
         find_maximum(broken, {0}, {1}, {{0.1}}, {.global = 100, .local = 100}).point[0], 0.5, 1e-3,
         "end");
}

TEST(Highest, lets_exceptions_through) {
  const auto breaks = [](const DesignPoint& x) -> double {
    if (x[0] > 0.5) throw std::runtime_error("broken");
    return x[0];
  };
  EXPECT_THROW(find_maximum(breaks, {0}, {1}, {{0.1}}, {.global = 100, .local = 0}),
               std::runtime_error);
}

}  // namespace
}  // namespace mahlwerk::campaign::gaussian_process_test

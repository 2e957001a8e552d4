// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Confidence intervals of the position of an optimum contain it as often as they claim, or more
// often.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "mahlwerk/campaign/search/optimise.hpp"
#include "noisy_simulation.hpp"

namespace mahlwerk::campaign::optimum_interval_test {
namespace {

constexpr int times = 200;
const double least = 0.95 * times - 3.3 * std::sqrt(times * 0.95 * 0.05);  // binomial

/// Number of the 200 noise realisations in which the interval of each key contains the true
/// optimum. The last element counts those in which the interval of the mean at the best tried
/// setting contains the true mean.
std::vector<int> held(const Goal& goal, tests::NoisySimulation noisy, const DesignPoint& truth) {
  std::vector<int> count(goal.keys + 1, 0);
  for (int seed = 0; seed < times; ++seed) {
    noisy.seed = 1000 + static_cast<std::uint64_t>(seed);
    Goal one = goal;
    one.seed = static_cast<std::uint64_t>(seed);
    const Optimum found = optimise(one, noisy);
    for (std::size_t key = 0; key < goal.keys; ++key)
      count[key] += found.keys[key].low <= truth[key] && truth[key] <= found.keys[key].high ? 1 : 0;
    const Trial& best = found.trials[*found.best];
    count.back() +=
        std::abs(best.model.mean - noisy.functions.front()(best.point)) <= best.model.ci95 ? 1 : 0;
  }
  return count;
}

void expect_held(const std::vector<int>& count) {
  for (std::size_t i = 0; i < count.size(); ++i) {
    std::printf("    %s: at least %.0f of %d, found %d [binomial]\n",
                i + 1 < count.size() ? "place of the optimum held" : "mean at the best tried held",
                least, times, count[i]);
    EXPECT_GE(count[i], least);
  }
}

TEST(OptimumInterval, holds_the_top_of_a_narrow_hill_on_a_slope) {
  const auto hill = [](const DesignPoint& x) {
    return std::exp(-0.5 * std::pow((x[0] - 0.7) / 0.12, 2)) + 0.3 * x[0];
  };
  // exp(-z^2/2) z/0.12 = 0.3, z = (x - 0.7)/0.12
  double z = 0;
  for (int i = 0; i < 50; ++i) z = 0.3 * 0.12 * std::exp(z * z / 2);
  expect_held(held({.keys = 1, .settings = 20}, {{hill}, 0.05}, {0.7 + 0.12 * z}));
}

TEST(OptimumInterval, holds_the_top_over_two_keys) {
  const auto hill = [](const DesignPoint& x) {
    const double a = x[0] - 0.3, b = x[1] - 0.6;
    return std::exp(-2 * a * a - 6 * b * b - 2 * a * b);
  };
  expect_held(held({.keys = 2, .settings = 24}, {{hill}, 0.05}, {0.3, 0.6}));
}

}  // namespace
}  // namespace mahlwerk::campaign::optimum_interval_test

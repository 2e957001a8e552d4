// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/optimise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "noisy_simulation.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::optimise_test {
namespace {

using tests::NoisySimulation;
using tests::states;
using tests::stays_below;

double hill(const DesignPoint& x) {
  return 1 - 4 * std::pow(x[0] - 0.37, 2);
}

/// Branin's function over its usual ranges. Its three minima have the value 0.397887.
double branin(const DesignPoint& point) {
  const double x = 15 * point[0] - 5, y = 15 * point[1], pi = std::numbers::pi;
  return std::pow(y - 5.1 / (4 * pi * pi) * x * x + 5 / pi * x - 6, 2) +
         10 * (1 - 1 / (8 * pi)) * std::cos(x) + 10;
}

double four_keys(const DesignPoint& x) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double k = static_cast<double>(i) + 1;
    sum -= k * std::pow(x[i] - 0.2 * k, 2);
  }
  return sum;
}

// Difference that two replicates of each setting cannot resolve: their mean is known to
// noise/sqrt(2), and two settings are compared.
double hardly_told(double noise) {
  return 2 * noise / std::sqrt(2.0);
}

TEST(Optimise, finds_the_top_of_a_hill_in_noise) {
  const Optimum found = optimise({.keys = 1, .settings = 16}, NoisySimulation{{hill}, 0.1});
  ASSERT_TRUE(found.best);
  const Trial& best = found.trials[*found.best];
  stays_below("lost at the best tried", 1 - hill(best.point), hardly_told(0.1), "known top");
  stays_below("lost at the model's best", 1 - hill(found.model_point), hardly_told(0.1),
              "known top");
  EXPECT_LE(found.trials.size(), 16U);
  EXPECT_LE(found.keys[0].low, 0.37);
  EXPECT_GE(found.keys[0].high, 0.37);
  EXPECT_EQ(found.failed, 0);
  for (const Trial& t : found.trials) EXPECT_LE(t.replicates.size(), 16U);
}

TEST(Optimise, keeps_the_notices_of_a_settings_runs) {
  const NoisySimulation noisy{{hill}, 0.1};
  const Optimum found =
      optimise({.keys = 1, .settings = 8}, [&](const std::vector<TrialRequest>& asked) {
        std::vector<TrialResult> results = noisy(asked);
        for (std::size_t i = 0; i < results.size(); ++i)
          if (asked[i].point[0] > 0.3)
            results[i].notices = {asked[i].first == 0 ? warning("long-contacts", "first")
                                                      : invalid("long-contacts", "more")};
        return results;
      });
  ASSERT_TRUE(found.best);
  for (const Trial& t : found.trials) {
    EXPECT_EQ(t.notices.size(), t.point[0] > 0.3 ? 1U : 0U);
    EXPECT_EQ(t.invalid(), t.point[0] > 0.3 && t.replicates.size() > 2);
  }
}

TEST(Optimise, finds_the_top_exactly_without_noise) {
  const Optimum found = optimise({.keys = 1, .settings = 30}, NoisySimulation{{hill}, 0});
  stays_below("lost", 1 - hill(found.trials[*found.best].point), 1e-3, "no noise");
  stays_below("width", found.keys[0].high - found.keys[0].low, 0.1, "no noise");
}

TEST(Optimise, finds_one_of_branins_valleys) {
  const Optimum found =
      optimise({.keys = 2, .maximise = false, .settings = 40}, NoisySimulation{{branin}, 2});
  stays_below("above the deepest", branin(found.trials[*found.best].point) - 0.397887,
              hardly_told(2), "Branin's function reaches to 300");
}

TEST(Optimise, finds_the_top_over_four_keys) {
  const Optimum found = optimise({.keys = 4, .settings = 40}, NoisySimulation{{four_keys}, 0.05});
  stays_below("lost", -four_keys(found.trials[*found.best].point), hardly_told(0.05), "known top");
}

TEST(Optimise, minimises_as_it_maximises) {
  const Optimum up = optimise({.keys = 1, .settings = 12}, NoisySimulation{{hill}, 0.1});
  const Optimum down =
      optimise({.keys = 1, .maximise = false, .settings = 12},
               NoisySimulation{{[](const DesignPoint& x) { return -hill(x); }}, -0.1});
  ASSERT_EQ(up.trials.size(), down.trials.size());
  for (std::size_t i = 0; i < up.trials.size(); ++i) {
    EXPECT_EQ(up.trials[i].point, down.trials[i].point);
    EXPECT_EQ(up.trials[i].model.mean, -down.trials[i].model.mean);
  }
  EXPECT_EQ(up.best, down.best);
}

TEST(Optimise, searches_by_ratios_in_a_logarithmic_range) {
  const FreeParameter range{"k", 1e-3, 1e3};
  const Optimum found = optimise(
      {.keys = 1, .settings = 20},
      NoisySimulation{{[&](const DesignPoint& x) {
                        return 1 - 0.1 * std::pow(std::log10(value_at(range, x[0])) - 1, 2);
                      }},
                      0.02});
  const double best = value_at(range, found.trials[*found.best].point[0]);
  // 0.1 (lg k - 1)^2 < 2 0.02/sqrt(2)
  states("lg of the best", std::log10(best), 1, std::sqrt(hardly_told(0.02) / 0.1), "known top");
}

TEST(Optimise, keeps_within_a_limit_and_says_that_it_binds) {
  // Maximises 3 x, while another outcome, x^2, must stay below 0.36.
  const NoisySimulation both{{[](const DesignPoint& x) { return 3 * x[0]; },
                              [](const DesignPoint& x) { return x[0] * x[0]; }},
                             0.02};
  const Optimum found =
      optimise({.keys = 1, .bounds = {{.below = true, .value = 0.36}}, .settings = 20}, both);
  ASSERT_TRUE(found.best);
  const double place = found.trials[*found.best].point[0];
  const double noise = hardly_told(0.02) / 1.2;  // of x^2, which has a slope of 1.2 there
  states("best tried", place, 0.6, noise, "3 x with x^2 < 0.36");
  states("model's best", found.model_point[0], 0.6, noise, "3 x with x^2 < 0.36");
  EXPECT_TRUE(found.limits[0].binds);
  EXPECT_FALSE(found.keys[0].at_high_end);
  EXPECT_LE(found.keys[0].low, 0.6);
  EXPECT_GE(found.keys[0].high, 0.6);
  const Optimum free =
      optimise({.keys = 1, .bounds = {{.below = true, .value = 2}}, .settings = 20}, both);
  EXPECT_FALSE(free.limits[0].binds);
  EXPECT_TRUE(free.keys[0].at_high_end);
}

TEST(Optimise, says_where_no_setting_is_allowed) {
  const NoisySimulation both{{hill, [](const DesignPoint& x) { return x[0]; }}, 0.01};
  const Optimum found =
      optimise({.keys = 1, .bounds = {{.below = false, .value = 2}}, .settings = 12}, both);
  EXPECT_FALSE(found.best);
  for (const Trial& t : found.trials) EXPECT_LT(t.probability_feasible, 0.5);
}

TEST(Optimise, stays_out_of_a_corner_that_fails) {
  NoisySimulation corner{{[](const DesignPoint& x) { return x[0] + x[1]; }}, 0.02};
  corner.fails = [](const DesignPoint& x) { return x[0] + x[1] > 1.4; };
  const Optimum found = optimise({.keys = 2, .settings = 40}, corner);
  ASSERT_TRUE(found.best);
  const DesignPoint& point = found.trials[*found.best].point;
  EXPECT_LE(point[0] + point[1], 1.4);
  stays_below("lost", 1.4 - point[0] - point[1], 0.1, "the edge is seen only by failures");
  EXPECT_GT(found.failed, 0);
  EXPECT_EQ(found.failed, std::ranges::count_if(
                              found.trials, [](const Trial& t) { return t.failure == "too far"; }));
}

TEST(Optimise, says_that_nothing_ran) {
  NoisySimulation nothing{{hill}, 0.1};
  nothing.fails = [](const DesignPoint&) { return true; };
  const Optimum found = optimise({.keys = 1, .settings = 10}, nothing);
  EXPECT_EQ(found.stop_reason, StopReason::failed);
  EXPECT_FALSE(found.best);
  EXPECT_EQ(found.failed, 10);
}

TEST(Optimise, leaves_out_replicates_without_an_outcome) {
  NoisySimulation gaps{{hill}, 0.05};
  gaps.is_missing = [](const TrialRequest& one, int replicate) {
    return (one.setting + replicate) % 3 == 0;
  };
  const Optimum found = optimise({.keys = 1, .settings = 16}, gaps);
  stays_below("lost", 1 - hill(found.trials[*found.best].point), hardly_told(0.05), "known top");
}

TEST(Optimise, says_that_a_key_does_nothing) {
  const Optimum found =
      optimise({.keys = 2, .settings = 24},
               NoisySimulation{{[](const DesignPoint& x) { return 5 + hill(x); }}, 0.02});
  EXPECT_FALSE(found.keys[0].flat);  // 2 % of 6 is lost at a distance of 0.17 from the top
  EXPECT_TRUE(found.keys[1].flat);
  states("good from", found.keys[0].good_low, 0.37 - std::sqrt(0.03), 0.06, "hill is 0.12 lower");
  EXPECT_GT(found.keys[1].high - found.keys[1].low, 0.7);
}

TEST(Optimise, finds_a_plateau_flat) {
  const Optimum found = optimise({.keys = 1, .settings = 12},
                                 NoisySimulation{{[](const DesignPoint&) { return 3.0; }}, 0.01});
  EXPECT_TRUE(found.keys[0].flat);
  EXPECT_GT(found.keys[0].high - found.keys[0].low, 0.7);
  EXPECT_EQ(found.stop_reason, StopReason::converged);
}

TEST(Optimise, sees_the_edge_of_a_range) {
  const Optimum found =
      optimise({.keys = 1, .settings = 12},
               NoisySimulation{{[](const DesignPoint& x) { return 2 * x[0]; }}, 0.1});
  EXPECT_TRUE(found.keys[0].at_high_end);
  EXPECT_FALSE(found.keys[0].at_low_end);
  EXPECT_GT(found.keys[0].high, 0.999);
}

TEST(Optimise, answers_the_same_for_any_number_of_jobs) {
  const Goal goal{.keys = 2, .settings = 16};
  NoisySimulation noisy{{[](const DesignPoint& x) { return hill(x) - std::pow(x[1] - 0.8, 2); }},
                        0.05};
  noisy.jobs = 1;
  const Optimum one = optimise(goal, noisy);
  for (const int jobs : {2, 7}) {
    noisy.jobs = jobs;
    const Optimum other = optimise(goal, noisy);
    ASSERT_EQ(other.trials.size(), one.trials.size());
    for (std::size_t i = 0; i < one.trials.size(); ++i) {
      EXPECT_EQ(other.trials[i].point, one.trials[i].point);
      EXPECT_EQ(other.trials[i].replicates, one.trials[i].replicates);
    }
    EXPECT_EQ(other.model_point, one.model_point);
    EXPECT_EQ(other.keys[1].low, one.keys[1].low);
  }
}

TEST(Optimise, runs_only_places_that_there_are) {
  Goal goal{.keys = 1, .settings = 16};
  goal.snap = [](const DesignPoint& x) { return DesignPoint{std::round(5 * x[0]) / 5}; };
  const Optimum found = optimise(goal, NoisySimulation{{hill}, 0.05});
  EXPECT_EQ(found.trials[*found.best].point[0], 0.4);
  EXPECT_LE(found.trials.size(), 6U);
  for (const Trial& t : found.trials) EXPECT_EQ(t.point[0], std::round(5 * t.point[0]) / 5);
}

TEST(Optimise, refuses_a_goal_out_of_its_ranges) {
  const NoisySimulation noisy{{hill}, 0.1};
  EXPECT_THROW(optimise({.keys = 0}, noisy), std::invalid_argument);
  EXPECT_THROW(optimise({.keys = 9}, noisy), std::invalid_argument);
  EXPECT_THROW(optimise({.keys = 1, .replicates = 1}, noisy), std::invalid_argument);
  EXPECT_THROW(optimise({.keys = 1},
                        [](const std::vector<TrialRequest>&) -> std::vector<TrialResult> {
                          throw std::runtime_error("stopped");
                        }),
               std::runtime_error);
}

TEST(Optimise, intervals_hold_the_truth_as_often_as_they_claim) {
  // Intervals of the optimum are somewhat too wide: the prior of the model is rougher than a hill.
  constexpr int times = 200;
  int place = 0;
  for (int seed = 0; seed < times; ++seed) {
    NoisySimulation noisy{{hill}, 0.1};
    noisy.seed = static_cast<std::uint64_t>(seed);
    const Optimum found =
        optimise({.keys = 1, .settings = 16, .seed = static_cast<std::uint64_t>(seed)}, noisy);
    place += found.keys[0].low <= 0.37 && 0.37 <= found.keys[0].high ? 1 : 0;
  }
  std::printf("    intervals of the place that hold, of %d: %d\n", times, place);
  EXPECT_GE(place, 0.95 * times - 3.3 * std::sqrt(times * 0.95 * 0.05));
}

}  // namespace
}  // namespace mahlwerk::campaign::optimise_test

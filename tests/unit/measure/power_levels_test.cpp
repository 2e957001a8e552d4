// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/power_levels.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/error.hpp"
#include "noise.hpp"

namespace mahlwerk::measure::power_levels_test {
namespace {

/// A log: standby, idle, standby, loaded.
std::vector<double> log_of(double idle, double load, double noise) {
  std::vector<double> log;
  tests::Noise scatter(4, noise, 0.8);
  for (int i = 0; i < 300; ++i) {
    const double level = i < 20 ? 3 : i < 120 ? idle : i < 130 ? 3 : load;
    log.push_back(level + scatter());
  }
  return log;
}

TEST(PowerLevel, has_an_interval_that_holds_the_truth_in_95_of_100_logs) {
  int held = 0;
  constexpr int logs = 300;
  for (int i = 0; i < logs; ++i) {
    tests::Noise scatter(static_cast<std::uint64_t>(i + 1), 2, 0.8);
    std::vector<double> log;
    for (int k = 0; k < 300; ++k) log.push_back(120 + scatter());
    const PowerLevel level = power_level(log);
    held += std::abs(level.power.mean - 120) <= level.power.ci95;
  }
  EXPECT_GT(held, 0.92 * logs);
}

TEST(PowerLevel, is_not_moved_by_a_few_wrong_readings) {
  std::vector<double> log(100, 50.0);
  log[3] = log[40] = 5000;
  EXPECT_EQ(power_level(log).power.mean, 50);
}

TEST(PowerLevel, of_a_coarse_meter_is_no_sharper_than_its_steps) {
  std::vector<double> log;
  for (int i = 0; i < 100; ++i) log.push_back(i % 3 == 0 ? 51 : 50);
  EXPECT_GE(power_level(log).power.ci95, 0.5);
}

TEST(PowerLevel, that_drifts_says_so) {
  std::vector<double> log;
  for (int i = 0; i < 100; ++i) log.push_back(100 + 0.1 * i);
  EXPECT_NEAR(power_level(log).drift, 9.9, 1e-6);
  EXPECT_EQ(power_level(std::vector<double>(100, 50.0)).drift, 0);
}

TEST(TwoLevels, of_a_log_are_idle_and_loaded) {
  const TwoLevels levels = two_levels(log_of(120, 141, 1));
  EXPECT_NEAR(power_level(levels.idle).power.mean, 120, 1);
  EXPECT_NEAR(power_level(levels.load).power.mean, 141, 1);
  EXPECT_GT(levels.idle.size(), 80U);
}

TEST(TwoLevels, that_are_not_there_are_refused) {
  EXPECT_THROW(two_levels(log_of(120, 120, 1)), InputError);
  EXPECT_THROW(two_levels(log_of(120, 121, 1)), InputError);
  EXPECT_THROW(two_levels({}), InputError);
  EXPECT_THROW(power_level(std::vector<double>(9, 1.0)), InputError);
}

}  // namespace
}  // namespace mahlwerk::measure::power_levels_test

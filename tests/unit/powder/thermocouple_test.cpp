// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/thermocouple.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::thermocouple_test {
namespace {

using tests::states;

TEST(Thermocouple, lags_behind_a_ramp_by_its_time_constant) {
  const std::vector<double> times{0, 30, 31, 100}, around{300, 360, 362, 500};  // 2 K/s
  const std::vector<double> shown = thermocouple_readings(times, around, 10);
  for (std::size_t i = 0; i < times.size(); ++i)
    states("reading [K]", shown[i], around[i] - 20 * (1 - math::exp(-times[i] / 10)), 1e-10,
           "ramp: slope times lag behind (sns.8)");
}

TEST(Thermocouple, shows_63_percent_of_a_step_after_its_time_constant) {
  const std::vector<double> shown = thermocouple_readings(
      std::vector<double>{0, 0, 10, 1e6}, std::vector<double>{300, 400, 400, 400}, 10);
  states("before [K]", shown[1], 300, 0, "a step takes no time");
  states("after one time constant [K]", shown[2], 400 - 100 * math::exp(-1.0), 1e-10, "(sns.8)");
  states("at the end [K]", shown[3], 400, 1e-10, "(sns.8)");
}

TEST(Thermocouple, without_lag_shows_what_is_there) {
  const std::vector<double> times{0, 1, 1, 2}, around{300, 310, 400, 390};
  EXPECT_EQ(thermocouple_readings(times, around, 0), around);
  EXPECT_TRUE(thermocouple_readings({}, {}, 5).empty());
}

TEST(GasTemperature, is_the_mean_by_area) {
  states("gas [K]", gas_temperature(400, 1, 300, 3), 325, 1e-12, "(sns.7)");
}

}  // namespace
}  // namespace mahlwerk::powder::thermocouple_test

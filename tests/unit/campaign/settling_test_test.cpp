// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// When a mill counts as settled (sta.9), and what is counted then (sta.10).
#include "mahlwerk/campaign/run/settling_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::settling_test_test {
namespace {

/// Power of a block, from its number.
using PowerOfBlock = std::function<double(int)>;

/// The first number of blocks after which the test finds no trend; `most` if there is none.
int settles_after(const PowerOfBlock& lost, const PowerOfBlock& drawn, int most = 200) {
  SettlingTest test;
  scene::EnergyBalance balance;
  test.add(balance, 0);
  std::int64_t hits = 0;
  for (int n = 0; n < most; ++n) {
    balance.time += 1;
    balance.lost_normal += lost(n);
    balance.wall_work += drawn(n);
    test.add(balance, hits += 100);
    if (test.settled()) return test.blocks();
  }
  return most;
}

TEST(SettlingTest, a_constant_power_has_settled_after_the_least_number_of_blocks) {
  const PowerOfBlock one = [](int) { return 1.0; };
  EXPECT_EQ(settles_after(one, one), cases::SettlingBlocks::least);
}

TEST(SettlingTest, a_mill_in_which_nothing_happens_has_settled) {
  const PowerOfBlock none = [](int) { return 0.0; };
  EXPECT_EQ(settles_after(none, none), cases::SettlingBlocks::least);
}

TEST(SettlingTest, energy_stored_at_a_constant_rate_is_a_trend_however_long) {
  EXPECT_EQ(settles_after([](int) { return 0.0; }, [](int) { return 1.0; }), 200);
  EXPECT_EQ(settles_after([](int) { return 0.8; }, [](int) { return 1.0; }), 200);
}

TEST(SettlingTest, a_power_that_decays_settles_once_its_change_is_small) {
  // 1 + 3 exp(-n/tau): over the second half of n blocks it changes by less than 10 % of its mean
  // once 3 exp(-n/(2 tau)) < 0.1, after 6.8 tau; the noise of 2 % hides a little more.
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.02);
  for (const double tau : {3.0, 6.0, 10.0}) {
    const PowerOfBlock power = [&](int n) { return 1 + 3 * std::exp(-n / tau) + noise(random); };
    const int after = settles_after(power, power);
    EXPECT_GE(after, 4 * tau) << tau;
    EXPECT_LE(after, 1.3 * 6.8 * tau) << tau;
  }
}

TEST(SettlingTest, noise_alone_seldom_delays_counting) {
  std::mt19937 random(7);
  std::exponential_distribution<double> power(1);
  int late = 0;
  for (int run = 0; run < 200; ++run) {
    const PowerOfBlock noise = [&](int) { return power(random); };
    const double mean = 1;
    late += settles_after(noise, [&](int) { return mean; }) > 15 ? 1 : 0;
  }
  EXPECT_LE(late, 60);
}

cases::Case with_run(const std::string& mill, const std::string& run) {
  return cases::read_text("[mill]\n" + mill +
                              "\n[jar]\nkind = \"cylinder\"\ndiameter = \"100 mm\"\nheight = "
                              "\"100 mm\"\n[[balls]]\ncount = 5\ndiameter = \"10 mm\"\ndensity = "
                              "\"7800 kg/m3\"\n[run]\n" +
                              run,
                          "case.toml", cases::sample::catalogue());
}

TEST(CountedTime, is_whole_periods_and_three_turns_of_a_drum) {
  const std::string drum = "kind = \"tumbling\"\nspeed = \"30 rpm\"",
                    shaken = "kind = \"vibration\"\nfrequency = \"20 Hz\"\namplitude = \"5 mm\"";
  EXPECT_NEAR(cases::counted_time(with_run(drum, "time = \"1 s\"")), 6, 1e-9);
  EXPECT_NEAR(cases::counted_time(with_run(drum, "time = \"6.5 s\"")), 8, 1e-9);
  EXPECT_EQ(cases::counted_time(with_run(drum, "time = \"1 s\"\nsettle = \"0 s\"")), 1);
  EXPECT_NEAR(cases::counted_time(with_run(shaken, "time = \"0.12 s\"")), 0.15, 1e-12);
  EXPECT_EQ(cases::counted_time(with_run(shaken, "time = \"1 s\"\nsettle = \"auto\"")), 1);
}

TEST(CountedTime, of_a_jar_at_rest_begins_at_once) {
  const cases::Case still = with_run("kind = \"still\"", "time = \"1 s\"");
  EXPECT_FALSE(cases::settles(still));
  EXPECT_EQ(cases::least_settling(still), 0);
  EXPECT_EQ(cases::counted_time(still), 1);
}

TEST(ExpectedTime, is_a_tenth_of_the_default_limit_where_a_precision_ends_the_run) {
  const std::string shaken = "kind = \"vibration\"\nfrequency = \"20 Hz\"\namplitude = \"5 mm\"";
  const cases::Case until = with_run(shaken, "time = \"until 2 %\""),
                    limited = with_run(shaken, "time = \"until 2 %\"\nlongest = \"30 s\""),
                    given = with_run(shaken, "time = \"1 s\"");
  EXPECT_DOUBLE_EQ(cases::expected_time(until), 10);
  EXPECT_EQ(cases::expected_time(limited), 30);
  EXPECT_EQ(cases::expected_time(given), cases::counted_time(given));
}

}  // namespace
}  // namespace mahlwerk::campaign::settling_test_test

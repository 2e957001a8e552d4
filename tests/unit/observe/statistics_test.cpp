// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::statistics_test {
namespace {

using tests::states;
using tests::stays_below;

TEST(Student95, is_that_of_the_printed_tables) {
  // Abramowitz & Stegun, table 26.10, and the same to more digits.
  const std::pair<int, double> printed[] = {
      {1, 12.70620474}, {2, 4.30265273},  {3, 3.18244631},  {4, 2.77644511},  {5, 2.57058184},
      {9, 2.26215716},  {10, 2.22813885}, {29, 2.04522964}, {30, 2.04227246}, {31, 2.03951345},
      {40, 2.02107539}, {60, 2.00029782}, {120, 1.97993041}};
  for (const auto& [freedom, t] : printed) EXPECT_NEAR(student95(freedom), t, 1e-6) << freedom;
  EXPECT_NEAR(student95(1000000), 1.95996636, 1e-7);
}

TEST(Student95, falls_all_the_way) {
  for (int n = 1; n < 200; ++n) EXPECT_GT(student95(n), student95(n + 1)) << n;
}

TEST(Estimate, is_mean_and_student_half_width) {
  const Estimate e = estimate({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(e.mean, 3);
  EXPECT_NEAR(e.ci95, 2.77644511 * std::sqrt(2.5 / 5), 1e-7);
}

TEST(Estimate, of_one_replicate_knows_no_width) {
  const Estimate e = estimate({7});
  EXPECT_EQ(e.mean, 7);
  EXPECT_TRUE(std::isnan(e.ci95));
}

TEST(Estimate, of_no_replicate_is_unknown) {
  const Estimate e = estimate({});
  EXPECT_TRUE(std::isnan(e.mean) && std::isnan(e.ci95));
}

TEST(Estimate, of_equal_values_is_sharp) {
  const Estimate e = estimate({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(e.mean, 0.5);
  EXPECT_EQ(e.ci95, 0);
  EXPECT_EQ(estimate({0.1, 0.1, 0.1}).ci95, 0) << "though a third of 0.1 is not exact";
}

/// Normal numbers, two at a time (Box and Muller 1958).
class Normal {
 public:
  explicit Normal(std::uint32_t stream) : random_(1958, stream) {}
  double next() {
    if (kept_) return *std::exchange(kept_, std::nullopt);
    const double size = std::sqrt(-2 * std::log(random_.uniform()));
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    kept_ = size * std::sin(angle);
    return size * std::cos(angle);
  }

 private:
  Random random_;
  std::optional<double> kept_;
};

/// Values of mean 5 and variance 1, each correlated with its neighbour by `phi` (AR(1)).
std::vector<double> correlated(double phi, std::size_t count, std::uint32_t stream) {
  Normal normal(stream);
  std::vector<double> values{normal.next()};
  while (values.size() < count)
    values.push_back(phi * values.back() + std::sqrt(1 - phi * phi) * normal.next());
  for (double& v : values) v += 5;
  return values;
}

constexpr std::uint32_t trials = 4000;

/// Share of trials with the true mean in the interval.
double coverage(double phi, std::size_t count) {
  int held = 0;
  for (std::uint32_t trial = 0; trial < trials; ++trial) {
    const Estimate e = time_series_estimate(correlated(phi, count, trial));
    if (std::abs(e.mean - 5) <= e.ci95) ++held;
  }
  return static_cast<double>(held) / trials;
}

constexpr double by_chance = 3 * 0.00345;  // three standard errors, sqrt(0.95 0.05/trials)

TEST(OverTime, holds_the_true_mean_in_95_of_100_series) {
  for (const double phi : {0.0, 0.3, 0.6})
    states("share of 200 values correlated by " + std::to_string(phi).substr(0, 3),
           coverage(phi, 200), 0.95, by_chance, "sta.3, sta.4");
}

/// 200 values of phi = 0.8 are worth k = 200 (1 - phi)/(1 + phi) = 22 independent ones. The
/// correlation that widens the interval is known to 1/sqrt(k) (Bartlett 1946), and so is the width.
/// If widths scatter by the share s, coverage is lower by
/// z^3 exp(-z^2/2)/sqrt(2 pi) s^2 = 0.44 s^2.
TEST(OverTime, misses_little_where_values_are_worth_few_independent_ones) {
  states("share of 200 values correlated by 0.8", coverage(0.8, 200), 0.95 - 0.44 / 22, by_chance,
         "sta.4");
}

TEST(OverTime, without_its_allowance_would_be_too_sure) {
  int held = 0;
  for (std::uint32_t trial = 0; trial < trials; ++trial) {
    const Estimate e = estimate(correlated(0.8, 200, trial));
    if (std::abs(e.mean - 5) <= e.ci95) ++held;
  }
  states("share held by values taken as independent", static_cast<double>(held) / trials,
         std::erf(1.972 / 3 / std::numbers::sqrt2), 0.034,
         "the mean scatters sqrt((1 + 0.8)/(1 - 0.8)) = 3 times as much; three standard errors, "
         "and 0.01 for a scatter that is seen 2 % too small");
}

TEST(OverTime, of_few_or_equal_values) {
  EXPECT_TRUE(std::isnan(time_series_estimate({1, 2, 3, 4, 5, 6, 7, 8, 9}).ci95));
  EXPECT_EQ(time_series_estimate({1, 2, 3, 4, 5, 6, 7, 8, 9}).mean, 5);
  EXPECT_EQ(time_series_estimate(std::vector<double>(100, 0.1)).ci95, 0);
}

TEST(Trend, of_a_straight_line_is_its_rise) {
  std::vector<double> line;
  for (int i = 0; i < 10; ++i) line.push_back(3 - 0.5 * i);
  const Trend found = trend(line);
  states("mean", found.mean, 3 - 0.5 * 4.5, 1e-13, "that of the middle");
  states("change", found.change, -4.5, 1e-13, "nine steps of -0.5");
  states("scatter", found.scatter, 0, 1e-13, "none");
  states("half-width", found.ci95, 0, 1e-13, "none");
}

/// +1, -1, -1, +1 has neither a mean nor a slope: it scatters about the line.
TEST(Trend, has_the_half_width_of_the_scatter_about_the_line) {
  std::vector<double> values{2 + 1, 5 - 1, 8 - 1, 11 + 1};
  const Trend found = trend(values);
  states("mean", found.mean, 6.5, 1e-13, "that of the line");
  states("change", found.change, 9, 1e-13, "three steps of 3");
  states("scatter", found.scatter, std::sqrt(2), 1e-13, "four squares, two degrees of freedom");
  states("half-width", found.ci95, 4.302652729911275 * std::sqrt(2) / std::sqrt(5) * 3, 1e-9,
         "(sta.9): sum of squared places 2 (1.5^2 + 0.5^2) = 5");
}

TEST(Unsettled, finds_a_start_that_decays) {
  constexpr std::uint32_t few = 400;
  double found = 0;
  int none = 0;
  for (std::uint32_t trial = 0; trial < few; ++trial) {
    std::vector<double> values = correlated(0, 200, trial);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += 20 * std::exp(-static_cast<double>(i) / 10);
    const auto first = transient_length(values);
    found += static_cast<double>(first) / few;
    if (first == 0) ++none;
  }
  EXPECT_EQ(none, 0);
  // Leaving out one more batch of 5, at i, pays while the square of its excess exceeds the sum of
  // the variance of a batch's mean, 1/5, and a mean over the rest of about 1/5:
  // 20 exp(-i/10) = 0.6.
  states("values left out, mean", found, 10 * std::log(20 / 0.6), 15, "sta.5; three batches");
}

TEST(Unsettled, finds_nothing_in_most_series_that_keep_their_character) {
  constexpr std::uint32_t few = 400;
  int settled = 0, half = 0;
  for (std::uint32_t trial = 0; trial < few; ++trial) {
    const auto first = transient_length(correlated(0, 200, trial));
    if (first <= 20) ++settled;
    if (first >= 100) ++half;
  }
  EXPECT_GT(settled, few / 2);
  stays_below("share called not settled at all", static_cast<double>(half) / few, 0.1, "sta.5");
}

}  // namespace
}  // namespace mahlwerk::observe::statistics_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "statement.hpp"
#include "unit/campaign/sensitivity.hpp"

namespace mahlwerk::campaign::sensitivity_test {
namespace {

using tests::states;
using tests::stays_below;

TEST(ElementaryEffects, are_exact_for_a_line) {
  const DesignMatrix rows = morris_design(3, 10, 1);
  const auto found = elementary_effects(
      rows, outcomes(rows, [](const Values& x) { return 5 + 2 * x[0] - 3 * x[1]; }), {});
  const std::array slope{2.0, -3.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Effect& key = found.effects[i];
    const double rounding = 1e-14;  // outcomes of 10 are rounded to 2e-15, steps are 2/3
    states("mu", key.mean.value, slope[i], rounding, "slope");
    states("mu*", key.mean_absolute.value, std::abs(slope[i]), rounding, "slope");
    states("sigma", key.deviation.value, 0, rounding, "a line does not bend");
    stays_below("half-width", half_width(key.mean_absolute), rounding, "nothing scatters");
    EXPECT_EQ(key.count, 10U);
    EXPECT_TRUE(std::isnan(key.of_noise));
  }
}

TEST(ElementaryEffects, know_what_keys_do_together_and_their_intervals_hold) {
  // For y = (x1 - 1/2) x2 the effect of key 1 is x2: 0, 1/3, 2/3 or 1, so mu is 1/2 and sigma^2 is
  // the mean square of +-1/2, +-1/6. The effect of key 2 is +-1/2 or +-1/6: mu is 0, mu* is 1/3.
  constexpr int times = 200, ways = 40;
  const double sigma = std::sqrt(5.0 / 36);
  std::array<int, 4> held{};
  for (std::uint64_t seed = 0; seed < times; ++seed) {
    const DesignMatrix rows = morris_design(2, ways, seed);
    const auto found = elementary_effects(
        rows, outcomes(rows, [](const Values& x) { return (x[0] - 0.5) * x[1]; }), {});
    const auto holds = [](const observe::IntervalEstimate& s, double truth) {
      return s.low <= truth && truth <= s.high;
    };
    held[0] += holds(found.effects[0].mean, 0.5);
    held[1] += holds(found.effects[0].deviation, sigma);
    held[2] += holds(found.effects[1].mean, 0);
    held[3] += holds(found.effects[1].mean_absolute, 1.0 / 3);
  }
  const double tolerance = 3.3 * std::sqrt(times * 0.95 * 0.05);
  for (const int h : held)
    states("intervals that hold, of 200", h, 0.95 * times, tolerance, "binomial");
}

TEST(ElementaryEffects, of_noise_alone_are_what_errors_give) {
  constexpr std::size_t ways = 4000;
  const DesignMatrix rows = morris_design(1, ways, 3);
  Random random(5, 1);
  const Values y = outcomes(rows, [&](const Values&) { return 0.3 * normal(random); });
  const auto found = elementary_effects(rows, y, Values(y.size(), 0.3));
  const Effect& key = found.effects[0];
  states("mu* of errors", key.of_noise, 0.3 * 1.5 * 2 / std::sqrt(std::numbers::pi), 4000 * 1e-16,
         "mean size of a normal number");
  states("mu*", key.mean_absolute.value, key.of_noise, half_width(key.mean_absolute) * 3.3 / 1.96,
         "3.3 standard errors");
}

TEST(ElementaryEffects, of_noise_are_right_where_errors_come_from_two_replicates) {
  // The standard error of a mean of two values is half their difference. On average it is smaller
  // than the true error by sqrt(2/pi); its square is unbiased.
  constexpr std::size_t ways = 4000;
  const DesignMatrix rows = morris_design(1, ways, 3);
  Random random(5, 4);
  Values y, ci95;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double one = normal(random), other = normal(random), half = std::abs(one - other) / 2;
    y.push_back((one + other) / 2);
    ci95.push_back(std::tan(0.475 * std::numbers::pi) * half);  // Student's t_1 is Cauchy's law
  }
  const Values errors = standard_errors(y, ci95, Values(y.size(), 2));
  const auto found = elementary_effects(rows, y, errors);
  // A square of one degree of freedom scatters by sqrt(2) of its mean, a square root by half of
  // that.
  const double alone = 3.3 * found.effects[0].of_noise * std::sqrt(2.0 / (2 * ways)) / 2;
  states("mu*", found.effects[0].mean_absolute.value, found.effects[0].of_noise,
         std::hypot(alone, half_width(found.effects[0].mean_absolute) * 3.3 / 1.96),
         "3.3 standard errors");
}

TEST(ElementaryEffects, are_told_if_surely_more_than_noise_makes) {
  const DesignMatrix rows = morris_design(3, 10, 1);
  Random random(5, 5);
  const Values y = outcomes(rows, [&](const Values& x) { return 100 * x[0] + normal(random); });
  const auto found = elementary_effects(rows, y, Values(y.size(), 1.0)),
             errors_unknown = elementary_effects(rows, y, {});
  EXPECT_EQ(found.effects[0].significant, std::optional(true));
  EXPECT_EQ(found.effects[1].significant, std::optional(false));
  EXPECT_EQ(errors_unknown.effects[0].significant, std::nullopt);

  // One trajectory has no interval. An effect below the noise is not significant; whether one above
  // it is significant is unknown.
  const auto one = elementary_effects({{0}, {2.0 / 3}}, {1, 5}, {1, 1});
  EXPECT_TRUE(std::isnan(one.effects[0].mean_absolute.low));
  EXPECT_EQ(one.effects[0].significant, std::nullopt);
  EXPECT_EQ(elementary_effects({{0}, {2.0 / 3}}, {1, 1.1}, {1, 1}).effects[0].significant,
            std::optional(false));
}

TEST(ElementaryEffects, say_which_key_changes_nothing) {
  const DesignMatrix rows = morris_design(2, 5, 1);
  const Values y = outcomes(rows, [](const Values& x) { return std::exp(x[0]); });
  const auto found = elementary_effects(rows, y, {});
  EXPECT_FALSE(found.effects[0].inactive);
  EXPECT_TRUE(found.effects[1].inactive);
  EXPECT_EQ(found.effects[1].significant, std::optional(false));
  EXPECT_FALSE(elementary_effects(rows, Values(y.size(), nan), {}).effects[1].inactive)
      << "not known";
}

TEST(ElementaryEffects, leave_out_steps_that_failed) {
  const DesignMatrix rows = morris_design(2, 4, 1);
  Values y = outcomes(rows, [](const Values& x) { return x[0]; });
  y[1] = nan;  // the middle of the first trajectory: both of its steps
  y[3] = nan;  // the start of the second trajectory: its first step
  const auto found = elementary_effects(rows, y, {});
  EXPECT_EQ(found.failed, 2);
  EXPECT_EQ(found.effects[0].count + found.effects[1].count, 8U - 3);
  const auto nothing = elementary_effects(rows, Values(12, nan), {});
  EXPECT_TRUE(std::isnan(nothing.effects[0].mean.value));
  EXPECT_EQ(nothing.effects[1].count, 0U);
  EXPECT_THROW(elementary_effects(rows, Values(11), {}), std::invalid_argument);
}

TEST(Swings, are_what_each_key_does_alone) {
  const Sensitivity found = one_at_a_time_effects({5, 4, 6, 5.2, 5.3}, {0.1, 0.2, 0.2, 0.3, 0.3});
  EXPECT_EQ(found.base.value, 5);
  ASSERT_EQ(found.effects.size(), 2U);
  EXPECT_EQ(found.effects[0].low.value, 4);
  EXPECT_DOUBLE_EQ(found.effects[0].high.high, 6.2);
  EXPECT_EQ(found.effects[0].significant, std::optional(true));
  EXPECT_EQ(found.effects[1].significant,
            std::optional(false));  // 0.3 is less than sqrt(0.1^2 + 0.3^2)
  const Sensitivity failed = one_at_a_time_effects({5, nan, 6}, {});
  EXPECT_EQ(failed.failed, 1);
  EXPECT_TRUE(std::isnan(failed.effects[0].low.value));
  EXPECT_EQ(failed.effects[0].significant, std::nullopt);
  EXPECT_THROW(one_at_a_time_effects({1, 2}, {}), std::invalid_argument);
}

TEST(Swings, are_compared_with_the_case_itself) {
  // The ends differ by 2, more than sqrt(1 + 1). Both differ from the case by 1, which is less.
  EXPECT_EQ(one_at_a_time_effects({5, 4, 6}, {1, 1, 1}).effects[0].significant,
            std::optional(false));
  EXPECT_EQ(one_at_a_time_effects({5, 4, 6}, {0.1, 1, 0.1}).effects[0].significant,
            std::optional(true))
      << "the high end";
}

TEST(Swings, are_not_judged_without_intervals) {
  EXPECT_EQ(one_at_a_time_effects({5, 4, 6}, {}).effects[0].significant, std::nullopt);
  EXPECT_EQ(one_at_a_time_effects({5, 4, 6}, {nan, 0.1, 0.1}).effects[0].significant, std::nullopt);
  EXPECT_EQ(one_at_a_time_effects({5, 5.1, 6}, {1, 1, nan}).effects[0].significant, std::nullopt)
      << "the other may differ";
  EXPECT_EQ(one_at_a_time_effects({5, 9, 6}, {1, 1, nan}).effects[0].significant,
            std::optional(true));
}

TEST(Swings, say_which_key_changes_nothing) {
  const Sensitivity found = one_at_a_time_effects({5, 5, 5, 5, 5.1, 5, nan}, {});
  EXPECT_TRUE(found.effects[0].inactive);
  EXPECT_FALSE(found.effects[1].inactive);
  EXPECT_FALSE(found.effects[2].inactive) << "a failed run tells nothing";
}

TEST(StandardErrors, are_half_widths_over_students_quantile) {
  const double t1 = std::tan(0.475 * std::numbers::pi);  // Cauchy's law
  const double t2 = 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95));
  const Values found = standard_errors({1, 2, 3}, {t1, 2 * t2, 2}, {2, 3, 1});
  ASSERT_EQ(found.size(), 3U);
  states("of two replicates", found[0], 1, 1e-9, "closed form of Student's quantile");
  states("of three", found[1], 2, 1e-9, "closed form");
  states("of one, over time", found[2], 1, 0.131, "t_95 of 10 batches is 2.262, of many 1.960");
}

TEST(StandardErrors, are_unknown_where_one_is_missing) {
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, nan}, {2, 2}).empty());
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, 0.1}, {2, nan}).empty());
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, 0.1}, {}).empty());
  EXPECT_EQ(standard_errors({1, nan}, {0.1, nan}, {2, nan}).size(), 2U)
      << "a failed run needs none";
  EXPECT_THROW(standard_errors({1, 2}, {0.1}, {2, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::campaign::sensitivity_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "mahlwerk/campaign/sweep/sensitivity.hpp"
#include "statement.hpp"
#include "unit/campaign/sensitivity.hpp"

namespace mahlwerk::campaign::variance_decomposition_test {
namespace {

using tests::states;
using tests::stays_below;

/// sin t1 + 7 sin^2 t2 + t3^4 sin(t1)/10 over -pi ... pi (Ishigami and Homma 1990).
double ishigami(const Values& x) {
  const auto t = [&](std::size_t i) { return std::numbers::pi * (2 * x[i] - 1); };
  return std::sin(t(0)) + 7 * std::pow(std::sin(t(1)), 2) +
         0.1 * std::pow(t(2), 4) * std::sin(t(0));
}

/// Variances of the Ishigami function, by hand: of key 1 alone, key 2 alone, and the interaction of
/// keys 1 and 3.
struct IshigamiParts {
  double first, second, together;
  double all() const { return first + second + together; }
};
IshigamiParts ishigami_parts() {
  const double p4 = std::pow(std::numbers::pi, 4);
  return {0.5 * std::pow(1 + 0.1 * p4 / 5, 2), 49.0 / 8, 0.01 * p4 * p4 * (1.0 / 18 - 1.0 / 50)};
}

/// The product of (|4 x - 2| + a)/(1 + a) (Sobol' 1993).
const std::array g_weights{0.0, 1.0, 4.5, 9.0, 99.0};
double g_function(const Values& x) {
  double product = 1;
  for (std::size_t i = 0; i < x.size(); ++i)
    product *= (std::abs(4 * x[i] - 2) + g_weights[i]) / (1 + g_weights[i]);
  return product;
}

TEST(VarianceDecomposition, are_those_of_ishigamis_function) {
  const Sensitivity found =
      variance_decomposition(3, outcomes(saltelli_design(3, 4096), ishigami), {});
  const IshigamiParts v = ishigami_parts();
  const std::array first{v.first / v.all(), v.second / v.all(), 0.0};
  const std::array total{(v.first + v.together) / v.all(), v.second / v.all(),
                         v.together / v.all()};
  for (std::size_t i = 0; i < 3; ++i) {  // Sobol' points are more accurate than their intervals
    const Effect& key = found.effects[i];
    states("first", key.first_order.value, first[i], half_width(key.first_order),
           "closed form; own interval");
    states("total", key.total.value, total[i], half_width(key.total), "closed form; own interval");
    stays_below("width", std::max(half_width(key.first_order), half_width(key.total)), 0.06,
                "sharp");
  }
  states("variance", found.variance, v.all(), 0.01 * v.all(), "closed form");
  EXPECT_EQ(found.failed, 0);
}

TEST(VarianceDecomposition, are_those_of_the_g_function) {
  const Sensitivity found =
      variance_decomposition(5, outcomes(saltelli_design(5, 4096), g_function), {});
  double all = 1;
  for (const double a : g_weights) all *= 1 + 1 / (3 * (1 + a) * (1 + a));
  for (std::size_t i = 0; i < 5; ++i) {
    const double own = 1 / (3 * (1 + g_weights[i]) * (1 + g_weights[i]));
    const Effect& key = found.effects[i];
    states("first", key.first_order.value, own / (all - 1), half_width(key.first_order),
           "closed form");
    states("total", key.total.value, own * all / (1 + own) / (all - 1), half_width(key.total),
           "closed form");
  }
}

TEST(VarianceDecomposition, intervals_hold_the_truth_as_often_as_they_claim) {
  // Points drawn at random, because Sobol' points are more accurate than the intervals suppose.
  constexpr int times = 200, base = 512;
  const IshigamiParts v = ishigami_parts();
  std::array<int, 4> held{};
  for (std::uint32_t t = 0; t < times; ++t) {
    Random random(11, t);
    DesignMatrix rows = saltelli_design(3, base);
    for (std::size_t g = 0; g < rows.size(); g += 5) {
      for (std::size_t i = 0; i < 3; ++i) rows[g][i] = random.uniform();
      for (std::size_t i = 0; i < 3; ++i) rows[g + 4][i] = random.uniform();
      for (std::size_t i = 0; i < 3; ++i) (rows[g + 1 + i] = rows[g])[i] = rows[g + 4][i];
    }
    const Sensitivity found = variance_decomposition(3, outcomes(rows, ishigami), {}, t);
    const auto holds = [](const observe::IntervalEstimate& s, double truth) {
      return s.low <= truth && truth <= s.high;
    };
    held[0] += holds(found.effects[0].first_order, v.first / v.all());
    held[1] += holds(found.effects[2].first_order, 0);
    held[2] += holds(found.effects[1].total, v.second / v.all());
    held[3] += holds(found.effects[2].total, v.together / v.all());
  }
  const double tolerance = 3.3 * std::sqrt(times * 0.95 * 0.05);
  for (const int h : held)
    states("intervals that hold, of 200", h, 0.95 * times, tolerance, "binomial");
}

TEST(VarianceDecomposition, leave_out_what_hangs_on_failed_runs) {
  const DesignMatrix rows = saltelli_design(3, 2048);
  Values y = outcomes(rows, ishigami);
  y[0] = nan;                                            // a of group 0: the whole group is lost
  y[5 + 2] = nan;                                        // key 1 in group 1
  for (std::size_t i = 1000; i < 1100; ++i) y[i] = nan;  // 20 groups
  const Sensitivity found = variance_decomposition(3, y, {});
  EXPECT_EQ(found.failed, 102);
  EXPECT_EQ(found.effects[0].count, 2048U - 21);
  EXPECT_EQ(found.effects[1].count, 2048U - 22);
  const IshigamiParts v = ishigami_parts();
  states("first", found.effects[1].first_order.value, v.second / v.all(),
         half_width(found.effects[1].first_order), "closed form");
  // Failed runs have no errors. That must not hide the errors of the other runs.
  const Values widths(y.size(), 0.1 * 1.96);
  const Values errors = standard_errors(y, widths, Values(y.size(), 1e6));
  ASSERT_EQ(errors.size(), y.size());
  EXPECT_TRUE(std::isnan(errors[0]));
  const Sensitivity known = variance_decomposition(3, y, errors);
  states("share of errors", known.noise, 0.01 / found.variance, 1e-4 * 0.01 / found.variance,
         "1.96 is right to 2e-5");
  EXPECT_EQ(known.effects[1].significant, std::optional(true));
}

TEST(VarianceDecomposition, are_free_of_the_share_of_errors) {
  // Errors comparable to the outcome's own spread: without a correction they look like a share of
  // every key.
  constexpr std::size_t base = 8192;
  const DesignMatrix rows = saltelli_design(2, base);
  Random random(5, 0);
  const double error = 0.5;
  Values y = outcomes(rows, [&](const Values& x) { return std::sqrt(12.0) * x[0]; });
  for (double& one : y) one += error * normal(random);
  const Values errors(y.size(), error);
  const Sensitivity found = variance_decomposition(2, y, errors),
                    raw = variance_decomposition(2, y, {});
  states("variance", found.variance, 1, 0.05, "of a uniform number times sqrt(12)");
  states("share of errors", found.noise, 0.2, 0.02, "0.25/1.25");
  const auto sure = [](const observe::IntervalEstimate& s) { return half_width(s) * 3.3 / 1.96; };
  states("total of the first", found.effects[0].total.value, 1, sure(found.effects[0].total), "1");
  states("total of the second", found.effects[1].total.value, 0, sure(found.effects[1].total), "0");
  states("without errors said", raw.effects[1].total.value, 0.2, sure(raw.effects[1].total),
         "0.25/1.25");
}

TEST(VarianceDecomposition, of_a_key_that_changes_nothing_are_zero_whatever_the_errors) {
  // Runs that differ only in an inactive key are the same run: their errors do not add up.
  Random random(5, 2);
  const DesignMatrix rows = saltelli_design(2, 64);
  Values y;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const bool same = row % 4 == 2;  // key 1 from b: same run as a, two rows before
    y.push_back(same ? y[row - 2] : 10 * rows[row][0] + normal(random));
  }
  const Sensitivity found = variance_decomposition(2, y, Values(y.size(), 1.0));
  EXPECT_FALSE(found.effects[0].inactive);
  EXPECT_EQ(found.effects[0].significant, std::optional(true));
  EXPECT_TRUE(found.effects[1].inactive);
  EXPECT_EQ(found.effects[1].significant, std::optional(false));
  EXPECT_EQ(found.effects[1].total.value, 0);
  EXPECT_EQ(found.effects[1].total.low, 0);
  EXPECT_EQ(found.effects[1].first_order.high, 0);
}

TEST(VarianceDecomposition, of_noise_are_told_in_few_of200_designs) {
  // Key 0 has a large effect, key 1 none, but its runs have errors of their own. The whole interval
  // of a total index lies above the truth in 2.5 of 100 cases.
  constexpr int times = 200;
  constexpr double share = 0.025;
  const DesignMatrix rows = saltelli_design(2, 128);
  int first = 0, second = 0, unsure = 0;
  for (std::uint32_t t = 0; t < times; ++t) {
    Random random(17, t);
    const Values y = outcomes(rows, [&](const Values& x) { return 10 * x[0] + normal(random); });
    const Sensitivity found = variance_decomposition(2, y, Values(y.size(), 1.0), t);
    first += found.effects[0].significant == std::optional(true);
    second += found.effects[1].significant == std::optional(true);
    unsure += variance_decomposition(2, y, {}, t).effects[1].significant.value_or(false);
  }
  EXPECT_EQ(first, times);
  stays_below("told of noise", second, times * share + 3.3 * std::sqrt(times * share * (1 - share)),
              "binomial");
  EXPECT_EQ(unsure, 0) << "unknown errors may explain the effect";
}

TEST(VarianceDecomposition, are_not_told_where_the_outcome_hardly_varies_more_than_its_errors) {
  // Pure noise, with errors declared as all but a hundredth of the variance: many bootstrap samples
  // of the groups have less variance than that.
  Random random(5, 3);
  const DesignMatrix rows = saltelli_design(2, 64);
  const Values y = outcomes(rows, [&](const Values&) { return normal(random); });
  const double seen = variance_decomposition(2, y, {}).variance;
  const Sensitivity hardly = variance_decomposition(2, y, Values(y.size(), std::sqrt(0.99 * seen))),
                    less = variance_decomposition(2, y, Values(y.size(), std::sqrt(1.5 * seen)));
  states("share of errors", hardly.noise, 0.99, 1e-12, "as made");
  EXPECT_TRUE(std::isfinite(hardly.effects[0].total.value));
  EXPECT_TRUE(std::isnan(hardly.effects[0].total.low));
  EXPECT_EQ(hardly.effects[0].significant, std::optional(false));
  states("share of errors", less.noise, 1.5, 1e-12, "as made");
  EXPECT_LT(less.variance, 0);
  EXPECT_TRUE(std::isnan(less.effects[0].total.value));
  EXPECT_EQ(less.effects[0].significant, std::optional(false));
}

TEST(VarianceDecomposition, of_one_group_have_no_interval) {
  const Sensitivity found = variance_decomposition(1, {1, 2, 3}, {0.1, 0.1, 0.1});
  EXPECT_EQ(found.effects[0].count, 1U);
  EXPECT_TRUE(std::isfinite(found.effects[0].total.value));
  EXPECT_TRUE(std::isnan(found.effects[0].total.low));
  EXPECT_EQ(found.effects[0].significant, std::nullopt);
}

TEST(VarianceDecomposition, are_not_invented_where_nothing_varies) {
  const Sensitivity found = variance_decomposition(2, Values(40, 3.0), {});
  EXPECT_TRUE(std::isnan(found.effects[0].first_order.value));
  EXPECT_TRUE(std::isnan(found.effects[1].total.high));
  EXPECT_TRUE(
      std::isnan(variance_decomposition(2, Values(40, nan), {}).effects[0].first_order.value));
  EXPECT_TRUE(std::isnan(variance_decomposition(2, {}, {}).effects[0].total.value));
  EXPECT_THROW(variance_decomposition(2, Values(41, 3.0), {}), std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::campaign::variance_decomposition_test

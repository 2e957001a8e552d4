// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign {
namespace {

using tests::states;
using tests::stays_below;
using Values = std::vector<double>;
using Function = std::function<double(const Values&)>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double normal(Random& random) {
  const double size = std::sqrt(-2 * std::log(random.uniform()));
  return size * std::cos(random.uniform(0, 2 * std::numbers::pi));
}

Values outcomes(const Places& rows, const Function& f) {
  Values y;
  for (const Values& row : rows) y.push_back(f(row));
  return y;
}

/// sin t1 + 7 sin^2 t2 + t3^4 sin(t1)/10 over -pi ... pi (Ishigami and Homma 1990).
double ishigami(const Values& x) {
  const auto t = [&](std::size_t i) { return std::numbers::pi * (2 * x[i] - 1); };
  return std::sin(t(0)) + 7 * std::pow(std::sin(t(1)), 2) +
         0.1 * std::pow(t(2), 4) * std::sin(t(0));
}

/// Its variances, by hand: of key 1 alone, of key 2 alone, of keys 1 and 3 together beyond that.
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

double half_width(const Sure& s) {
  return std::max(s.high - s.value, s.value - s.low);
}

TEST(VarianceShares, AreThoseOfIshigamisFunction) {
  const VarianceShares found = variance_shares(3, outcomes(saltelli_design(3, 4096), ishigami), {});
  const IshigamiParts v = ishigami_parts();
  const std::array first{v.first / v.all(), v.second / v.all(), 0.0};
  const std::array total{(v.first + v.together) / v.all(), v.second / v.all(),
                         v.together / v.all()};
  for (std::size_t i = 0; i < 3; ++i) {  // Sobol's points are surer than the drawn anew tell
    const Shares& key = found.keys[i];
    states("first", key.first.value, first[i], half_width(key.first), "closed form; own interval");
    states("total", key.total.value, total[i], half_width(key.total), "closed form; own interval");
    stays_below("width", std::max(half_width(key.first), half_width(key.total)), 0.06, "sharp");
  }
  states("variance", found.variance, v.all(), 0.01 * v.all(), "closed form");
  EXPECT_EQ(found.failed, 0);
}

TEST(VarianceShares, AreThoseOfTheGFunction) {
  const VarianceShares found =
      variance_shares(5, outcomes(saltelli_design(5, 4096), g_function), {});
  double all = 1;
  for (const double a : g_weights) all *= 1 + 1 / (3 * (1 + a) * (1 + a));
  for (std::size_t i = 0; i < 5; ++i) {
    const double own = 1 / (3 * (1 + g_weights[i]) * (1 + g_weights[i]));
    const Shares& key = found.keys[i];
    states("first", key.first.value, own / (all - 1), half_width(key.first), "closed form");
    states("total", key.total.value, own * all / (1 + own) / (all - 1), half_width(key.total),
           "closed form");
  }
}

TEST(VarianceShares, IntervalsHoldTheTruthAsOftenAsTheyClaim) {
  // Points drawn at random, so that nothing is surer than the intervals suppose.
  constexpr int times = 200, base = 512;
  const IshigamiParts v = ishigami_parts();
  std::array<int, 4> held{};
  for (std::uint32_t t = 0; t < times; ++t) {
    Random random(11, t);
    Places rows = saltelli_design(3, base);
    for (std::size_t g = 0; g < rows.size(); g += 5) {
      for (std::size_t i = 0; i < 3; ++i) rows[g][i] = random.uniform();
      for (std::size_t i = 0; i < 3; ++i) rows[g + 4][i] = random.uniform();
      for (std::size_t i = 0; i < 3; ++i) (rows[g + 1 + i] = rows[g])[i] = rows[g + 4][i];
    }
    const VarianceShares found = variance_shares(3, outcomes(rows, ishigami), {}, t);
    const auto holds = [](const Sure& s, double truth) {
      return s.low <= truth && truth <= s.high;
    };
    held[0] += holds(found.keys[0].first, v.first / v.all());
    held[1] += holds(found.keys[2].first, 0);
    held[2] += holds(found.keys[1].total, v.second / v.all());
    held[3] += holds(found.keys[2].total, v.together / v.all());
  }
  const double tolerance = 3.3 * std::sqrt(times * 0.95 * 0.05);
  for (const int h : held)
    states("intervals that hold, of 200", h, 0.95 * times, tolerance, "binomial");
}

TEST(VarianceShares, LeaveOutWhatHangsOnFailedRuns) {
  const Places rows = saltelli_design(3, 2048);
  Values y = outcomes(rows, ishigami);
  y[0] = nan;                                            // a of group 0: nothing is left of it
  y[5 + 2] = nan;                                        // key 1 in group 1
  for (std::size_t i = 1000; i < 1100; ++i) y[i] = nan;  // 20 groups
  const VarianceShares found = variance_shares(3, y, {});
  EXPECT_EQ(found.failed, 102);
  EXPECT_EQ(found.keys[0].count, 2048U - 21);
  EXPECT_EQ(found.keys[1].count, 2048U - 22);
  const IshigamiParts v = ishigami_parts();
  states("first", found.keys[1].first.value, v.second / v.all(), half_width(found.keys[1].first),
         "closed form");
  // Nor do the errors of failed runs, which have none, hide those of the others.
  const Values widths(y.size(), 0.1 * 1.96);
  const Values errors = standard_errors(y, widths, Values(y.size(), 1e6));
  ASSERT_EQ(errors.size(), y.size());
  EXPECT_TRUE(std::isnan(errors[0]));
  const VarianceShares known = variance_shares(3, y, errors);
  states("share of errors", known.noise, 0.01 / found.variance, 1e-4 * 0.01 / found.variance,
         "1.96 is right to 2e-5");
  EXPECT_EQ(known.keys[1].told, std::optional(true));
}

TEST(VarianceShares, AreFreeOfTheShareOfErrors) {
  // Errors as large as the outcome's own spread: without a correction they look like a share of
  // every key.
  constexpr std::size_t base = 8192;
  const Places rows = saltelli_design(2, base);
  Random random(5, 0);
  const double error = 0.5;
  Values y = outcomes(rows, [&](const Values& x) { return std::sqrt(12.0) * x[0]; });
  for (double& one : y) one += error * normal(random);
  const Values errors(y.size(), error);
  const VarianceShares found = variance_shares(2, y, errors), raw = variance_shares(2, y, {});
  states("variance", found.variance, 1, 0.05, "of a uniform number times sqrt(12)");
  states("share of errors", found.noise, 0.2, 0.02, "0.25/1.25");
  const auto sure = [](const Sure& s) { return half_width(s) * 3.3 / 1.96; };
  states("total of the first", found.keys[0].total.value, 1, sure(found.keys[0].total), "1");
  states("total of the second", found.keys[1].total.value, 0, sure(found.keys[1].total), "0");
  states("without errors said", raw.keys[1].total.value, 0.2, sure(raw.keys[1].total), "0.25/1.25");
}

TEST(VarianceShares, OfAKeyThatChangesNothingAreZeroWhateverTheErrors) {
  // Runs that differ in an idle key alone are the same run: their errors do not add up.
  Random random(5, 2);
  const Places rows = saltelli_design(2, 64);
  Values y;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const bool same = row % 4 == 2;  // key 1 from b: as a, two rows before
    y.push_back(same ? y[row - 2] : 10 * rows[row][0] + normal(random));
  }
  const VarianceShares found = variance_shares(2, y, Values(y.size(), 1.0));
  EXPECT_FALSE(found.keys[0].idle);
  EXPECT_EQ(found.keys[0].told, std::optional(true));
  EXPECT_TRUE(found.keys[1].idle);
  EXPECT_EQ(found.keys[1].told, std::optional(false));
  EXPECT_EQ(found.keys[1].total.value, 0);
  EXPECT_EQ(found.keys[1].total.low, 0);
  EXPECT_EQ(found.keys[1].first.high, 0);
}

TEST(VarianceShares, OfNoiseAreToldInFewOf200Designs) {
  // Key 0 does much, key 1 nothing, but its runs have errors of their own. The whole interval of a
  // total lies above the truth in 2.5 of 100.
  constexpr int times = 200;
  constexpr double share = 0.025;
  const Places rows = saltelli_design(2, 128);
  int first = 0, second = 0, unsure = 0;
  for (std::uint32_t t = 0; t < times; ++t) {
    Random random(17, t);
    const Values y = outcomes(rows, [&](const Values& x) { return 10 * x[0] + normal(random); });
    const VarianceShares found = variance_shares(2, y, Values(y.size(), 1.0), t);
    first += found.keys[0].told == std::optional(true);
    second += found.keys[1].told == std::optional(true);
    unsure += variance_shares(2, y, {}, t).keys[1].told.value_or(false);
  }
  EXPECT_EQ(first, times);
  stays_below("told of noise", second, times * share + 3.3 * std::sqrt(times * share * (1 - share)),
              "binomial");
  EXPECT_EQ(unsure, 0) << "errors that are not known may make all of it";
}

TEST(VarianceShares, AreNotToldWhereTheOutcomeHardlyVariesMoreThanItsErrors) {
  // Nothing but noise, said to be all but a hundredth of the variance: of the groups drawn anew
  // many have less than that.
  Random random(5, 3);
  const Places rows = saltelli_design(2, 64);
  const Values y = outcomes(rows, [&](const Values&) { return normal(random); });
  const double seen = variance_shares(2, y, {}).variance;
  const VarianceShares hardly = variance_shares(2, y, Values(y.size(), std::sqrt(0.99 * seen))),
                       less = variance_shares(2, y, Values(y.size(), std::sqrt(1.5 * seen)));
  states("share of errors", hardly.noise, 0.99, 1e-12, "as made");
  EXPECT_TRUE(std::isfinite(hardly.keys[0].total.value));
  EXPECT_TRUE(std::isnan(hardly.keys[0].total.low));
  EXPECT_EQ(hardly.keys[0].told, std::optional(false));
  states("share of errors", less.noise, 1.5, 1e-12, "as made");
  EXPECT_LT(less.variance, 0);
  EXPECT_TRUE(std::isnan(less.keys[0].total.value));
  EXPECT_EQ(less.keys[0].told, std::optional(false));
}

TEST(VarianceShares, OfOneGroupHaveNoInterval) {
  const VarianceShares found = variance_shares(1, {1, 2, 3}, {0.1, 0.1, 0.1});
  EXPECT_EQ(found.keys[0].count, 1U);
  EXPECT_TRUE(std::isfinite(found.keys[0].total.value));
  EXPECT_TRUE(std::isnan(found.keys[0].total.low));
  EXPECT_EQ(found.keys[0].told, std::nullopt);
}

TEST(VarianceShares, AreNotInventedWhereNothingVaries) {
  const VarianceShares found = variance_shares(2, Values(40, 3.0), {});
  EXPECT_TRUE(std::isnan(found.keys[0].first.value));
  EXPECT_TRUE(std::isnan(found.keys[1].total.high));
  EXPECT_TRUE(std::isnan(variance_shares(2, Values(40, nan), {}).keys[0].first.value));
  EXPECT_TRUE(std::isnan(variance_shares(2, {}, {}).keys[0].total.value));
  EXPECT_THROW(variance_shares(2, Values(41, 3.0), {}), std::invalid_argument);
}

TEST(ElementaryEffects, AreExactForALine) {
  const Places rows = morris_design(3, 10, 1);
  const auto found = elementary_effects(
      rows, outcomes(rows, [](const Values& x) { return 5 + 2 * x[0] - 3 * x[1]; }), {});
  const std::array slope{2.0, -3.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Effects& key = found.keys[i];
    const double rounding = 1e-14;  // outcomes of 10 are rounded to 2e-15, steps are 2/3
    states("mu", key.mean.value, slope[i], rounding, "slope");
    states("mu*", key.mean_size.value, std::abs(slope[i]), rounding, "slope");
    states("sigma", key.spread.value, 0, rounding, "a line does not bend");
    stays_below("half-width", half_width(key.mean_size), rounding, "nothing scatters");
    EXPECT_EQ(key.count, 10U);
    EXPECT_TRUE(std::isnan(key.of_noise));
  }
}

TEST(ElementaryEffects, KnowWhatKeysDoTogetherAndTheirIntervalsHold) {
  // Of y = (x1 - 1/2) x2 the effect of key 1 is x2: 0, 1/3, 2/3 or 1, so mu is 1/2 and sigma^2 the
  // mean square of +-1/2, +-1/6. Key 2 does +-1/2 or +-1/6: mu is 0, mu* is 1/3.
  constexpr int times = 200, ways = 40;
  const double sigma = std::sqrt(5.0 / 36);
  std::array<int, 4> held{};
  for (std::uint64_t seed = 0; seed < times; ++seed) {
    const Places rows = morris_design(2, ways, seed);
    const auto found = elementary_effects(
        rows, outcomes(rows, [](const Values& x) { return (x[0] - 0.5) * x[1]; }), {});
    const auto holds = [](const Sure& s, double truth) {
      return s.low <= truth && truth <= s.high;
    };
    held[0] += holds(found.keys[0].mean, 0.5);
    held[1] += holds(found.keys[0].spread, sigma);
    held[2] += holds(found.keys[1].mean, 0);
    held[3] += holds(found.keys[1].mean_size, 1.0 / 3);
  }
  const double tolerance = 3.3 * std::sqrt(times * 0.95 * 0.05);
  for (const int h : held)
    states("intervals that hold, of 200", h, 0.95 * times, tolerance, "binomial");
}

TEST(ElementaryEffects, OfNoiseAloneAreWhatErrorsGive) {
  constexpr std::size_t ways = 4000;
  const Places rows = morris_design(1, ways, 3);
  Random random(5, 1);
  const Values y = outcomes(rows, [&](const Values&) { return 0.3 * normal(random); });
  const auto found = elementary_effects(rows, y, Values(y.size(), 0.3));
  const Effects& key = found.keys[0];
  states("mu* of errors", key.of_noise, 0.3 * 1.5 * 2 / std::sqrt(std::numbers::pi), 4000 * 1e-16,
         "mean size of a normal number");
  states("mu*", key.mean_size.value, key.of_noise, half_width(key.mean_size) * 3.3 / 1.96,
         "3.3 standard errors");
}

TEST(ElementaryEffects, OfNoiseAreRightWhereErrorsComeFromTwoReplicates) {
  // The error of a mean of two is half their difference. On the mean it is smaller than the true
  // one, by sqrt(2/pi); its square is not.
  constexpr std::size_t ways = 4000;
  const Places rows = morris_design(1, ways, 3);
  Random random(5, 4);
  Values y, ci95;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double one = normal(random), other = normal(random), half = std::abs(one - other) / 2;
    y.push_back((one + other) / 2);
    ci95.push_back(std::tan(0.475 * std::numbers::pi) * half);  // Student's law of one is Cauchy's
  }
  const Values errors = standard_errors(y, ci95, Values(y.size(), 2));
  const auto found = elementary_effects(rows, y, errors);
  // Squares of one degree of freedom scatter by sqrt(2) of their mean, a root by half of that.
  const double alone = 3.3 * found.keys[0].of_noise * std::sqrt(2.0 / (2 * ways)) / 2;
  states("mu*", found.keys[0].mean_size.value, found.keys[0].of_noise,
         std::hypot(alone, half_width(found.keys[0].mean_size) * 3.3 / 1.96),
         "3.3 standard errors");
}

TEST(ElementaryEffects, AreToldIfSurelyMoreThanNoiseMakes) {
  const Places rows = morris_design(3, 10, 1);
  Random random(5, 5);
  const Values y = outcomes(rows, [&](const Values& x) { return 100 * x[0] + normal(random); });
  const auto found = elementary_effects(rows, y, Values(y.size(), 1.0)),
             errors_unknown = elementary_effects(rows, y, {});
  EXPECT_EQ(found.keys[0].told, std::optional(true));
  EXPECT_EQ(found.keys[1].told, std::optional(false));
  EXPECT_EQ(errors_unknown.keys[0].told, std::nullopt);

  // One way has no interval: what is below noise is not told, of what is above nothing is known.
  const auto one = elementary_effects({{0}, {2.0 / 3}}, {1, 5}, {1, 1});
  EXPECT_TRUE(std::isnan(one.keys[0].mean_size.low));
  EXPECT_EQ(one.keys[0].told, std::nullopt);
  EXPECT_EQ(elementary_effects({{0}, {2.0 / 3}}, {1, 1.1}, {1, 1}).keys[0].told,
            std::optional(false));
}

TEST(ElementaryEffects, SayWhichKeyChangesNothing) {
  const Places rows = morris_design(2, 5, 1);
  const Values y = outcomes(rows, [](const Values& x) { return std::exp(x[0]); });
  const auto found = elementary_effects(rows, y, {});
  EXPECT_FALSE(found.keys[0].idle);
  EXPECT_TRUE(found.keys[1].idle);
  EXPECT_EQ(found.keys[1].told, std::optional(false));
  EXPECT_FALSE(elementary_effects(rows, Values(y.size(), nan), {}).keys[1].idle) << "not known";
}

TEST(ElementaryEffects, LeaveOutStepsThatFailed) {
  const Places rows = morris_design(2, 4, 1);
  Values y = outcomes(rows, [](const Values& x) { return x[0]; });
  y[1] = nan;  // the middle of the first way: both of its steps
  y[3] = nan;  // the start of the second: its first step
  const auto found = elementary_effects(rows, y, {});
  EXPECT_EQ(found.failed, 2);
  EXPECT_EQ(found.keys[0].count + found.keys[1].count, 8U - 3);
  const auto nothing = elementary_effects(rows, Values(12, nan), {});
  EXPECT_TRUE(std::isnan(nothing.keys[0].mean.value));
  EXPECT_EQ(nothing.keys[1].count, 0U);
  EXPECT_THROW(elementary_effects(rows, Values(11), {}), std::invalid_argument);
}

TEST(Swings, AreWhatEachKeyDoesAlone) {
  const Swings found = swings({5, 4, 6, 5.2, 5.3}, {0.1, 0.2, 0.2, 0.3, 0.3});
  EXPECT_EQ(found.base.value, 5);
  ASSERT_EQ(found.keys.size(), 2U);
  EXPECT_EQ(found.keys[0].at_low.value, 4);
  EXPECT_DOUBLE_EQ(found.keys[0].at_high.high, 6.2);
  EXPECT_EQ(found.keys[0].told, std::optional(true));
  EXPECT_EQ(found.keys[1].told, std::optional(false));  // 0.3 is less than sqrt(0.1^2 + 0.3^2)
  const Swings failed = swings({5, nan, 6}, {});
  EXPECT_EQ(failed.failed, 1);
  EXPECT_TRUE(std::isnan(failed.keys[0].at_low.value));
  EXPECT_EQ(failed.keys[0].told, std::nullopt);
  EXPECT_THROW(swings({1, 2}, {}), std::invalid_argument);
}

TEST(Swings, AreComparedWithTheCaseItself) {
  // The ends differ by 2, more than sqrt(1 + 1); from the case both by 1, which is less.
  EXPECT_EQ(swings({5, 4, 6}, {1, 1, 1}).keys[0].told, std::optional(false));
  EXPECT_EQ(swings({5, 4, 6}, {0.1, 1, 0.1}).keys[0].told, std::optional(true)) << "the high end";
}

TEST(Swings, AreNotJudgedWithoutIntervals) {
  EXPECT_EQ(swings({5, 4, 6}, {}).keys[0].told, std::nullopt);
  EXPECT_EQ(swings({5, 4, 6}, {nan, 0.1, 0.1}).keys[0].told, std::nullopt);
  EXPECT_EQ(swings({5, 5.1, 6}, {1, 1, nan}).keys[0].told, std::nullopt) << "the other may differ";
  EXPECT_EQ(swings({5, 9, 6}, {1, 1, nan}).keys[0].told, std::optional(true));
}

TEST(Swings, SayWhichKeyChangesNothing) {
  const Swings found = swings({5, 5, 5, 5, 5.1, 5, nan}, {});
  EXPECT_TRUE(found.keys[0].idle);
  EXPECT_FALSE(found.keys[1].idle);
  EXPECT_FALSE(found.keys[2].idle) << "a failed run tells nothing";
}

TEST(StandardErrors, AreHalfWidthsOverStudentsQuantile) {
  const double t1 = std::tan(0.475 * std::numbers::pi);  // Cauchy's law
  const double t2 = 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95));
  const Values found = standard_errors({1, 2, 3}, {t1, 2 * t2, 2}, {2, 3, 1});
  ASSERT_EQ(found.size(), 3U);
  states("of two replicates", found[0], 1, 1e-9, "closed form of Student's quantile");
  states("of three", found[1], 2, 1e-9, "closed form");
  states("of one, over time", found[2], 1, 0.131, "t_95 of 10 batches is 2.262, of many 1.960");
}

TEST(StandardErrors, AreUnknownWhereOneIsMissing) {
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, nan}, {2, 2}).empty());
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, 0.1}, {2, nan}).empty());
  EXPECT_TRUE(standard_errors({1, 2}, {0.1, 0.1}, {}).empty());
  EXPECT_EQ(standard_errors({1, nan}, {0.1, nan}, {2, nan}).size(), 2U)
      << "a failed run needs none";
  EXPECT_THROW(standard_errors({1, 2}, {0.1}, {2, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::campaign

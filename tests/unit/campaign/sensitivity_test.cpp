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
  EXPECT_TRUE(found.keys[0].told);
  EXPECT_FALSE(found.keys[1].told);  // 0.3 is less than sqrt(0.1^2 + 0.3^2)
  const Swings failed = swings({5, nan, 6}, {});
  EXPECT_EQ(failed.failed, 1);
  EXPECT_TRUE(std::isnan(failed.keys[0].at_low.value));
  EXPECT_FALSE(failed.keys[0].told);
  EXPECT_THROW(swings({1, 2}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::campaign

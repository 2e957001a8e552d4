// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::least_squares_test {
namespace {

using tests::states;
using tests::stays_below;
using Values = std::vector<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool says(const std::vector<std::string>& remarks, const std::string& words) {
  for (const std::string& remark : remarks)
    if (remark.find(words) != std::string::npos) return true;
  return false;
}

/// Residuals of a exp(-b t), measured at t = 0, 1, ..., in units of the error of measurement.
Residuals decay(const Values& measured, double error) {
  return [=](const Values& p) {
    Values r;
    for (std::size_t t = 0; t < measured.size(); ++t)
      r.push_back((p[0] * std::exp(-p[1] * static_cast<double>(t)) - measured[t]) / error);
    return r;
  };
}

const std::vector<FreeParameter> decay_parameters{{"a", 0.1, 100}, {"b", 0, 2}};
constexpr double true_a = 7, true_b = 0.35;

Values decay_data(std::size_t count, double noise, std::uint32_t stream) {
  Random random(1887, stream);
  Values data;
  for (std::size_t t = 0; t < count; ++t) {
    const double size = std::sqrt(-2 * std::log(random.uniform()));
    const double normal = size * std::cos(random.uniform(0, 2 * std::numbers::pi));
    data.push_back(true_a * std::exp(-true_b * static_cast<double>(t)) + noise * normal);
  }
  return data;
}

TEST(LeastSquares, find_what_perfect_data_were_made_with) {
  const LeastSquaresResult fit =
      least_squares(decay(decay_data(8, 0, 0), 1), decay_parameters, ErrorScale::estimated);
  // Data of norm 20 are rounded to eps; the slopes by positions are as large, or a few times
  // smaller.
  const double rounding = 10 * std::sqrt(8 * 49.0) * std::numeric_limits<double>::epsilon();
  states("a", fit.parameters[0].value, true_a, true_a * std::log(1000.0) * rounding, "as put in");
  states("b", fit.parameters[1].value, true_b, 2 * rounding, "as put in");
  for (const FittedParameter& p : fit.parameters) {
    EXPECT_TRUE(p.determined);
    EXPECT_TRUE(p.remarks.empty()) << p.remarks.front();
    EXPECT_LE(p.low, p.value);
    EXPECT_GE(p.high, p.value);
    stays_below("width of the interval of " + p.name, p.high - p.low, 1e-7, "no scatter, no width");
  }
  EXPECT_EQ(fit.degrees_of_freedom, 6);
}

TEST(LeastSquares, find_the_lower_of_two_valleys) {
  // (x^2 - 1)^2 plus a slope has two valleys. The one at -1 is lower; the start is in the other
  // one.
  const Residuals valleys = [](const Values& p) {
    return Values{p[0] * p[0] - 1, 0.3 * (p[0] + 2)};
  };
  const LeastSquaresResult fit = least_squares(valleys, {{"x", -2, 2, 1}}, ErrorScale::estimated);
  EXPECT_LT(fit.parameters[0].value, -0.9);
  EXPECT_GT(fit.parameters[0].value, -1.1);
}

/// Number of `sets` in which the interval of each parameter contains the true value.
std::array<int, 2> covered(int sets, std::size_t count, double noise, ErrorScale scatter) {
  std::array<int, 2> held{};
  for (int set = 0; set < sets; ++set) {
    const Values data = decay_data(count, noise, static_cast<std::uint32_t>(set + 1));
    const Residuals residuals = decay(data, scatter == ErrorScale::known ? noise : 1);
    const LeastSquaresResult fit = least_squares(residuals, decay_parameters, scatter);
    const std::array truth{true_a, true_b};
    for (std::size_t i = 0; i < 2; ++i)
      held[i] += fit.parameters[i].low <= truth[i] && truth[i] <= fit.parameters[i].high ? 1 : 0;
  }
  return held;
}

// The number of intervals that contain the true value is binomial: 400 trials of 0.95, standard
// deviation 4.4. One correct fit in a thousand lies beyond 3.3 standard deviations.
constexpr int trials = 400;
const double spread = 3.3 * std::sqrt(trials * 0.95 * 0.05);

TEST(LeastSquares, intervals_hold_the_truth_in_nineteen_of_twenty_data_sets) {
  const std::array held = covered(trials, 8, 0.2, ErrorScale::estimated);
  states("a, of 400", held[0], 0.95 * trials, spread, "binomial, 3.3 standard deviations");
  states("b, of 400", held[1], 0.95 * trials, spread, "binomial, 3.3 standard deviations");
}

TEST(LeastSquares, intervals_hold_the_truth_where_noise_is_strong_and_data_are_few) {
  // Slopes at the optimum alone would give too narrow intervals: the curve bends within the noise.
  const std::array held = covered(trials, 4, 0.8, ErrorScale::estimated);
  states("a, of 400", held[0], 0.95 * trials, spread, "binomial, 3.3 standard deviations");
  states("b, of 400", held[1], 0.95 * trials, spread, "binomial, 3.3 standard deviations");
}

TEST(LeastSquares, known_errors_give_intervals_that_hold_no_less_often) {
  // The intervals use the larger of known and observed scatter, so they hold more often than 95 %.
  for (const int held : covered(trials, 8, 0.2, ErrorScale::known))
    EXPECT_GE(held, 0.95 * trials - spread);
}

TEST(LeastSquares, known_errors_give_the_width_of_a_mean) {
  // n values of error e give a mean with the error 1.96 e/sqrt(n), however little the values
  // scatter.
  const Values data{4.1, 4.0, 4.1, 4.0};
  const double error = 0.5;
  const Residuals residuals = [&](const Values& p) {
    Values r;
    for (const double d : data) r.push_back((p[0] - d) / error);
    return r;
  };
  const LeastSquaresResult fit = least_squares(residuals, {{"mean", 0, 9}}, ErrorScale::known);
  const double width = 1.959964 * error / 2;
  const double tolerance = 0.01 * width;  // precision of the ends of an interval
  states("mean", fit.parameters[0].value, 4.05, 1e-9, "arithmetic");
  states("lower end", fit.parameters[0].low, 4.05 - width, tolerance, "normal distribution");
  states("upper end", fit.parameters[0].high, 4.05 + width, tolerance, "normal distribution");
  EXPECT_TRUE(fit.remarks.empty());
}

TEST(LeastSquares, scatter_gives_the_width_of_a_mean) {
  const Values data{4.2, 3.9, 4.4, 4.1, 3.6};
  const Residuals residuals = [&](const Values& p) {
    Values r;
    for (const double d : data) r.push_back(p[0] - d);
    return r;
  };
  const LeastSquaresResult fit = least_squares(residuals, {{"mean", 0, 9}}, ErrorScale::estimated);
  const double width = 2.77644511 * std::sqrt(0.093 / 5);  // t_95(4), variance of the data 0.093
  states("lower end", fit.parameters[0].low, 4.04 - width, 0.01 * width, "Student's t");
  states("upper end", fit.parameters[0].high, 4.04 + width, 0.01 * width, "Student's t");
  states("scatter", fit.scatter, std::sqrt(0.093), 1e-9, "arithmetic");
}

TEST(LeastSquares, errors_that_are_too_small_are_told) {
  const Values data = decay_data(12, 0.2, 5);
  const LeastSquaresResult honest =
      least_squares(decay(data, 0.2), decay_parameters, ErrorScale::known);
  const LeastSquaresResult vain =
      least_squares(decay(data, 0.02), decay_parameters, ErrorScale::known);
  EXPECT_TRUE(honest.remarks.empty());
  EXPECT_TRUE(says(vain.remarks, "times as far from the fit as their errors say"));
  EXPECT_LT(vain.parameters[0].low, honest.parameters[0].value);
  EXPECT_GT(vain.parameters[0].high - vain.parameters[0].low,
            0.5 * (honest.parameters[0].high - honest.parameters[0].low));
}

TEST(LeastSquares, a_product_is_all_that_is_found_of_two_factors) {
  for (const double noise : {0.0, 0.2}) {
    const Residuals product = [=, decay = decay(decay_data(8, noise, 3), 1)](const Values& p) {
      return decay({p[0] * p[2], p[1]});
    };
    const LeastSquaresResult fit = least_squares(
        product, {{"a", 0.1, 100}, {"b", 0, 2}, {"c", 0.01, 10}}, ErrorScale::estimated);
    EXPECT_FALSE(fit.parameters[0].determined);
    EXPECT_TRUE(fit.parameters[1].determined);
    EXPECT_FALSE(fit.parameters[2].determined);
    EXPECT_TRUE(says(fit.parameters[0].remarks, "only a combination of it and c"));
    EXPECT_TRUE(says(fit.parameters[2].remarks, "only a combination of it and a"));
    EXPECT_TRUE(fit.parameters[1].remarks.empty());
  }
}

TEST(LeastSquares, a_parameter_that_does_nothing_is_named) {
  const Residuals idle = [decay = decay(decay_data(8, 0.2, 3), 1)](const Values& p) {
    return decay({p[1], p[2]});
  };
  const LeastSquaresResult fit =
      least_squares(idle, {{"idle", 1, 2}, {"a", 0.1, 100}, {"b", 0, 2}}, ErrorScale::estimated);
  EXPECT_FALSE(fit.parameters[0].determined);
  EXPECT_TRUE(says(fit.parameters[0].remarks, "no measured quantity depends on it"));
  EXPECT_TRUE(fit.parameters[1].determined);
  EXPECT_TRUE(fit.parameters[2].determined);
  EXPECT_EQ(fit.parameters[0].low, 1);
  EXPECT_EQ(fit.parameters[0].high, 2);
}

TEST(LeastSquares, what_drowns_in_the_scatter_is_not_determined) {
  // The effect of the second parameter is a thousandth of the scatter of the data.
  const Residuals weak = [decay = decay(decay_data(8, 0.2, 3), 1)](const Values& p) {
    Values r = decay({p[0], true_b});
    r[2] += 2e-4 * p[1];
    return r;
  };
  const LeastSquaresResult fit =
      least_squares(weak, {{"a", 0.1, 100}, {"weak", 0, 1}}, ErrorScale::estimated);
  EXPECT_TRUE(fit.parameters[0].determined);
  EXPECT_FALSE(fit.parameters[1].determined);
  EXPECT_TRUE(says(fit.parameters[1].remarks, "any value of its range fits"));
}

TEST(LeastSquares, one_sided_data_give_one_limit) {
  // A threshold that must lie below the observed breakage. The data do not exclude zero.
  const Residuals threshold = [](const Values& p) {
    Values r;
    for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0})
      r.push_back(10 * (std::max(0.0, x - p[0] * p[0]) - x) + 0.3 * std::sin(7 * x));
    return r;
  };
  const LeastSquaresResult fit =
      least_squares(threshold, {{"threshold", 0, 2}}, ErrorScale::estimated);
  const FittedParameter& p = fit.parameters[0];
  EXPECT_TRUE(p.open_low);
  EXPECT_FALSE(p.open_high);
  EXPECT_LT(p.high, 0.5);
  EXPECT_TRUE(says(p.remarks, "no lower limit"));
}

TEST(LeastSquares, fewer_data_than_parameters_are_told) {
  const LeastSquaresResult fit =
      least_squares([](const Values& p) { return Values{p[0] + p[1] - 1}; },
                    {{"a", 0, 2}, {"b", 0, 2}}, ErrorScale::estimated);
  EXPECT_TRUE(says(fit.remarks, "fewer measured values than parameters: 1 and 2"));
  for (const FittedParameter& p : fit.parameters) EXPECT_FALSE(p.determined) << p.name;
  stays_below("sum of squares", fit.sum_of_squares, 1e-12, "many sets fit");
}

TEST(LeastSquares, as_many_data_as_parameters_leave_nothing_to_tell_the_scatter) {
  const Values data = decay_data(2, 0, 1);
  const LeastSquaresResult guess =
      least_squares(decay(data, 1), decay_parameters, ErrorScale::estimated);
  EXPECT_TRUE(says(guess.remarks, "no interval can be given"));
  EXPECT_FALSE(guess.parameters[0].determined);
  EXPECT_TRUE(std::isnan(guess.scatter));
  states("a", guess.parameters[0].value, true_a, 1e-6, "as put in");
  const LeastSquaresResult known =
      least_squares(decay(data, 0.1), decay_parameters, ErrorScale::known);
  const double width = 1.959964 * 0.1;  // a is measured at t = 0, b can adapt
  EXPECT_TRUE(known.parameters[0].determined);
  states("lower end", known.parameters[0].low, true_a - width, 0.01 * width, "normal distribution");
}

TEST(LeastSquares, a_best_value_at_a_bound_is_told) {
  const Residuals residuals = decay(decay_data(8, 0.01, 2), 1);
  const LeastSquaresResult fit =
      least_squares(residuals, {{"a", 0.1, 100}, {"b", 0.5, 2}}, ErrorScale::estimated);
  EXPECT_EQ(fit.parameters[1].value, 0.5);
  EXPECT_TRUE(says(fit.parameters[1].remarks, "a wider range may fit better"));
  const LeastSquaresResult hard = least_squares(
      residuals, {{"a", 0.1, 100}, {.name = "b", .least = 0.5, .most = 2, .min_is_natural = true}},
      ErrorScale::estimated);
  EXPECT_TRUE(says(hard.parameters[1].remarks, "beyond which it makes no sense"));
  EXPECT_TRUE(says(fit.parameters[1].remarks, "at the lower end of its range"));
  EXPECT_TRUE(fit.parameters[1].open_low);
}

TEST(LeastSquares, parameters_that_are_hard_to_tell_apart_are_told) {
  // Two decays of nearly equal rate: their sum is well determined, each of them badly.
  const Residuals twins = [](const Values& p) {
    Values r;
    for (int t = 0; t < 20; ++t)
      r.push_back(p[0] * std::exp(-0.3 * t) + p[1] * std::exp(-0.33 * t) -
                  2 * std::exp(-0.315 * t) + 0.002 * std::sin(5.0 * t));
    return r;
  };
  const LeastSquaresResult fit =
      least_squares(twins, {{"a", -5, 5}, {"b", -5, 5}}, ErrorScale::estimated);
  EXPECT_TRUE(says(fit.parameters[0].remarks, "hard to distinguish from b"));
  EXPECT_LT(fit.correlation[0][1], -0.98);
  EXPECT_EQ(fit.correlation[0][0], 1);
  EXPECT_EQ(fit.correlation[0][1], fit.correlation[1][0]);
}

TEST(LeastSquares, sets_that_fail_count_as_very_bad) {
  const Residuals half = [decay = decay(decay_data(8, 0, 1), 1)](const Values& p) {
    return p[0] > 30 || p[1] < 0.2 ? Values(8, nan) : decay(p);
  };
  const LeastSquaresResult fit = least_squares(half, decay_parameters, ErrorScale::estimated);
  states("a", fit.parameters[0].value, true_a, 1e-6, "as put in");
  states("b", fit.parameters[1].value, true_b, 1e-7, "as put in");
}

TEST(LeastSquares, a_model_that_always_fails_is_an_error) {
  const Residuals never = [](const Values&) { return Values(3, nan); };
  EXPECT_THROW(least_squares(never, decay_parameters, ErrorScale::estimated), RunError);
  const Residuals thrower = [](const Values&) -> Values { throw std::domain_error("mine"); };
  EXPECT_THROW(least_squares(thrower, decay_parameters, ErrorScale::estimated), std::domain_error);
}

TEST(LeastSquares, an_error_during_the_search_comes_through_as_it_is) {
  int left = 70;  // after the first evaluations, within the simplexes
  const Residuals later = [&](const Values& p) {
    if (--left == 0) throw std::domain_error("mine");
    return decay(decay_data(8, 0.2, 1), 1)(p);
  };
  EXPECT_THROW(least_squares(later, decay_parameters, ErrorScale::estimated), std::domain_error);
}

TEST(LeastSquares, bounds_must_hold_an_interval) {
  const Residuals any = decay(decay_data(8, 0, 1), 1);
  EXPECT_THROW(least_squares(any, {{"a", 2, 2}, {"b", 0, 1}}, ErrorScale::known),
               std::invalid_argument);
  EXPECT_THROW(least_squares(any, {{"a", 1, nan}, {"b", 0, 1}}, ErrorScale::known),
               std::invalid_argument);
}

TEST(LeastSquares, take_some_hundred_evaluations_a_parameter) {
  const LeastSquaresResult fit =
      least_squares(decay(decay_data(12, 0.2, 5), 0.2), decay_parameters, ErrorScale::known);
  std::printf("    %d evaluations\n", fit.evaluations);
  EXPECT_LT(fit.evaluations, 500);
}

}  // namespace
}  // namespace mahlwerk::campaign::least_squares_test

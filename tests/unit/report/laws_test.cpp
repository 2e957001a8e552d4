// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "statement.hpp"

namespace mahlwerk::report::laws_test {
namespace {

using tests::states;
using List = std::vector<double>;

const FittedLaw& of(const std::vector<FittedLaw>& laws, LawForm form) {
  const auto at = std::ranges::find(laws, form, &FittedLaw::form);
  EXPECT_NE(at, laws.end()) << name_of(form);
  return at == laws.end() ? laws.front() : *at;
}

List map(const List& x, double (*f)(double)) {
  List y;
  for (const double v : x) y.push_back(f(v));
  return y;
}

/// A normal deviate (Box and Muller).
double normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));
  return radius * std::cos(2 * M_PI * random.uniform(0, 1));
}

/// Statistical Reference Datasets of NIST, "Norris" (linear, lower difficulty).
const List norris_x{0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                    0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                    0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};
const List norris_y{0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                    0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                    0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};

TEST(Laws, a_line_through_nists_norris_data_is_the_certified_one) {
  const FittedLaw line = of(fitted_laws(norris_x, norris_y, {}), LawForm::line);
  const std::string source = "NIST StRD, Norris";
  const double t = observe::student95(34);
  states("intercept", line.coefficients[0], -0.262323073774029, 1e-12, source);
  states("slope", line.coefficients[1], 1.00211681802045, 1e-13, source);
  // The quantile is good to 1e-6 beyond 30 degrees of freedom (docs/theory/statistics.md).
  states("half-width of the intercept", line.ci95[0] / t, 0.232818234301152, 1e-6, source);
  states("half-width of the slope", line.ci95[1] / t, 0.429796848199937e-3, 1e-9, source);
  states("R^2", line.r_squared, 0.999993745883712, 1e-13, source);
}

TEST(Laws, weights_are_those_of_the_textbooks_weighted_line) {
  const List x{1, 2, 3, 5, 8}, y{2.1, 3.8, 6.3, 9.7, 16.4}, ci{0.2, 0.4, 0.3, 1.0, 0.5};
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0, left = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double v = 1 / (ci[i] * ci[i]);
    w += v, wx += v * x[i], wy += v * y[i], wxx += v * x[i] * x[i], wxy += v * x[i] * y[i];
  }
  const double d = w * wxx - wx * wx;
  const double a = (wxx * wy - wx * wxy) / d, b = (w * wxy - wx * wy) / d;
  double total = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double v = 1 / (ci[i] * ci[i]);
    left += v * std::pow(y[i] - a - b * x[i], 2);
    total += v * std::pow(y[i] - wy / w, 2);
  }
  const double t = observe::student95(3), s = std::sqrt(left / 3);
  const FittedLaw line = of(fitted_laws(x, y, ci), LawForm::line);
  const std::string source = "Bevington and Robinson, 6.3, s from the residuals";
  states("intercept", line.coefficients[0], a, 1e-12, source);
  states("slope", line.coefficients[1], b, 1e-12, source);
  states("half-width of the intercept", line.ci95[0], t * s * std::sqrt(wxx / d), 1e-12, source);
  states("half-width of the slope", line.ci95[1], t * s * std::sqrt(w / d), 1e-12, source);
  states("R^2", line.r_squared, 1 - left / total, 1e-12, source);
  states("adjusted R^2", line.adjusted, 1 - left / total * 4 / 3, 1e-12, "(cam.25)");
  // Weights that add up to n = 5; k = 3 numbers: a, b and the scatter.
  states("AICc", line.aicc, 5 * std::log(left * 5 / w / 5) + 2 * 3 * 5.0 / (5 - 3 - 1), 1e-10,
         "(cam.26)");
  // Only relative weights count: intervals that are ten times as wide change nothing.
  List wide = ci;
  for (double& v : wide) v *= 10;
  const FittedLaw same = of(fitted_laws(x, y, wide), LawForm::line);
  states("half-width with tenfold intervals", same.ci95[1], line.ci95[1], 1e-12, source);
}

TEST(Laws, without_an_interval_at_every_point_all_weigh_the_same) {
  const List x{1, 2, 3, 5, 8}, y{2.1, 3.8, 6.3, 9.7, 16.4};
  const FittedLaw plain = of(fitted_laws(x, y, {}), LawForm::line);
  for (const List& ci : {List{0.2, 0.4, NAN, 1, 0.5}, List{0.2, 0.4, 0, 1, 0.5}, List{0.2, 0.4}})
    EXPECT_EQ(of(fitted_laws(x, y, ci), LawForm::line).coefficients, plain.coefficients);
}

TEST(Laws, a_power_law_is_recovered_exactly) {
  const List x{3, 7, 20, 55, 160};
  const List y = map(x, [](double v) { return 5e-6 * std::pow(v, -1.7); });
  const std::vector<FittedLaw> laws = fitted_laws(x, y, {});
  const FittedLaw power = of(laws, LawForm::power);
  states("exponent", power.coefficients[1], -1.7, 1e-12, "what the points were made with");
  states("y at x0 over that of the law",
         power.coefficients[0] / (5e-6 * std::pow(power.reference, -1.7)), 1, 1e-12,
         "what the points were made with");
  states("R^2", power.r_squared, 1, 1e-15, "(cam.24)");
  const LawSelection choice = select_law(laws);
  EXPECT_EQ(laws[choice.best].form, LawForm::power);
  EXPECT_TRUE(choice.equivalent.empty());
}

TEST(Laws, a_power_law_has_least_squares_in_y_and_intervals_of_its_slopes) {
  const List x{1, 2, 3, 4, 5, 6}, y{1.2, 2.6, 5.6, 7.6, 11.6, 14.1};
  const FittedLaw power = of(fitted_laws(x, y, {}), LawForm::power);
  const auto left = [&](double c, double p) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += std::pow(y[i] - c * std::pow(x[i] / power.reference, p), 2);
    return sum;
  };
  const double c = power.coefficients[0], p = power.coefficients[1], least = left(c, p);
  for (const double step : {-1e-4, 1e-4}) {
    EXPECT_GT(left(c * (1 + step), p), least);
    EXPECT_GT(left(c, p + step), least);
  }
  double cc = 0, cp = 0, pp = 0;
  for (const double v : x) {
    const double dc = std::pow(v / power.reference, p), dp = c * dc * std::log(v / power.reference);
    cc += dc * dc, cp += dc * dp, pp += dp * dp;
  }
  const double d = cc * pp - cp * cp, s = std::sqrt(least / 4), t = observe::student95(4);
  states("half-width of c", power.ci95[0], t * s * std::sqrt(pp / d), 1e-9, "(cam.22, cam.23)");
  states("half-width of p", power.ci95[1], t * s * std::sqrt(cc / d), 1e-9, "(cam.22, cam.23)");
}

TEST(Laws, a_parabola_is_recovered_exactly_far_from_zero_too) {
  const List x{1000, 1001, 1002, 1004, 1007};
  const List y = map(x, [](double v) { return 3 * v * v - 5990 * v + 2.99e6; });
  const FittedLaw parabola = of(fitted_laws(x, y, {}), LawForm::parabola);
  // Values near 3e6 are known to 5e-10. Over 7 of 1000 in x the parabola contributes only 147 of
  // them.
  states("c", parabola.coefficients[2], 3, 1e-9, "what the points were made with");
  states("b over its own", parabola.coefficients[1] / -5990, 1, 1e-9, "the same");
  states("a over its own", parabola.coefficients[0] / 2.99e6, 1, 1e-9, "the same");
}

TEST(Laws, the_intervals_hold_the_truth_in_95_of_100) {
  constexpr int trials = 2000;
  Random random(7, 0);
  const List x{1, 2, 3, 4, 5, 6, 7, 8};
  int slope = 0, exponent = 0, curvature = 0;
  for (int trial = 0; trial < trials; ++trial) {
    List line, power, ci;
    for (const double v : x) {
      const double half = 0.02 * (1 + v);  // points on the left are more precise
      ci.push_back(half);
      line.push_back(1 + 2 * v + half * normal(random));
      power.push_back(2 * std::pow(v, 1.5) + half * normal(random));
    }
    const std::vector<FittedLaw> laws = fitted_laws(x, line, ci);
    const FittedLaw& fitted = of(laws, LawForm::line);
    const FittedLaw& bent = of(laws, LawForm::parabola);
    const FittedLaw curve = of(fitted_laws(x, power, ci), LawForm::power);
    slope += std::abs(fitted.coefficients[1] - 2) <= fitted.ci95[1] ? 1 : 0;
    curvature += std::abs(bent.coefficients[2]) <= bent.ci95[2] ? 1 : 0;
    exponent += std::abs(curve.coefficients[1] - 1.5) <= curve.ci95[1] ? 1 : 0;
  }
  const double chance = 3.5 * std::sqrt(0.95 * 0.05 / trials);
  const std::string source = "95 %, within 3.5 standard deviations of 2000 trials";
  states("share of lines whose slope is held", slope / double{trials}, 0.95, chance, source);
  states("share of parabolas whose c is held", curvature / double{trials}, 0.95, chance, source);
  states("share of power laws whose p is held", exponent / double{trials}, 0.95, chance, source);
}

TEST(Laws, a_line_through_the_origin_is_also_a_power_law_and_said_to_be) {
  const List x{1, 2, 3, 4, 5, 6, 7, 8};
  const List off{0.05, -0.04, -0.05, 0.06, 0.04, -0.06, -0.03, 0.03};
  List y;
  for (std::size_t i = 0; i < x.size(); ++i) y.push_back(2 * x[i] + off[i]);
  const std::vector<FittedLaw> laws = fitted_laws(x, y, {});
  EXPECT_TRUE(through_origin(of(laws, LawForm::line)));
  const LawSelection choice = select_law(laws);
  EXPECT_TRUE(choice.by_aicc);
  EXPECT_NE(laws[choice.best].form, LawForm::parabola) << "one more parameter without gain";
  ASSERT_EQ(choice.equivalent.size(), 1U);
  EXPECT_NE(laws[choice.equivalent[0]].form, LawForm::parabola);
  for (double& v : y) v += 1;
  EXPECT_FALSE(through_origin(of(fitted_laws(x, y, {}), LawForm::line)));
}

TEST(Laws, four_points_do_not_tell_laws_apart) {
  const List x{1, 2, 3, 4}, y{1.1, 3.8, 9.3, 15.9};
  const std::vector<FittedLaw> laws = fitted_laws(x, y, {});
  ASSERT_EQ(laws.size(), 3U);
  const LawSelection choice = select_law(laws);
  EXPECT_FALSE(choice.by_aicc);
  for (const FittedLaw& law : laws) {
    EXPECT_TRUE(std::isnan(law.aicc));
    EXPECT_LE(law.adjusted, laws[choice.best].adjusted);
  }
}

TEST(Laws, are_fitted_where_the_points_allow_them) {
  EXPECT_TRUE(fitted_laws({}, {}, {}).empty());
  EXPECT_TRUE(fitted_laws({1, 2, 3}, {1, 2, 4}, {}).empty()) << "three points";
  EXPECT_TRUE(fitted_laws({1, 1, 2, 2, 3}, {1, 2, 3, 4, 5}, {}).empty()) << "three x";
  EXPECT_TRUE(fitted_laws({1, 2, 3, 4}, {5, 5, 5, 5}, {}).empty()) << "nothing varies";
  EXPECT_TRUE(fitted_laws({1, 2, 3, 4}, {5, NAN, 6, 7}, {}).empty()) << "three numbers";
  EXPECT_TRUE(fitted_laws({1, 2, 3, 4}, {1, 2, 3, 1e300}, {}).empty()) << "squares overflow";
  EXPECT_EQ(fitted_laws({0, 1, 2, 3, 4}, {1, 2, 4, 5, 7}, {}).size(), 2U) << "x = 0: no power law";
  EXPECT_EQ(fitted_laws({1, 2, 3, 4, 5}, {-1, 2, 4, 5, 7}, {}).size(), 2U) << "y < 0";
  EXPECT_EQ(fitted_laws({1, 2, 3, 4, 5}, {1, 2, 4, 5, 7}, {}).size(), 3U);
}

}  // namespace
}  // namespace mahlwerk::report::laws_test

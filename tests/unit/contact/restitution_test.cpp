// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/restitution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mahlwerk/contact/bounce.hpp"
#include "statement.hpp"

namespace mahlwerk::contact::restitution_test {
namespace {

/// Restitution of viscoelastic spheres by integration: x'' = -(x^(3/2) + damping sqrt(x) x'),
/// x'(0) = 1, in units of the collision, until the force between the spheres vanishes. In SI,
/// damping = (3/2) A k^(2/5) v^(1/5) = beta v^(1/5).
double integrated(double damping) {
  const auto force = [&](double x, double v) {
    return x > 0 ? -std::sqrt(x) * (x + damping * v) : 0.0;
  };
  const double h = 1e-4 * std::min(1.0, 1 / damping);
  double x = 0, v = 1;
  for (;;) {  // classical Runge-Kutta
    const double a1 = force(x, v), v2 = v + 0.5 * h * a1;
    const double a2 = force(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
    const double a3 = force(x + 0.5 * h * v2, v3), v4 = v + h * a3;
    const double a4 = force(x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (v < 0 && x + damping * v <= 0) return -v;
  }
}

TEST(Restitution, viscoelastic_is_the_contact_equation_integrated) {
  constexpr double unit = 0.05;  // damping at 1 m/s
  const Restitution law = Restitution::viscoelastic(integrated(unit), 1);
  double worst = 0, least = 1, most = 0;
  for (double damping = 1e-3; damping < 20; damping *= 1.2) {
    const double e = integrated(damping), v = std::pow(damping / unit, 5);
    worst = tests::max_or_nan(worst, std::abs(law.at(v) - e));
    least = std::min(least, e);
    most = tests::max_or_nan(most, e);
  }
  EXPECT_LT(least, 0.02);
  EXPECT_GT(most, 0.998);
  tests::stays_below("viscoelastic restitution off the contact equation", worst, 2e-4,
                     "own integration of the viscoelastic contact");
}

TEST(Restitution, viscoelastic_begins_as_the_known_series) {
  // e = 1 - x + (3/5) x^2 - ..., x ~ v^(1/5); Ramirez, Poeschel, Brilliantov and Schwager 1999.
  const Restitution law = Restitution::viscoelastic(0.9, 1);
  const double unit = (1 - law.at(1e-30)) * 1e6;  // x at 1 m/s
  for (const double v : {1e-15, 1e-10, 1e-5}) {
    const double x = unit * std::pow(v, 0.2);
    tests::states("e at small speed", law.at(v), 1 - x + 0.6 * x * x, 0.06 * x * x + 1e-12,
                  "series");
  }
  EXPECT_EQ(law.at(0), 1);
}

TEST(Restitution, viscoelastic_goes_through_the_value_it_was_given) {
  for (const double e : {0.01, 0.3, 0.8, 0.999, 1.0})
    for (const double v : {1e-3, 1.0, 30.0}) {
      const Restitution law = Restitution::viscoelastic(e, v);
      EXPECT_NEAR(law.at(v), e, 1e-12);
      EXPECT_EQ(law.value(), e);
      EXPECT_EQ(law.speed(), v);
    }
}

TEST(Restitution, viscoelastic_falls_with_speed) {
  const Restitution law = Restitution::viscoelastic(0.8, 1);
  double last = 1;
  for (double v = 1e-12; v < 1e12; v *= 1.5) {
    EXPECT_LT(law.at(v), last);
    EXPECT_GT(law.at(v), 0);
    last = law.at(v);
  }
}

TEST(Restitution, a_table_is_linear_in_the_logarithm_of_the_speed) {
  const Restitution law = Restitution::tabulated({{0.1, 0.9}, {1, 0.7}, {100, 0.1}});
  EXPECT_EQ(law.at(0), 0.9);
  EXPECT_EQ(law.at(0.05), 0.9);
  EXPECT_EQ(law.at(0.1), 0.9);
  EXPECT_NEAR(law.at(std::sqrt(0.1)), 0.8, 1e-15);
  EXPECT_EQ(law.at(1), 0.7);
  EXPECT_NEAR(law.at(10), 0.4, 1e-15);
  EXPECT_EQ(law.at(100), 0.1);
  EXPECT_EQ(law.at(1e9), 0.1);
}

TEST(Restitution, a_number_is_a_constant_restitution) {
  const BounceRule rule{0.9, 0.5, INFINITY};
  EXPECT_EQ(rule.restitution, 0.9);
  EXPECT_EQ(rule.restitution.at(1e-9), 0.9);
  EXPECT_EQ(rule.restitution.at(1e9), 0.9);
  EXPECT_EQ(rule, (BounceRule{0.9, 0.5, INFINITY}));
}

TEST(Restitution, laws_with_the_same_numbers_are_equal_and_others_are_not) {
  EXPECT_EQ(Restitution::viscoelastic(0.8, 2), Restitution::viscoelastic(0.8, 2));
  EXPECT_NE(Restitution::viscoelastic(0.8, 2), Restitution::viscoelastic(0.8, 1));
  EXPECT_NE(Restitution::viscoelastic(0.8, 2), Restitution(0.8));
  EXPECT_NE(Restitution::tabulated({{1, 0.8}}), Restitution(0.8));
}

TEST(Restitution, numbers_that_make_no_law_are_refused) {
  const auto visco = [](double e, double v) { return Restitution::viscoelastic(e, v); };
  EXPECT_THROW(visco(0, 1), std::invalid_argument);
  EXPECT_THROW(visco(1.1, 1), std::invalid_argument);
  EXPECT_THROW(visco(0.5, 0), std::invalid_argument);
  EXPECT_THROW(visco(NAN, 1), std::invalid_argument);
  const auto table = [](const Restitution::Points& p) { return Restitution::tabulated(p); };
  EXPECT_THROW(table({}), std::invalid_argument);
  EXPECT_THROW(table({{0, 0.5}}), std::invalid_argument);
  EXPECT_THROW(table({{1, 0.5}, {1, 0.4}}), std::invalid_argument);
  EXPECT_THROW(table({{1, 0.5}, {2, 1.4}}), std::invalid_argument);
}

TEST(Bounce, a_forced_restitution_takes_the_rule_s_place) {
  const BounceRule rule{Restitution::tabulated({{1, 0.5}, {2, 0.1}}), 1, INFINITY};
  EXPECT_EQ(bounce(rule, 2, 1, 0).normal, 3);
  EXPECT_EQ(bounce(rule, 2, 1, 0, 1).normal, 4);
}

}  // namespace
}  // namespace mahlwerk::contact::restitution_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/ball_charge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "statement.hpp"

namespace mahlwerk::tests::ball_charge_test {
namespace {

using powder::BallCharge;

constexpr double fresh = 0.05, scrap = 0.015;  // [m]

/// A charge of fresh balls after many steps of wear with make-up. A fresh ball would lose the share
/// `step` of its diameter in a step, and d' ~ d^exponent.
BallCharge worn_charge(double exponent, double step, std::size_t cohorts = 100'000) {
  BallCharge charge{{fresh, 1000}};
  const int steps = static_cast<int>(12 / step);  // twelve lives of a ball of linear wear
  for (int i = 0; i < steps; ++i) {
    std::vector<double> volumes;
    for (const powder::Cohort& c : charge) {
      const double slower = std::pow(c.diameter / fresh, exponent);
      volumes.push_back(3 * step * slower * fresh / c.diameter * powder::sphere_volume(c.diameter));
    }
    const double worn = powder::wear_down(charge, volumes);
    powder::add_fresh(charge, fresh, worn + powder::scrap_below(charge, scrap));
    powder::join_cohorts(charge, cohorts);
  }
  return charge;
}

/// The largest difference of the share of mass below a size from the steady state, at a third, half
/// and two thirds of the range.
double off_by(const BallCharge& charge, double exponent) {
  double worst = 0;
  for (const double share : {1. / 3, 0.5, 2. / 3}) {
    const double d = scrap + share * (fresh - scrap);
    double below = 0;
    for (const powder::Cohort& c : charge) below += c.diameter < d ? c.volume() : 0;
    worst = std::max(worst, std::abs(below / powder::volume_of(charge) -
                                     powder::steady_mass_below(d, scrap, fresh, exponent)));
  }
  return worst;
}

TEST(BallCharge, with_make_up_keeps_its_volume_to_rounding) {
  const BallCharge charge = worn_charge(0, 0.03, 10);
  const double at_start = 1000 * powder::sphere_volume(fresh);
  states("volume [m3]", powder::volume_of(charge), at_start, 1e-12 * at_start,
         "what is added is what was lost");
  EXPECT_LE(charge.size(), 10U);
}

TEST(BallCharge, comes_to_the_steady_state_of_linear_wear) {
  const double coarse = off_by(worn_charge(0, 0.01), 0), fine = off_by(worn_charge(0, 0.0025), 0);
  // A cohort is a step of the distribution: its share of mass is (step d_0) 4 d^3/(d_0^4 - s^4).
  stays_below("share of mass off, steps of 1 %", coarse, 4 * 0.01, "one cohort (wea.15)");
  stays_below("share of mass off, steps of 0.25 %", fine, 4 * 0.0025, "one cohort (wea.15)");
}

TEST(BallCharge, comes_to_the_steady_state_of_wear_in_proportion_to_the_mass) {
  stays_below("share of mass off, steps of 0.25 %", off_by(worn_charge(1, 0.0025), 1), 4 * 0.0025,
              "one cohort (wea.16)");
  EXPECT_GT(off_by(worn_charge(1, 0.0025), 0), 0.02) << "the two laws can be told apart";
}

TEST(BallCharge, joined_cohorts_keep_number_and_volume) {
  BallCharge charge{{0.05, 3.5}, {0.04, 2}, {0.039, 7}, {0.02, 100}};
  const double volume = powder::volume_of(charge);
  powder::join_cohorts(charge, 3);
  ASSERT_EQ(charge.size(), 3U);
  EXPECT_EQ(charge[1].number, 9) << "the most alike";
  states("volume [m3]", powder::volume_of(charge), volume, 1e-15 * volume, "(wea.14)");
}

TEST(BallCharge, whole_numbers_keep_the_volume_within_half_a_ball) {
  const BallCharge charge{{0.05, 3.4}, {0.04, 2.4}, {0.03, 0.3}, {0.02, 10.2}};
  const auto numbers = powder::whole_numbers(charge);
  double volume = 0;
  for (std::size_t i = 0; i < charge.size(); ++i)
    volume += static_cast<double>(numbers[i]) * powder::sphere_volume(charge[i].diameter);
  states("volume [m3]", volume, powder::volume_of(charge), 0.5 * powder::sphere_volume(0.02),
         "half of the smallest ball");
}

TEST(BallCharge, a_step_of_half_the_size_halves_the_error_of_a_diameter) {
  // d' = -1 exactly: a ball of diameter 1 has 0.5 after 0.5.
  const auto after = [](int steps) {
    BallCharge charge{{1, 1}};
    for (int i = 0; i < steps; ++i) {
      const double d = charge[0].diameter;
      powder::wear_down(charge, {3 * powder::sphere_volume(d) / d * 0.5 / steps});
    }
    return charge[0].diameter - 0.5;
  };
  states("ratio of the errors", after(100) / after(200), 2, 0.05, "Euler's method (wea.13)");
}

}  // namespace
}  // namespace mahlwerk::tests::ball_charge_test

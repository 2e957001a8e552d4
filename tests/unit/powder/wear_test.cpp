// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/wear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/contact/bounce.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::wear_test {
namespace {

using tests::states;

const double pi = std::numbers::pi;

/// Finnie's f at an angle from the surface, in his notation.
double by_angle(double a) {
  return std::tan(a) <= 1.0 / 3 ? std::sin(2 * a) - 3 * std::sin(a) * std::sin(a)
                                : std::cos(a) * std::cos(a) / 3;
}
double f_at(double angle, double speed = 1) {
  return finnie(speed * std::sin(angle), speed * std::cos(angle));
}

TEST(Archard, a_block_that_slides) {
  // 20 N pressed on hardened steel, 600 HV, over 1 km at mu = 0.25: 5 kJ of friction.
  const double way = load_distance(0.25 * 20 * 1000, 0.25);
  states("force times way [N m]", way, 20'000, 1e-9, "20 N over 1 km");
  states("volume [mm3]", 1e9 * archard(1e-4, way, hardness(600)), 2.0 / 5.88399, 1e-12,
         "K F s/H; 600 kgf/mm2 = 5.88399 GPa");
  states("half as hard, volume ratio",
         archard(1e-4, way, hardness(300)) / archard(1e-4, way, hardness(600)), 2, 1e-14, "1/H");
}

TEST(Archard, knows_no_way_without_friction) {
  EXPECT_EQ(load_distance(0, 0), 0);
}

TEST(Contamination, of_a_known_mass) {
  states("1 mm3 of steel in 10 g [ug/g]", ug_per_g(1e-9, 7800, 0.01), 780, 1e-10, "7.8 mg in 10 g");
}

TEST(Finnie, by_two_speeds_is_finnie_by_the_angle) {
  double off = 0;
  for (int i = 0; i <= 9000; ++i)
    for (const double speed : {1e-3, 1.0, 7.0}) {
      const double angle = i / 9000.0 * pi / 2;
      off = tests::max_or_nan(off, std::abs(f_at(angle, speed) - by_angle(angle)));
    }
  states("largest difference, 0 to 90 degrees", off, 0, 2e-15, "the trigonometric form; rounding");
}

TEST(Finnie, wears_nothing_head_on_nor_by_grazing) {
  EXPECT_EQ(finnie(3, 0), 0);
  EXPECT_EQ(finnie(0, 3), 0);
  EXPECT_EQ(finnie(0, 0), 0);
}

TEST(Finnie, is_continuous_where_its_two_branches_meet) {
  const double edge = std::atan(1.0 / 3);
  states("just below tan a = 1/3", f_at(edge - 1e-9), 0.3, 2e-9, "sin 2a - 3 sin^2 a = 0.3");
  states("just above", f_at(edge + 1e-9), 0.3, 2e-9, "cos^2 a/3 = 0.3");
}

TEST(Finnie, peaks_at_seventeen_degrees) {
  double best = 0, at = 0;
  for (double angle = 0; angle < pi / 2; angle += 1e-5)
    if (f_at(angle) > best) {
      best = f_at(angle);
      at = angle;
    }
  states("angle of the most wear [deg]", at * 180 / pi, 0.5 * std::atan(2.0 / 3) * 180 / pi, 1e-3,
         "tan 2a = 2/3: 16.85 degrees; step of the search 6e-4");
  states("the most", best, (std::sqrt(13.0) - 3) / 2, 1e-9, "sqrt(13)/2 - 3/2 = 0.3028");
}

TEST(Finnie, of_an_impact_is_k_times_energy_times_f_over_hardness) {
  const double a = 0.2, speed = 5;
  const double volume = finnie_volume(1e-4, 0.004, speed * std::sin(a), speed * std::cos(a), 6e9);
  const double wanted = 1e-4 * 0.004 * 25 * by_angle(a) / 6e9;
  states("volume over k m u^2 f/H", volume / wanted, 1, 1e-14, "wea.4");
}

TEST(Finnie, agrees_with_archard_where_a_ball_grazes) {
  const double e = 0.8, mu = 0.3, coefficient = 1e-4, mass = 0.004, slip = 3, h = hardness(600);
  for (const double tangent : {1e-2, 1e-3, 1e-4}) {
    const double approach = tangent * slip;
    const auto j = contact::bounce({e, 0, mu}, mass, approach, slip);
    const double lost = contact::loss(j, mass, approach, slip).tangential;
    const double ratio = finnie_volume(0.5 * (1 + e) * coefficient, mass, approach, slip, h) /
                         archard(coefficient, load_distance(lost, mu), h);
    const double slows = 0.5 * 3.5 * mu * (1 + e);  // reduction of the slip by half the impulse
    states("Finnie over Archard, k = K (1 + e)/2", ratio, 1, (slows + 1.5) * tangent + 1e-12,
           "both K m (1 + e) u_n u_t/H, to first order in the angle (wea.5)");
  }
}

}  // namespace
}  // namespace mahlwerk::powder::wear_test

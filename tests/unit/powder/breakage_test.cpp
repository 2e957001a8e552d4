// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/powder/sample.hpp"
#include "powder_models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::breakage_test {
namespace {

using tests::states;

TEST(Breakage, vogel_and_peukerts_chance_is_their_formula) {
  const VogelPeukert model{2, 0.1};
  states("x W = 0.6 J m/kg", model.breakage_probability(2e-3, 300), 1 - std::exp(-2 * (0.6 - 0.1)),
         1e-15, "physics 5.2");
  EXPECT_EQ(model.breakage_probability(2e-3, 50), 0);  // at the threshold
}

TEST(Breakage, vogel_and_peukerts_shortcut_decides_as_the_chance_does) {
  const VogelPeukert model{2, 0.1};
  SplitMix64 draw(3);
  for (int i = 0; i < 1000000; ++i) {
    const double size = 1e-3 * (0.1 + draw()), energy = 3000 * draw() * draw(), drawn = draw();
    ASSERT_EQ(model.breaks(size, energy, drawn), drawn < model.breakage_probability(size, energy))
        << size << " m, " << energy << " J/kg, " << drawn;
  }
}

TEST(Breakage, threshold_of_finer_grains_is_higher_by_its_exponent) {
  const Threshold model{200, 1e-3, 0.5};
  EXPECT_EQ(model.breakage_probability(0.25e-3, 399.9), 0);
  EXPECT_EQ(model.breakage_probability(0.25e-3, 400.1), 1);
}

TEST(Breakage, tavares_median_breaks_half_of_the_grains) {
  for (const double cut : {0.0, 4.0}) {
    Tavares model{43.4, 3.48e-3, 1.61, 0.5, cut, 5, 0.6, 0.03};
    // With a cut, E' = E_max E/(E_max - E) is E_50 at E = E_50 cut/(cut + 1).
    const double at = model.median(1e-3) * (cut > 0 ? cut / (cut + 1) : 1);
    states("chance", model.breakage_probability(1e-3, at), 0.5, 1e-15, "physics 5.2");
    EXPECT_EQ(model.breakage_probability(1e-3, cut > 0 ? cut * model.median(1e-3) : 1e9), 1);
  }
}

TEST(Breakage, tavares_damage_is_one_at_the_strength_and_a_power_far_below) {
  const Tavares model{43.4, 3.48e-3, 1.61, 0.5, 0, 5, 0.6, 0.03};
  states("at the strength", model.damage(1), 1, 0, "2 gamma/(2 gamma) = 1; physics 5.2");
  // With r(D) the right-hand side, r'(1) = 1 and r''(1) = 1 + 5/(2 gamma): D approaches 1 like a
  // square root.
  const double short_of = std::sqrt(2 * (2 * 5.0 / 5) * 1e-9 / (1 + 5 / (2 * 5.0)));
  states("just below", model.damage(1 - 1e-9), 1 - short_of, short_of * short_of * 10,
         "1 - sqrt(2 (2 gamma/5) (1 - x)/(1 + 5/(2 gamma))), next order");
  const double load = 1e-4, expected = std::pow(2 * 5.0 * load / 15, 2);
  states("far below", model.damage(load), expected, 10 * expected * expected,
         "D = (2 gamma x/(2 gamma + 5))^(2 gamma/5), next term 2 D of it");
  for (double x = 0.01; x < 1; x += 0.01) {
    const double d = model.damage(x);
    EXPECT_NEAR(d, std::pow(10 * x / (15 - 5 * d), 2), 1e-13) << "its own equation, load " << x;
  }
}

TEST(Breakage, strengths_drawn_break_as_often_as_the_chance_says) {
  const Tavares model{43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03};
  for (const double z : {-2.0, -0.3, 0.0, 1.1, 2.5})
    states("share broken",
           model.breakage_probability(1e-3, model.median(1e-3) * model.relative_strength(z)),
           0.5 * std::erfc(-z / std::sqrt(2.0)), 1e-14, "(brk.5)");
}

TEST(Fragments, share_finer_than_a_tenth_is_t10) {
  for (const double t10 : {0.01, 0.3, 0.9})
    states("t_n at n = 10", T10Fragments{}.breakage_function(0.1, 1e-3, t10), t10, 1e-15,
           "physics 5.2");
  states("its own t10 before the model's", (T10Fragments{0.2, 1}).breakage_function(0.1, 1e-3, 0.7),
         0.2, 1e-15, "(frg.3)");
}

TEST(Fragments, halves_are_two_equal_volumes) {
  SplitMix64 draw(7);
  states("size", Halves{}.draw_fragment(1, 0, draw), std::cbrt(0.5), 1e-15, "two equal volumes");
}

}  // namespace
}  // namespace mahlwerk::powder::breakage_test

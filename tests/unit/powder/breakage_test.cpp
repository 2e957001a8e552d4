// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/powder/sample.hpp"
#include "models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::breakage_test {
namespace {

using tests::states;

TEST(Breakage, chance_of_every_model_rises_with_energy_from_none_to_certainty) {
  for (const AnyBreakage& any : tests::every_breakage())
    std::visit(
        [](const auto& model) {
          double last = 0;
          for (double energy = 1e-3; energy < 1e7; energy *= 1.3) {
            const double chance = model.breakage_probability(1e-3, energy);
            EXPECT_GE(chance, last) << model.name << " at " << energy << " J/kg";
            EXPECT_LE(chance, 1) << model.name;
            last = chance;
          }
          EXPECT_LT(model.breakage_probability(1e-3, 1e-3), 1e-6) << model.name;
          EXPECT_GT(last, 1 - 1e-6) << model.name;
        },
        any);
}

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

TEST(Fragments, every_curve_rises_from_nothing_to_one) {
  for (const AnyFragments& any : tests::every_fragments())
    std::visit(
        [](const auto& model) {
          double last = 0;
          for (double ratio = 1e-9; ratio <= 1; ratio *= 1.1) {
            const double finer = model.breakage_function(ratio, 1e-3, 0.3);
            EXPECT_GE(finer, last) << model.name << " at " << ratio;
            last = finer;
          }
          states(std::string(model.name) + " at the size broken",
                 model.breakage_function(1, 1e-3, 0.3), 1, 1e-15, "all pieces are smaller");
          EXPECT_LT(model.breakage_function(1e-9, 1e-3, 0.3), 1e-6) << model.name;
        },
        any);
}

TEST(Fragments, share_finer_than_a_tenth_is_t10) {
  for (const double t10 : {0.01, 0.3, 0.9})
    states("t_n at n = 10", T10Fragments{}.breakage_function(0.1, 1e-3, t10), t10, 1e-15,
           "physics 5.2");
  states("its own t10 before the model's", (T10Fragments{0.2, 1}).breakage_function(0.1, 1e-3, 0.7),
         0.2, 1e-15, "(frg.3)");
}

/// Kolmogorov's distance between drawn sizes and the breakage function.
template <class Model>
double distance(const Model& model, double parent, double t10, int count) {
  SplitMix64 draw(7);
  std::vector<double> sizes;
  for (int i = 0; i < count; ++i) sizes.push_back(model.draw_fragment(parent, t10, draw));
  std::ranges::sort(sizes);
  double far = 0;
  for (int i = 0; i < count; ++i) {
    const double said =
        model.breakage_function(sizes[static_cast<std::size_t>(i)] / parent, parent, t10);
    far = std::max({far, std::abs(said - static_cast<double>(i) / count),
                    std::abs(said - static_cast<double>(i + 1) / count)});
  }
  return far;
}

TEST(Fragments, sizes_drawn_follow_their_curve) {
  constexpr int count = 100000;
  for (const AnyFragments& any : tests::every_fragments())
    std::visit(
        [](const auto& model) {
          if (std::is_same_v<std::decay_t<decltype(model)>, Halves>) return;  // one size only
          for (const double t10 : {0.05, 0.6})
            tests::stays_below(std::string(model.name) + ", Kolmogorov's distance",
                               distance(model, 1e-3, t10, count), 1.95 / std::sqrt(count),
                               "exceeded once in a thousand; 1.95/sqrt(n)");
        },
        any);
  SplitMix64 draw(7);
  states("halves", Halves{}.draw_fragment(1, 0, draw), std::cbrt(0.5), 1e-15, "two equal volumes");
}

}  // namespace
}  // namespace mahlwerk::powder::breakage_test

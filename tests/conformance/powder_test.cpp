// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every model of the four registers of powder/models.hpp: what captures powder, what breaks a
// grain, into which fragments, and what converts it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/powder/sample.hpp"
#include "powder_models.hpp"
#include "register_types.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::powder_test {
namespace {

template <class Model>
class Capture : public ::testing::Test {};
TYPED_TEST_SUITE(Capture, TypesOf<powder::CaptureModels>::type, NameOfModel);

TYPED_TEST(Capture, of_more_energy_is_no_less_powder_and_always_finite) {
  const TypeParam model = sample<TypeParam>();
  const powder::Nip nip{.radius = 4e-3, .modulus = 1.1e11};
  const powder::Grain grain{.size = 1e-4, .density = 2650, .fracture_energy = 300};
  double last = 0;
  for (double energy = 1e-15; energy < 1e4; energy *= 1.7) {
    const powder::Capture found = model.capture(nip, energy, grain);
    EXPECT_GE(found.probability, 0) << energy;
    EXPECT_LE(found.probability, 1) << energy;
    EXPECT_GE(found.grains, 1) << energy;
    EXPECT_GE(found.radius, 0) << energy;
    EXPECT_TRUE(std::isfinite(found.grains) && std::isfinite(found.radius)) << energy;
    const double mass = found.mean_mass(grain);
    EXPECT_GE(mass, last * (1 - 1e-12)) << energy;
    last = mass;
  }
  EXPECT_GT(last, 0);
}

template <class Model>
class Breakage : public ::testing::Test {};
TYPED_TEST_SUITE(Breakage, TypesOf<powder::BreakageModels>::type, NameOfModel);

TYPED_TEST(Breakage, chance_rises_with_energy_from_none_to_certainty) {
  const TypeParam model = sample<TypeParam>();
  double last = 0;
  for (double energy = 1e-3; energy < 1e7; energy *= 1.3) {
    const double chance = model.breakage_probability(1e-3, energy);
    EXPECT_GE(chance, last) << energy << " J/kg";
    EXPECT_LE(chance, 1) << energy << " J/kg";
    last = chance;
  }
  EXPECT_LT(model.breakage_probability(1e-3, 1e-3), 1e-6);
  EXPECT_GT(last, 1 - 1e-6);
}

TYPED_TEST(Breakage, coarse_grains_break_no_later_than_fine_ones) {
  const TypeParam model = sample<TypeParam>();
  for (const double energy : {50.0, 500.0, 5000.0}) {
    double last = 0;
    for (double size = 1e-6; size < 1e-2; size *= 1.5) {
      const double chance = model.breakage_probability(size, energy);
      EXPECT_GE(chance, last * (1 - 1e-12)) << size << " m, " << energy << " J/kg";
      last = chance;
    }
  }
}

TYPED_TEST(Breakage, t10_is_a_share_that_rises_with_energy) {
  if constexpr (TypeParam::predicts_t10) {
    const TypeParam model = sample<TypeParam>();
    double last = 0;
    for (double energy = 1; energy < 1e6; energy *= 1.3) {
      const double t10 = model.t10(1e-3, energy);
      EXPECT_GE(t10, last) << energy << " J/kg";
      EXPECT_LE(t10, 1) << energy << " J/kg";
      last = t10;
    }
    EXPECT_GT(last, 0.1);
  }
}

template <class Model>
class Fragments : public ::testing::Test {};
TYPED_TEST_SUITE(Fragments, TypesOf<powder::FragmentsModels>::type, NameOfModel);

TYPED_TEST(Fragments, finer_than_a_size_rise_from_nothing_to_all) {
  const TypeParam model = sample<TypeParam>();
  double last = 0;
  for (double ratio = 1e-9; ratio <= 1; ratio *= 1.1) {
    const double finer = model.breakage_function(ratio, 1e-3, 0.3);
    EXPECT_GE(finer, last) << ratio;
    last = finer;
  }
  states("at the size broken", model.breakage_function(1, 1e-3, 0.3), 1, 1e-15,
         "all pieces are smaller");
  EXPECT_LT(model.breakage_function(1e-9, 1e-3, 0.3), 1e-6);
}

/// Kolmogorov's distance between drawn sizes and the breakage function.
template <class Model>
double kolmogorov(const Model& model, double parent, double t10, int count) {
  powder::SplitMix64 draw(7);
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

TYPED_TEST(Fragments, sizes_drawn_follow_the_curve) {
  if (std::is_same_v<TypeParam, powder::Halves>) return;  // one size only: unit/powder
  constexpr int count = 100000;
  for (const double t10 : {0.05, 0.6})
    stays_below("Kolmogorov's distance", kolmogorov(sample<TypeParam>(), 1e-3, t10, count),
                1.95 / std::sqrt(count), "exceeded once in a thousand; 1.95/sqrt(n)");
}

/// A mill that does so much in a second, times `pace`, to so much powder.
powder::MillingConditions mill_of(double pace, double powder) {
  return {.powder_mass = powder,
          .dose_rate = 50 * pace * 1e-3 / powder,
          .impact_rate = 40 * pace,
          .hits = {{1e-3, 20 * pace, 2e-6}, {4e-3, 12 * pace, 3e-6}, {9e-3, 8 * pace, 4e-6}},
          .temperature = {.constant = 350}};
}

template <class Model>
class Kinetics : public ::testing::Test {
 protected:
  Model model = sample<Model>();
};
TYPED_TEST_SUITE(Kinetics, TypesOf<powder::KineticsModels>::type, NameOfModel);

TYPED_TEST(Kinetics, conversion_rises_from_nothing_and_is_the_sum_of_its_products) {
  const powder::MillingConditions mill = mill_of(1, 1e-3);
  EXPECT_EQ(this->model.shares(mill, 0).conversion, 0);
  double last = 0;
  for (double time = 1; time < 1e6; time *= 1.3) {
    const powder::ReactionShares found = this->model.shares(mill, time);
    EXPECT_GE(found.conversion, last * (1 - 1e-12)) << time;
    EXPECT_LE(found.conversion, 1) << time;
    EXPECT_GE(found.product, 0) << time;
    EXPECT_GE(found.second_product, 0) << time;
    EXPECT_NEAR(found.product + found.second_product, found.conversion, 1e-14) << time;
    last = found.conversion;
  }
  EXPECT_GT(last, 0.8);
}

TYPED_TEST(Kinetics, mill_that_does_all_in_half_the_time_converts_as_much) {
  for (const double time : {3.0, 30.0, 300.0}) {
    const double expected = this->model.shares(mill_of(1, 1e-3), 2 * time).conversion;
    states("conversion after " + std::to_string(time) + " s",
           this->model.shares(mill_of(2, 1e-3), time).conversion, expected, 1e-9 * expected,
           "twice the hits, half the time, at one temperature; tolerance: quadrature (rea.7)");
  }
}

TYPED_TEST(Kinetics, more_powder_in_the_same_mill_converts_no_sooner) {
  for (const double time : {3.0, 30.0, 300.0})
    EXPECT_LE(this->model.shares(mill_of(1, 2e-3), time).conversion,
              this->model.shares(mill_of(1, 1e-3), time).conversion)
        << time;
}

}  // namespace
}  // namespace mahlwerk::tests::powder_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The register of quantities.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"

namespace mahlwerk::results::register_test {
namespace {

TEST(Ranges, of_all_quantities_begin_at_zero_but_those_of_signed_ones) {
  const std::set<std::string> is_unbounded{
      "power_imbalance",
      "toe_angle",
      "shoulder_angle",
      "temperature_balls",
      "temperature_jar",
      "thermocouple_reading",
      "property",
      "bed_angle",
      "charge_lever_arm",
      "surface_distance",
      "surface_layer_bottom",
      "surface_speed",
      "surface_shear_rate",
      "charge_height",
      "charge_rise",
      "dissipated_power_of_lasting_contacts"};  // a difference of two powers
  EXPECT_GT(all_measures().size(), 120U);
  for (const Measure& m : all_measures()) {
    const Range range = range_of(m.name);
    EXPECT_EQ(std::isinf(range.least), is_unbounded.contains(m.name)) << m.name;
    EXPECT_TRUE(std::isinf(range.least) || range.least == 0) << m.name;
  }
}

TEST(Ranges, of_shares_end_at_one_and_thresholds_change_none) {
  EXPECT_EQ(range_of("flight_share").most, 1);
  EXPECT_EQ(range_of("grazing_share_above_threshold").most, 1);
  EXPECT_EQ(range_of("impact_angle_mean").most, 90);
  EXPECT_TRUE(std::isinf(range_of("withheld_power_share").most));  // over another power
  EXPECT_EQ(range_of("collision_rate_above_threshold").least, 0);
  EXPECT_TRUE(std::isinf(range_of("no_such_quantity").least));
}

TEST(Register, has_each_quantity_once_with_a_label_of_its_own) {
  std::set<std::string> names, labels;
  for (const Measures* list : {&all_measures(), &measures_of_whole()})
    for (const Measure& m : *list) {
      EXPECT_TRUE(names.insert(m.name).second) << m.name;
      EXPECT_TRUE(labels.insert(label_of(m.name)).second) << m.name;
      EXPECT_FALSE(m.unit.empty() || m.about.empty()) << m.name;
    }
}

TEST(Register, has_a_record_of_each_quantity_of_a_kind_of_pair) {
  for (const PairMeasure& m : pair_measures())
    if (const Measure* whole = record_of(m.name)) {
      EXPECT_EQ(whole->unit, m.unit) << m.name;
    } else {
      EXPECT_EQ(traits_of(m.name).range.least, 0) << m.name;
    }
}

TEST(Register, orders_key_numbers_and_columns_without_gaps) {
  std::vector<Quantity> all;
  for (const Measure& m : all_measures())
    all.push_back({.name = m.name, .unit = m.unit, .about = m.about});
  const std::vector<std::string> key = key_quantities(all);
  EXPECT_EQ(key.size(), 13U);
  EXPECT_EQ(key.front(), "dissipated_power");
  EXPECT_EQ(usual_columns().size(), 9U);
  EXPECT_EQ(usual_columns().front(), "d90");
}

}  // namespace
}  // namespace mahlwerk::results::register_test

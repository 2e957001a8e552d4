// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The register of quantities.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "unit/results/fake.hpp"

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
      "morrell_toe_angle",
      "morrell_shoulder_angle",
      "parts_power",  // a part that the balls drive has a negative one
      "parts_torque",
      "driven_speed",  // a mill may turn the other way
      "driven_speed_end",
      "drive_torque",
      "drive_power",
      "lacey_index",  // of a charge less mixed than a segregated one
      "segregation_radial",
      "segregation_vertical",
      "segregation_axial",
      "bed_porosity",
      "axial_dispersion",
      "dissipated_power_of_lasting_contacts"};  // a difference of two powers
  EXPECT_GT(all_measures().size(), 120U);
  for (const Measure& m : all_measures()) {
    const Range range = range_of(m.name);
    EXPECT_EQ(std::isinf(range.least), is_unbounded.contains(m.name))
        << m.name << ": give its record a .range, or name it in is_unbounded above";
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
      EXPECT_TRUE(labels.insert(label_of(m.name)).second)
          << m.name << ": another quantity has its label; give its record another";
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

TEST(Register, has_a_series_of_each_quantity_whose_precision_may_end_a_run) {
  for (const std::string& name : cases::until_quantities())
    EXPECT_NE(record_of(name)->traits.over_time, nullptr) << name;
}

/// What a case without powder would have with more sections, each quantity once.
TEST(Register, says_which_section_a_missing_quantity_needs) {
  const auto section_of = [](const cases::Case& c, const std::string& name) {
    std::string section;
    for (const MissingQuantity& m : missing_quantities(c))
      if (m.name == name) section += m.section;
    return section;
  };
  cases::Case c = fake_outcome().mill_case;
  EXPECT_EQ(section_of(c, "specific_energy_dose_rate"), "[powder] with its mass");
  EXPECT_EQ(section_of(c, "wear_rate_jar"), "[wear]");
  EXPECT_EQ(section_of(c, "temperature_balls"), "[heat]");
  EXPECT_EQ(section_of(c, "contamination_rate"), "[wear], and [powder] with its mass");
  EXPECT_EQ(section_of(c, "dissipated_power"), "") << "is there";
  c.powder.emplace().mass = 0.001;
  EXPECT_EQ(section_of(c, "specific_energy_dose_rate"), "");
  EXPECT_EQ(section_of(c, "captured_mass_rate"), "[capture]");
  EXPECT_EQ(section_of(c, "d50"), "[grinding]");
  EXPECT_EQ(section_of(c, "conversion"), "[kinetics]");
  EXPECT_EQ(section_of(c, "contamination_rate"), "[wear]");
  c.milling = cases::MillingTime{.time = 60};
  EXPECT_EQ(section_of(c, "worn_mass"), "[wear]");
  EXPECT_EQ(section_of(c, "contamination"), "[wear]");
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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/ucum.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "mahlwerk/base/unit_table.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/results/files/quantity_list.hpp"

namespace mahlwerk::report::ucum_test {
namespace {

TEST(Ucum, units_have_the_codes_of_the_standard) {
  EXPECT_EQ(ucum("1"), "1");
  EXPECT_EQ(ucum(""), "1");
  EXPECT_EQ(ucum("mm"), "mm");
  EXPECT_EQ(ucum("1/s"), "/s");
  EXPECT_EQ(ucum("kg/m3"), "kg/m3");
  EXPECT_EQ(ucum("N m"), "N.m");
  EXPECT_EQ(ucum("Pa s"), "Pa.s");
  EXPECT_EQ(ucum("W/m2/K"), "W/m2/K");
  EXPECT_EQ(ucum("W/(m2 K)"), "W/m2/K");
  EXPECT_EQ(ucum("J m/kg"), "J.m/kg");
  EXPECT_EQ(ucum("ug/g/h"), "ug/g/h");
  EXPECT_EQ(ucum("rpm"), "{rev}/min");
  EXPECT_EQ(ucum("degC"), "Cel");
  EXPECT_EQ(ucum("ml"), "mL");
  EXPECT_EQ(ucum("%"), "%");
  EXPECT_EQ(ucum("kWh/t"), "(kW.h)/t");
}

TEST(Ucum, a_unit_that_nobody_knows_has_no_code) {
  EXPECT_EQ(ucum("furlong"), "");
  EXPECT_EQ(ucum("m/"), "");
}

TEST(Ucum, every_unit_of_cases_and_results_has_a_code) {
  for (const cases::KeyInfo& key : cases::all_keys())
    EXPECT_NE(ucum(key.unit), "") << key.key << " in " << key.unit;
  const results::Json quantities = results::quantity_list();
  for (const results::Json& one : std::get<results::Json::Array>(quantities.value())) {
    const auto& unit = std::get<std::string>(one.find("unit")->value());
    EXPECT_NE(ucum(unit), "") << unit;
  }
  for (const Unit& unit : all_units()) EXPECT_NE(ucum(unit.symbol), "") << unit.symbol;
}

}  // namespace
}  // namespace mahlwerk::report::ucum_test

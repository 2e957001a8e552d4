// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::formula_test {
namespace {

using namespace sample;

Quantity said(std::string_view key) {
  if (key == "jar.diameter") return parse_quantity("12 mm");
  if (key == "balls.2.diameter") return parse_quantity("8 mm");
  if (key == "mill.speed") return parse_quantity("400 rpm");
  throw FormulaError("nobody says " + std::string(key));
}

double value(std::string_view formula, std::string_view unit) {
  return parse_in(text_of(evaluate(formula, said)), unit);
}

std::string fault(std::string_view formula) {
  try {
    text_of(evaluate(formula, said));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "";
}

TEST(Formula, is_reckoned_in_units) {
  EXPECT_DOUBLE_EQ(value("5 ml / (pi/4 * jar.diameter^2)", "m"),
                   5e-6 / (std::numbers::pi / 4 * 0.012 * 0.012));
  EXPECT_DOUBLE_EQ(value("2 * balls.2.diameter + 1 mm", "m"), 0.017);
  EXPECT_DOUBLE_EQ(value("7850 kg/m3 * balls.2.diameter^3", "kg"), 7850 * 0.008 * 0.008 * 0.008);
  EXPECT_DOUBLE_EQ(value("-2 * mill.speed", "rpm"), -800);
  EXPECT_DOUBLE_EQ(value("2^3^2", ""), 512);
  EXPECT_DOUBLE_EQ(value("-2^2", ""), -4);
  EXPECT_DOUBLE_EQ(value("8 - 2 - 1", ""), 5);
  EXPECT_DOUBLE_EQ(value("8 / 2 / 2", ""), 2);
  EXPECT_DOUBLE_EQ(value("30 % * 10 mm", "m"), 0.003);
}

TEST(Formula, degrees_are_a_temperature_and_no_multiple_of_one) {
  EXPECT_DOUBLE_EQ(value("20 degC + 5 K", "K"), 298.15);
  EXPECT_DOUBLE_EQ(value("(20 degC + 40 degC) / 2", "K"), 303.15);
  EXPECT_NE(fault("-5 degC").find("268.15 K"), std::string::npos);
  EXPECT_NE(fault("20 * degC").find("follow a number"), std::string::npos);
}

TEST(Formula, a_power_of_a_number_with_a_unit_must_say_of_which) {
  EXPECT_NE(fault("0.5 m^2").find("write 0.5 m2 or (0.5 m)^2"), std::string::npos)
      << fault("0.5 m^2");
  EXPECT_DOUBLE_EQ(value("0.5 m2", "m2"), 0.5);
  EXPECT_DOUBLE_EQ(value("(0.5 m)^2", "m2"), 0.25);
}

TEST(Formula, knows_a_few_functions) {
  EXPECT_DOUBLE_EQ(value("sqrt(jar.diameter * jar.diameter)", "m"), 0.012);
  EXPECT_DOUBLE_EQ(value("cbrt(8 ml)", "m"), 0.02);
  EXPECT_DOUBLE_EQ(value("min(jar.diameter, balls.2.diameter, 20 mm)", "m"), 0.008);
  EXPECT_DOUBLE_EQ(value("max(abs(-3), 2)", ""), 3);
}

TEST(Formula, what_makes_no_sense_is_said) {
  EXPECT_NE(fault("jar.diameter + 1 s").find("cannot be added"), std::string::npos);
  EXPECT_NE(fault("jar.diameter^jar.diameter").find("exponent"), std::string::npos);
  EXPECT_NE(fault("sqrt(jar.diameter)").find("no unit"), std::string::npos);
  EXPECT_NE(fault("2 * (3 + 4").find("\")\" is missing"), std::string::npos);
  EXPECT_NE(fault("2 *").find("value is missing"), std::string::npos);
  EXPECT_NE(fault("2 jar.diameter").find("operator is missing"), std::string::npos);
  EXPECT_NE(fault("sin(1)").find("no function sin"), std::string::npos);
  EXPECT_NE(fault("1 / 0").find("not finite"), std::string::npos);
  EXPECT_NE(fault("5 foo").find("foo"), std::string::npos);
  EXPECT_NE(fault("jar.nothing").find("jar.nothing"), std::string::npos);
  EXPECT_NE(fault("3 4").find("left over"), std::string::npos);
  EXPECT_NE(fault(std::string(5000, '(')).find("brackets"), std::string::npos);
  EXPECT_NE(fault(std::string(5000, '-') + "1").find("brackets"), std::string::npos);
}

constexpr const char* follows =
    "[sweep]\n\"jar.diameter\" = [\"10 mm\", \"14 mm\"]\n"
    "\"balls.diameter\" = \"= jar.diameter / 2\"\n";

TEST(Formula, a_key_follows_from_what_varies) {
  const Case base = read_sample(vial + follows);
  EXPECT_DOUBLE_EQ(base.balls[0].diameter, 0.006);  // the case's own jar has 12 mm
  const Case point = read_sample(vial + follows, {{"jar.diameter", "14 mm", ValueSource::sweep}});
  EXPECT_DOUBLE_EQ(point.balls[0].diameter, 0.007);
  EXPECT_EQ(point.sweep.derived.at("balls.diameter"), " jar.diameter / 2");
}

TEST(Formula, keys_that_follow_from_each_other_are_refused) {
  const std::string round =
      "[sweep]\n\"mill.frequency\" = [\"10 Hz\"]\n\"jar.diameter\" = \"= 2 * balls.diameter\"\n"
      "\"balls.diameter\" = \"= jar.diameter / 2\"\n";
  try {
    read_sample(vial + round);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("depends on itself"), std::string::npos)
        << error.what();
  }
}

TEST(Formula, what_sweep_varies_cannot_be_set) {
  try {
    read_sample(vial + follows, {{"jar.diameter", "11 mm"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("[sweep] varies jar.diameter"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace mahlwerk::cases::formula_test

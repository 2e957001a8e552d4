// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `estimate`: a case from a few words, and bands from the values that it assumes.
#include "mahlwerk/results/files/json_value.hpp"
#include "program.hpp"

namespace mahlwerk::tests::estimate_test {
namespace {

using results::Json;

const std::string words =
    "estimate 'MM 400' --jar 25ml --material zro2 --balls 2x10mm --frequency 30Hz --powder 200mg ";

class Estimate : public ProgramTest {};

double number(const Json& all, const std::string& quantity, const char* what) {
  return std::get<double>(all.find("quantities")->find(quantity)->find(what)->value());
}

TEST_F(Estimate, has_the_numbers_of_a_run_of_its_case) {
  const ProgramResult told = mahlwerk(words + "--time 1h --json --save saved.toml");
  ASSERT_EQ(told.code, 0) << told.output;
  const Json all = Json::parse(told.output);
  ASSERT_EQ(mahlwerk("run saved.toml --out whole --quiet").code, 0);
  const Json whole = Json::parse(text("whole/summary.json"));
  for (const std::string name :
       {"dissipated_power", "collision_rate_above_threshold", "energy_normal_mean_above_threshold",
        "specific_energy_dose", "time_to_dose"}) {
    EXPECT_EQ(number(all, name, "value"),
              std::get<double>(whole.find(name)->find("value")->value()))
        << name;
    EXPECT_LT(number(all, name, "low"), number(all, name, "value")) << name;
    EXPECT_GT(number(all, name, "high"), number(all, name, "value")) << name;
  }
  EXPECT_EQ(all.find("quantities")->find("specific_energy_dose_per_hour"), nullptr);
  const auto& causes = std::get<Json::Array>(
      all.find("quantities")->find("dissipated_power")->find("causes")->value());
  ASSERT_FALSE(causes.empty());
  EXPECT_EQ(std::get<std::string>(causes.front().find("key")->value()), "contact.restitution");
  EXPECT_NE(told.output.find("assumed-mill"), std::string::npos) << "what the run warns of";
}

TEST_F(Estimate, narrows_with_what_is_known) {
  const ProgramResult wide = mahlwerk(words + "--json"),
                      narrow = mahlwerk(words +
                                        "--json --set contact.restitution=0.8 --set "
                                        "mill.swing=3.8deg");
  ASSERT_EQ(wide.code + narrow.code, 0) << wide.output << narrow.output;
  const Json one = Json::parse(wide.output), other = Json::parse(narrow.output);
  const auto width = [](const Json& all) {
    return number(all, "dissipated_power", "high") / number(all, "dissipated_power", "low");
  };
  EXPECT_EQ(number(one, "dissipated_power", "value"), number(other, "dissipated_power", "value"))
      << "these values were assumed";
  EXPECT_LT(width(other), 0.5 * width(one));
  EXPECT_NE(one.find("quantities")->find("specific_energy_dose_per_hour"), nullptr) << "no --time";
}

TEST_F(Estimate, has_bands_of_doses_that_go_with_the_power) {
  const ProgramResult told = mahlwerk(words + "--json --time 1h");
  ASSERT_EQ(told.code, 0) << told.output;
  const Json all = Json::parse(told.output);
  for (const char* end : {"low", "high"}) {
    const double power = number(all, "dissipated_power", end) /
                         number(all, "dissipated_power", "value"),
                 dose = number(all, "specific_energy_dose", end) /
                        number(all, "specific_energy_dose", "value");
    EXPECT_NEAR(dose, power, 1e-12 * power);
  }
  EXPECT_NEAR(number(all, "time_to_dose", "low") * number(all, "dissipated_power", "high"),
              number(all, "time_to_dose", "value") * number(all, "dissipated_power", "value"),
              1e-9);
}

TEST_F(Estimate, prints_nothing_if_quiet_and_how_to_run_the_case_with_what_was_set) {
  EXPECT_EQ(mahlwerk(words + "--quiet --set run.replicates=1 --set run.time='0.2 s'").output, "");
  const ProgramResult told =
      mahlwerk(words + "--save a.toml --set run.replicates=1 --set run.time='0.2 s'");
  EXPECT_NE(told.output.find("mahlwerk run a.toml --set run.replicates=1 --set 'run.time=0.2 s'"),
            std::string::npos)
      << told.output;
}

TEST_F(Estimate, says_what_makes_a_band_wide_and_where_more_is) {
  const ProgramResult told = mahlwerk(words);
  ASSERT_EQ(told.code, 0) << told.output;
  for (const char* part : {"best guess", "restitution 0.3 to 0.9",
                           "--set contact.restitution=", "Warning: Assumed", "--save FILE"})
    EXPECT_NE(told.output.find(part), std::string::npos) << part << '\n' << told.output;
}

TEST_F(Estimate, refuses_in_the_words_of_its_options) {
  const std::string mill = "estimate 'MM 400' --material zro2 --frequency 30Hz ";
  expect_refused("estimate 'MM 40' --balls 2x10mm", "no mill called");
  expect_refused(mill, "no balls are given");
  expect_refused(mill + "--balls 2", "NUMBER x DIAMETER");
  expect_refused(mill + "--balls 2x10kg", "there is no length");
  expect_refused(mill + "--balls 2x1,5cm", "write a decimal point");
  expect_refused(mill + "--balls 'many x 10 mm'", "no number, mass or percentage");
  expect_refused(mill + "--balls 0x10mm", "whole number from 1");
  expect_refused(mill + "--balls 500x10mm", "densest packing");
  expect_refused(mill + "--balls 2x10mm --jar 26ml", "retsch-mm-25ml");
  expect_refused(mill + "--balls 2x10mm --powder 1:0", "no ratio of masses");
  expect_refused("estimate 'MM 400' --balls 2x10mm", "give --frequency");
  expect_refused("estimate 'MM 400' --balls 2x10mm", "give --material");
  expect_refused("estimate Emax --material zro2 --balls 2x10mm --speed 1000rpm", "give --jar");
  expect_refused(mill + "--balls 2x10mm --jar 2.5ml", "no such jar");
  expect_refused(mill + "--balls 2x10mm --time 1h", "give --powder");
  expect_refused(mill + "--balls 2x10mm --speed 300rpm", "leave out --speed");
  expect_refused(mill + "--balls 2x10mm --save . --force", "this is a folder");
  expect_refused(mill + "--balls 2x10mm --save no/where.toml", "no folder for this file");
  expect_refused("estimate gaffet-g7 --material zro2 --balls 2x10mm --speed 300rpm",
                 "--set mill.ratio=");
  expect_refused("check 'MM 400'", "mahlwerk estimate retsch-mm400 --balls");
  std::ofstream(here_ / "there.toml") << "mine";
  expect_refused(mill + "--balls 2x10mm --save there.toml", "--force");
  EXPECT_EQ(text("there.toml"), "mine");
}

}  // namespace
}  // namespace mahlwerk::tests::estimate_test

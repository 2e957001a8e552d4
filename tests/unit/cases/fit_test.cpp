// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [fit] in a case, and the numbers that `mahlwerk fit` may adjust.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/powder/models.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::fit_test {
namespace {

using namespace sample;

/// A case without f_mat; the line after [fit] is line 39.
const std::string unfitted = vial + R"([powder]
mass = "0.15 g"
density = "1280 kg/m3"
size = "1.3 mm"
[capture]
model = "trapped-volume"
thickness = "1.3 mm"
[breakage]
model = "vogel-peukert"
x_w_min = "0.1 J m/kg"
[fragments]
model = "binary"
[grinding]
time = "30 s"
[fit]
)";
const std::string f_mat = "\"breakage.f_mat\" = [\"0.01 kg/J/m\", \"100 kg/J/m\"]\n";

std::string fault(const std::string& lines, const std::vector<Override>& overrides = {}) {
  return fault_of(unfitted + lines, overrides);
}

TEST(Fit, a_case_that_only_fit_gives_a_value_is_not_read) {
  EXPECT_EQ(fault(f_mat),
            "case.toml:39|breakage.f_mat has no value yet: [fit] only gives the range to search|"
            "`mahlwerk fit case.toml data.csv` finds it from measurements, or give one|"
            "unfitted");
  EXPECT_EQ(fault("\"grinding.sticking\" = [0, 0.5]\n" + f_mat, {{"breakage.f_mat", "2 kg/J/m"}}),
            "case.toml:39|grinding.sticking has no value yet: [fit] only gives the range to "
            "search|`mahlwerk fit case.toml data.csv` finds it from measurements, or give one|"
            "unfitted");
}

TEST(Fit, with_a_value_for_each_key_the_case_is_read) {
  const Case c = read_sample(unfitted + f_mat, {{"breakage.f_mat", "2 kg/J/m"}});
  EXPECT_EQ(fit_parameter_value(c, "breakage.f_mat"), 2);
  EXPECT_EQ(c.fit,
            (std::map<std::string, FitRange>{{"breakage.f_mat", {"0.01 kg/J/m", "100 kg/J/m"}}}));
  EXPECT_TRUE(read_sample(write(c)) == c) << write(c);
}

TEST(Fit, ranges_alone_are_read_from_a_case_without_values) {
  const Folder folder;
  folder.write("case.toml", unfitted + f_mat + "[fit.capture]\nenergy_share = [0.1, 1]\n");
  folder.write("other.toml", vial);
  folder.write("wrong.toml", unfitted + "\"breakage.f_mat\" = [\"1 kg/J/m\"]\n");
  EXPECT_EQ(fit_ranges(folder.path() / "case.toml"),
            (std::map<std::string, FitRange>{{"breakage.f_mat", {"0.01 kg/J/m", "100 kg/J/m"}},
                                             {"capture.energy_share", {"0.1", "1"}}}));
  EXPECT_TRUE(fit_ranges(folder.path() / "other.toml").empty());
  EXPECT_THROW(fit_ranges(folder.path() / "wrong.toml"), InputError);
  EXPECT_THROW(fit_ranges(folder.path() / "none.toml"), InputError);
}

TEST(Fit, ranges_that_are_none) {
  const std::vector<Override> given{{"breakage.f_mat", "2 kg/J/m"}};
  const auto says = [&](const std::string& range, const std::string& part) {
    const std::string said = fault("\"breakage.f_mat\" = " + range + "\n", given);
    EXPECT_TRUE(said.starts_with("case.toml:39|")) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  says("[\"1 kg/J/m\"]", "must be two values, the least and the most|");
  says("\"1 kg/J/m\"", "|wrong-type");
  says("[1, 2]", "the unit is missing");
  says("[\"1 mm\", \"2 mm\"]", "|bad-quantity");
  says("[\"2 kg/J/m\", \"1 kg/J/m\"]", "\"2 kg/J/m\" is not below \"1 kg/J/m\"|");
  says("[\"1 kg/J/m\", \"1 kg/J/m\"]", "|out-of-range");
  says("[\"0 kg/J/m\", \"1 kg/J/m\"]",
       "\"0 kg/J/m\" is out of range|strength of the material: how soon its grains break, f_Mat: "
       "above 0 kg/J/m|out-of-range");
}

TEST(Fit, keys_that_it_cannot_choose) {
  const auto says = [&](const std::string& key, const std::string& part) {
    const std::string said = fault("\"" + key + "\" = [1, 2]\n", {{"breakage.f_mat", "2 kg/J/m"}});
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  says("breakage.x_w_mi", "[fit] cannot choose breakage.x_w_mi|did you mean \"breakage.x_w_min\"?");
  says("grinding.time", "[fit] cannot choose grinding.time|");
  says("run.time", "it may choose \"capture.thickness\", ");
  EXPECT_NE(fault_of(vial + "[fit]\n\"breakage.f_mat\" = [1, 2]\n").find("the case has none"),
            std::string::npos);
  EXPECT_NE(fault_of("fit = 5\n" + vial).find("|`fit` must be a section|"), std::string::npos);
}

TEST(Fit, avramis_exponent_needs_avramis_law) {
  const std::string kinetics =
      vial + "[powder]\nmass = \"1 g\"\n[kinetics]\ntime = \"1 h\"\ndose_constant = \"5 kJ/g\"\n";
  const std::string fit = "[fit]\n\"kinetics.exponent\" = [0.5, 4]\n";
  const std::vector<Override> start{{"kinetics.exponent", "1"}};
  EXPECT_NE(fault_of(kinetics + fit).find("|unfitted"), std::string::npos);
  EXPECT_NE(fault_of(kinetics + fit, start).find("|too-much"), std::string::npos);
  const Case c = read_sample(kinetics + "law = \"avrami\"\n" + fit, start);
  EXPECT_EQ(fit_parameter_value(c, "kinetics.exponent"), 1);
}

TEST(Adjustables, are_the_numbers_of_the_chosen_models_and_a_few_more) {
  const Case c = read_sample(unfitted + "[kinetics]\ndose_constant = \"5 kJ/g\"\n",
                             {{"breakage.f_mat", "2 kg/J/m"}});
  std::vector<std::string> keys;
  for (const FitParameter& one : fit_parameters(c)) keys.push_back(one.key);
  EXPECT_EQ(keys, (std::vector<std::string>{
                      "capture.thickness", "capture.packing", "capture.energy_share",
                      "breakage.f_mat", "breakage.x_w_min", "grinding.sticking", "grinding.welding",
                      "grinding.welding_energy", "kinetics.dose_constant", "kinetics.exponent",
                      "kinetics.onset"}));
  EXPECT_TRUE(fit_parameters(read_sample(vial)).empty());
}

TEST(Adjustables, are_set_in_their_units_as_if_the_case_said_so) {
  Case c = read_sample(unfitted, {{"breakage.f_mat", "2 kg/J/m"}});
  for (const FitParameter& one : fit_parameters(c)) {
    const double value = one.range.most < 1 ? 0.25 * one.range.most : 0.25;
    ASSERT_TRUE(one.range.holds(value)) << one.key;
    set_fit_parameter(c, one.key, value);
    EXPECT_EQ(fit_parameter_value(c, one.key), value) << one.key;
  }
  EXPECT_EQ(std::get<powder::TrappedVolume>(*c.capture->model).thickness, 0.25);
  EXPECT_EQ(c.capture->energy_share, 0.25);
  EXPECT_EQ(std::get<powder::VogelPeukert>(*c.grinding->breakage).f_mat, 0.25);
  EXPECT_EQ(c.grinding->welding_energy, 0.25);
  EXPECT_THROW(set_fit_parameter(c, "breakage.phi", 1), std::invalid_argument);
  EXPECT_THROW(fit_parameter_value(c, "grinding.time"), std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::cases::fit_test

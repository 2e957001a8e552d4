// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `fit` with keys of the mill: calibration, and runs with its result.
#include <cmath>

#include "program.hpp"

namespace mahlwerk::tests::calibration_test {
namespace {

const std::string mill = R"(
title = "Twenty balls in a vibration mill"
seed = 5
[mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "7 mm"
[jar]
kind = "cylinder"
diameter = "60 mm"
height = "60 mm"
[[balls]]
count = 20
diameter = "12 mm"
material = "steel-1.4034"
[contact]
friction = 0.2
[run]
engine = "event"
time = "1 s"
settle = "0.2 s"
replicates = 2
)";
const std::string fit = "[fit]\n\"contact.restitution\" = [\"0.2\", \"0.95\"]\n";

class Calibration : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("case.toml", mill + fit);
  }
  void write(const std::string& name, const std::string& said) const {
    std::ofstream(here_ / name) << said;
  }
  /// The drawn power [W] in a result.
  double power(const std::string& folder) const {
    const std::string json = text(folder + "/summary.json");
    const auto at = json.find("\"value\": ", json.find("\"drawn_power\""));
    return std::stod(json.substr(at + 9));
  }
  /// Powers at three frequencies with a restitution of 0.6 in power.csv, with errors of 2 %.
  void make_data() const {
    std::string table = "mill.frequency (Hz),drawn_power (W),drawn_power_error (W)\n";
    for (const std::string hertz : {"14", "18", "22"}) {
      const ProgramResult e = mahlwerk(
          "run case.toml --quiet --seed 77 --set contact.restitution=0.6 --set "
          "run.replicates=12 --set mill.frequency='" +
          hertz + " Hz' --out true" + hertz);
      ASSERT_EQ(e.code, 0) << e.output;
      const double p = power("true" + hertz);
      table += hertz + "," + std::to_string(p) + "," + std::to_string(0.02 * p) + "\n";
    }
    write("power.csv", table);
  }
};

TEST_F(Calibration, finds_the_restitution_again_and_its_case_carries_the_uncertainty) {
  make_data();
  const ProgramResult e =
      mahlwerk("fit case.toml power.csv --out out --settings 24 --json --quiet");
  ASSERT_EQ(e.code, 0) << e.output;
  const std::string json = text("out/fit.json");
  const auto number = [&](const std::string& word) {
    const auto at = json.find("\"" + word + "\": ", json.find("\"contact.restitution\""));
    return std::strtod(json.c_str() + at + word.size() + 4, nullptr);
  };
  EXPECT_LT(number("low"), 0.6);
  EXPECT_GT(number("high"), 0.6);
  EXPECT_LT(number("high") - number("low"), 0.4) << "of a range of 0.75";
  for (const char* file : {"fit.html", "fit.csv", "posterior.csv"})
    EXPECT_GT(text(std::string("out/") + file).size(), 100U) << file;
  const ProgramResult run = mahlwerk("run out/calibrated.toml --set run.replicates=8 --out again");
  ASSERT_EQ(run.code, 0) << run.output;
  EXPECT_NE(run.output.find("Each replicate has another draw of contact.restitution"),
            std::string::npos)
      << run.output;
  EXPECT_NE(text("again/case.resolved.toml").find("[uncertainty]"), std::string::npos);
}

TEST_F(Calibration, that_is_interrupted_goes_on_and_gives_the_same) {
  make_data();
  ASSERT_EQ(mahlwerk("fit case.toml power.csv --out whole --settings 24 --quiet").code, 0);
  const ProgramResult cut =
      mahlwerk_until("part.checkpoints/trials.sqlite", SIGINT,
                     "fit case.toml power.csv --out part --settings 24 --quiet");
  if (cut.code != 0) {
    EXPECT_EQ(cut.code, 130) << cut.output;
    EXPECT_NE(cut.output.find("run the same command again"), std::string::npos) << cut.output;
  }
  ASSERT_EQ(mahlwerk("fit case.toml power.csv --out part --settings 24 --quiet --force").code, 0);
  EXPECT_EQ(text("part/fit.csv"), text("whole/fit.csv"));
  EXPECT_EQ(text("part/posterior.csv"), text("whole/posterior.csv"));
}

TEST_F(Calibration, says_what_is_wrong_with_its_input) {
  write("power.csv", "mill.frequency (Hz),drawn_power (W)\n20,2\n");
  const auto says = [&](const std::string& words, const std::string& part) {
    const ProgramResult e = mahlwerk("fit " + words);
    EXPECT_EQ(e.code, 2) << e.output;
    EXPECT_NE(e.output.find(part), std::string::npos) << e.output;
  };
  write("unknown.csv", "drawn_pwer (W)\n2\n");
  says("case.toml unknown.csv", "drawn_power");
  write("unit.csv", "drawn_power (m)\n2\n");
  says("case.toml unit.csv", "drawn_power (W)");
  write("powder.csv", "D90 (um)\n20\n");
  says("case.toml powder.csv", "docs/errors.md#mixed-fit");
  write("sets.csv", "contact.restitution,drawn_power (W)\n0.5,2\n");
  says("case.toml sets.csv", "sets a parameter of [fit]");
  write("fall.csv", "rebound_height (mm)\n20\n");
  says("case.toml fall.csv", "fall_height");
  write("high.csv", "fall_height (mm),rebound_height (mm)\n10,20\n");
  says("case.toml high.csv", "rebounds to less than the height of its fall");
  write("range.toml", mill + "[fit]\n\"contact.restitution\" = [\"0.2\", \"1.5\"]\n");
  says("range.toml power.csv", "contact.restitution");
  write("key.toml", mill + "[fit]\n\"contact.restitutoin\" = [0.2, 0.5]\n");
  says("key.toml power.csv", "did you mean");
}

}  // namespace
}  // namespace mahlwerk::tests::calibration_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The commands `surrogate` and `ask`.
#include "program.hpp"

namespace mahlwerk::tests::surrogate_test {
namespace {

const std::string mill = R"(
title = "One ball in a vibration mill"
[mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "7 mm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "40 mm"
[[balls]]
count = 1
diameter = "12 mm"
material = "steel-1.4034"
[contact]
restitution = 0.5
[run]
engine = "event"
time = "1 s"
replicates = 3
[sweep]
"mill.frequency" = ["15 Hz", "18 Hz", "21 Hz", "24 Hz"]
"contact.restitution" = [0.3, 0.5, 0.7]
)";

class SurrogateCommand : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::ofstream(here_ / "case.toml") << mill;
    ASSERT_EQ(mahlwerk("sweep case.toml --out campaign --quiet").code, 0);
  }
};

TEST_F(SurrogateCommand, writes_a_file_that_ask_answers_from_without_the_campaign) {
  const ProgramResult made = mahlwerk("surrogate campaign --out mill.json");
  ASSERT_EQ(made.code, 0) << made.output;
  EXPECT_NE(made.output.find("mill.frequency"), std::string::npos) << made.output;
  EXPECT_NE(made.output.find("hold-out error"), std::string::npos) << made.output;
  std::filesystem::remove_all(here_ / "campaign");
  std::filesystem::remove(here_ / "case.toml");
  const std::string setting = " --set mill.frequency='20 Hz' --set contact.restitution=0.6";
  const ProgramResult asked = mahlwerk("ask mill.json" + setting);
  EXPECT_EQ(asked.code, 0) << asked.output;
  EXPECT_NE(asked.output.find("dissipated power"), std::string::npos) << asked.output;
  const ProgramResult json = mahlwerk("ask mill.json --json --quantity dissipated_power" + setting);
  EXPECT_EQ(json.code, 0) << json.output;
  EXPECT_NE(json.output.find("\"low\":"), std::string::npos) << json.output;
  EXPECT_EQ(json.output.find("\"collision_rate\":"), std::string::npos) << json.output;
  const ProgramResult knows = mahlwerk("ask mill.json");
  EXPECT_EQ(knows.code, 0);
  EXPECT_NE(knows.output.find("15 Hz"), std::string::npos) << knows.output;
}

TEST_F(SurrogateCommand, says_what_it_cannot_do) {
  expect_refused("surrogate campaign", "--out");
  expect_refused("surrogate nowhere --out mill.json", "the folder holds no campaign");
  expect_refused("surrogate campaign --out mill.json --quantity d90", "no quantity d90");
  expect_refused("surrogate campaign --out campaign", "already exists");
  ASSERT_EQ(mahlwerk("surrogate campaign --out mill.json --quiet").code, 0);
  expect_refused("surrogate campaign --out mill.json", "--force");
  EXPECT_EQ(mahlwerk("surrogate campaign --out mill.json --force --quiet").code, 0);
  expect_refused("surrogate campaign --out campaign --force", "a folder");
  expect_refused("ask nowhere.json --set a=1", "cannot be read");
  expect_refused("ask campaign --set a=1", "cannot be read");
  expect_refused("ask mill.json --set mill.frequency='30 Hz' --set contact.restitution=0.5",
                 "does not extrapolate");
  expect_refused("ask mill.json --set mill.frequency='20 Hz'", "contact.restitution is not given");
  expect_refused("ask mill.json --quantity power --set mill.frequency='20 Hz'", "no such quantity");
}

}  // namespace
}  // namespace mahlwerk::tests::surrogate_test

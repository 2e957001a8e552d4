// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A run of many balls that is ended and resumed from its checkpoint.
#include "program.hpp"

namespace mahlwerk::tests::resume_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* drum = R"(
title = "Drum"
[mill]
kind = "tumbling"
speed = "70 %"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "60 mm"
[[balls]]
filling = "15 %"
diameter = "10 mm"
density = "7850 kg/m3"
[[balls]]
filling = "10 %"
diameter = "6 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.4
[run]
engine = "event"
time = "0.5 s"
settle = "0.1 s"
replicates = 2
[power_meter]
[microphone]
[accelerometer]
duration = "0.5 s"
)";

class Resume : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::ofstream(here_ / "drum.toml") << drum;
  }

  ProgramResult run(const std::string& words) const {
    return mahlwerk("run drum.toml --out " + words);
  }
  /// A run that a signal ends as soon as there is a checkpoint.
  ProgramResult ended_run(int signal) const {
    return mahlwerk_until("parts.checkpoint", signal,
                          "run drum.toml --out parts --checkpoint 0.05");
  }
  void expect_no_resume(const std::string& because, const std::string& set = "") const {
    const ProgramResult e = run("parts --resume" + set);
    EXPECT_EQ(e.code, 2);
    EXPECT_NE(e.output.find(because), std::string::npos) << e.output;
  }

  void turn_a_bit(std::uintmax_t at) const {
    std::fstream file(here_ / "parts.checkpoint", std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const int was = file.get();
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(was ^ 4));
  }
};

TEST_F(Resume, run_ended_and_gone_on_with_gives_the_same_bits) {
  const ProgramResult whole = run("whole --threads 1");
  ASSERT_EQ(whole.code, 0) << whole.output;
  const ProgramResult ended = ended_run(SIGINT);
  ASSERT_EQ(ended.code, 130) << ended.output;
  EXPECT_NE(ended.output.find("--resume"), std::string::npos) << ended.output;
  EXPECT_TRUE(exists("parts.checkpoint"));
  const ProgramResult resumed = run("parts --resume --threads 2");
  ASSERT_EQ(resumed.code, 0) << resumed.output;
  EXPECT_FALSE(exists("parts.checkpoint")) << "the run is complete";
  for (const char* file : {"timeseries.csv", "replicates.csv", "spectrum.csv", "speeds.csv"}) {
    EXPECT_GT(text(std::string("whole/") + file).size(), 100U);
    EXPECT_EQ(text(std::string("whole/") + file), text(std::string("parts/") + file)) << file;
  }
}

TEST_F(Resume, run_that_was_killed_goes_on_from_its_last_state) {
  ASSERT_EQ(ended_run(SIGKILL).code, 128 + SIGKILL);
  ASSERT_TRUE(exists("parts.checkpoint"));
  const ProgramResult resumed = run("parts --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.output;
  EXPECT_TRUE(exists("parts/summary.json"));
}

TEST_F(Resume, other_cases_and_damaged_states_are_refused) {
  expect_no_resume("no checkpoint");
  ASSERT_EQ(ended_run(SIGINT).code, 130);
  expect_no_resume("another run", " --set contact.friction=0.5");
  const fs::path states = here_ / "parts.checkpoint";
  turn_a_bit(fs::file_size(states) / 2);
  expect_no_resume("damaged");
  fs::resize_file(states, fs::file_size(states) / 2);
  expect_no_resume("damaged");
}

}  // namespace
}  // namespace mahlwerk::tests::resume_test

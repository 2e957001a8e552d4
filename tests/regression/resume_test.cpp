// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A run of many balls that is ended and gone on with, as a user does it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace mahlwerk::tests {
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
)";

class Resume : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "mahlwerk-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    here_ = name;
    std::ofstream(here_ / "drum.toml") << drum;
  }
  void TearDown() override { fs::remove_all(here_); }

  /// Exit code of the program; `before` is put in front of its name.
  int mahlwerk(const std::string& words, const std::string& before = "") {
    const std::string command = "cd '" + here_.string() + "' && " + before + " '" +
                                MAHLWERK_PROGRAM + "' " + words + " > said 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));  // NOLINT: the test is the shell's user
  }
  std::string text(const std::string& name) const {
    std::ostringstream all;
    all << std::ifstream(here_ / name).rdbuf();
    return all.str();
  }

  void turn_a_bit(std::uintmax_t at) const {
    std::fstream file(here_ / "parts.checkpoint", std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const int was = file.get();
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(was ^ 4));
  }

  fs::path here_;
};

TEST_F(Resume, run_ended_and_gone_on_with_gives_the_same_bits) {
  ASSERT_EQ(mahlwerk("run drum.toml --out whole --threads 1"), 0) << text("said");
  ASSERT_EQ(mahlwerk("run drum.toml --out parts --checkpoint 0.1",
                     "timeout --preserve-status -s INT 0.3"),
            130)
      << text("said");
  EXPECT_NE(text("said").find("--resume"), std::string::npos) << text("said");
  EXPECT_TRUE(fs::exists(here_ / "parts.checkpoint"));
  ASSERT_EQ(mahlwerk("run drum.toml --out parts --resume --threads 2"), 0) << text("said");
  EXPECT_FALSE(fs::exists(here_ / "parts.checkpoint")) << "the run is complete";
  for (const char* file : {"timeseries.csv", "replicates.csv", "spectrum.csv", "speeds.csv"}) {
    EXPECT_GT(text(std::string("whole/") + file).size(), 100U);
    EXPECT_EQ(text(std::string("whole/") + file), text(std::string("parts/") + file)) << file;
  }
}

TEST_F(Resume, run_that_was_killed_goes_on_from_its_last_state) {
  ASSERT_EQ(mahlwerk("run drum.toml --out parts --checkpoint 0.05",
                     "timeout --preserve-status -s KILL 0.4"),
            137);
  ASSERT_TRUE(fs::exists(here_ / "parts.checkpoint"));
  EXPECT_EQ(mahlwerk("run drum.toml --out parts --resume"), 0) << text("said");
  EXPECT_TRUE(fs::exists(here_ / "parts" / "summary.json"));
}

TEST_F(Resume, other_cases_and_damaged_states_are_refused) {
  EXPECT_EQ(mahlwerk("run drum.toml --out parts --resume"), 2);
  EXPECT_NE(text("said").find("no checkpoint"), std::string::npos) << text("said");
  ASSERT_EQ(mahlwerk("run drum.toml --out parts --checkpoint 0.1",
                     "timeout --preserve-status -s INT 0.3"),
            130);
  EXPECT_EQ(mahlwerk("run drum.toml --out parts --resume --set contact.friction=0.5"), 2);
  EXPECT_NE(text("said").find("another run"), std::string::npos) << text("said");
  turn_a_bit(fs::file_size(here_ / "parts.checkpoint") / 2);
  EXPECT_EQ(mahlwerk("run drum.toml --out parts --resume"), 2);
  EXPECT_NE(text("said").find("damaged"), std::string::npos) << text("said");
  fs::resize_file(here_ / "parts.checkpoint", fs::file_size(here_ / "parts.checkpoint") / 2);
  EXPECT_EQ(mahlwerk("run drum.toml --out parts --resume"), 2);
  EXPECT_NE(text("said").find("damaged"), std::string::npos) << text("said");
}

}  // namespace
}  // namespace mahlwerk::tests

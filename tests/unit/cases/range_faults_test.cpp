// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::range_faults_test {
namespace {

using namespace sample;

// Grids and numbers of steps would overflow.
TEST(CaseFaults, sizes_and_times_that_no_mill_has_are_refused) {
  for (const char* line : {"amplitude = \"1e308 mm\"", "amplitude = \"1.1e6 m\""}) {
    const auto found = sample::faults_of(sample::with(sample::vial, "amplitude", line));
    ASSERT_EQ(found.size(), 1U) << line;
    EXPECT_EQ(found[0].code, "out-of-range");
    EXPECT_NE(found[0].what.find("1000 km at most"), std::string::npos) << found[0].what;
  }
  for (const auto& [key, line] : {std::pair{"diameter = \"8", "diameter = \"5e-324 m\""},
                                  std::pair{"density", "density = \"9e-4 kg/m3\""}}) {
    const auto found = sample::faults_of(sample::with(sample::vial, key, line));
    ASSERT_EQ(found.size(), 1U) << line;
    EXPECT_NE(found[0].what.find(" at least"), std::string::npos) << found[0].what;
  }
  EXPECT_TRUE(
      sample::faults_of(sample::with(sample::vial, "amplitude", "amplitude = \"1e-20 m\"")).empty())
      << "it may be 0";
  Case built = sample::read_sample(sample::vial);
  EXPECT_TRUE(faults(built).empty());
  built.run.time = 1.1e12;
  EXPECT_FALSE(faults(built).empty());
}

TEST(CaseFaults, a_share_that_is_meant_as_a_percentage_is_told_how_to_write_it) {
  const auto remedy = [](const char* line) {
    const auto found = sample::faults_of(sample::with(sample::vial, "restitution", line));
    return found.size() == 1 ? found[0].remedy : "";
  };
  EXPECT_NE(remedy("restitution = 85").find("write restitution = \"85 %\""), std::string::npos);
  EXPECT_EQ(remedy("restitution = 850").find('%'), std::string::npos);
  EXPECT_EQ(remedy("restitution = -1").find('%'), std::string::npos);
  const auto tiny = sample::faults_of(
      sample::with(sample::vial, "restitution", "restitution = 0.5\nsoftening = 1e-35"));
  ASSERT_EQ(tiny.size(), 1U);
  EXPECT_EQ(tiny[0].remedy.find('%'), std::string::npos) << tiny[0].remedy;
}

TEST(CaseFaults, values_out_of_range) {
  const auto out = [](const std::string& key, const std::string& line, int at, const char* what) {
    return only(with(vial, key, line), "case.toml:" + std::to_string(at), what, "out-of-range");
  };
  EXPECT_TRUE(out("restitution", "restitution = 1.3", 17, "at least 0 and at most 1"));
  EXPECT_TRUE(out("restitution", "restitution = -0.1", 17, "at least 0 and at most 1"));
  EXPECT_TRUE(out("tangential", "tangential_restitution = -1.01", 18, "at least -1 and at most 1"));
  EXPECT_TRUE(out("tangential", "tangential_restitution = 0\nfriction = -0.1", 19, "at least 0"));
  EXPECT_TRUE(out("frequency", "frequency = \"0 Hz\"", 5, "above 0 Hz"));
  EXPECT_TRUE(out("amplitude", "amplitude = \"-1 mm\"", 6, "at least 0 mm"));
  EXPECT_TRUE(out("diameter = \"12", "diameter = \"0 mm\"", 10, "above 0 mm"));
  EXPECT_TRUE(out("diameter = \"12", "diameter = \"-12 mm\"", 10, "above 0 mm"));
  EXPECT_TRUE(out("volume", "volume = \"0 ml\"", 11, "above 0 ml"));
  EXPECT_TRUE(out("diameter = \"8", "diameter = \"0 mm\"", 14, "above 0 mm"));
  EXPECT_TRUE(out("density", "density = \"0 kg/m3\"", 15, "above 0 kg/m3"));
  EXPECT_TRUE(out("count", "count = 0", 13, "whole number from 1"));
  EXPECT_TRUE(out("count", "count = -3", 13, "whole number from 1"));
  EXPECT_TRUE(out("count", "count = 1.5", 13, "whole number from 1"));
  EXPECT_TRUE(out("count", "count = \"5\"", 13, "whole number from 1"));
  EXPECT_TRUE(out("count", "mass = \"0 g\"", 13, "above 0 g"));
  EXPECT_TRUE(out("count", "filling = \"0 %\"", 13, "above 0"));
  EXPECT_TRUE(out("count", "filling = 1.2", 13, "at most 1"));
  EXPECT_TRUE(out("time", "time = \"0 s\"", 21, "at least 1 ns"));
  EXPECT_TRUE(out("time", "time = \"1 s\"\nsettle = \"-1 s\"", 22, "at least 0 s"));
  EXPECT_TRUE(out("time", "time = \"1 s\"\nreplicates = 0", 22, "from 1 to 10000"));
  EXPECT_TRUE(out("time", "time = \"1 s\"\nreplicates = 10001", 22, "from 1 to 10000"));
  EXPECT_TRUE(out("threshold", "threshold = \"-1 m/s\"", 23, "at least 0 m/s"));
  EXPECT_TRUE(out("seed", "seed = -1", 2, "whole number from 0"));
  EXPECT_TRUE(out("seed", "seed = 1.5", 2, "whole number from 0"));
  EXPECT_TRUE(out("seed", "gravity = \"-1 m/s2\"", 2, "at least 0 m/s2"));
}

}  // namespace
}  // namespace mahlwerk::cases::range_faults_test

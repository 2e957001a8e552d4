// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Papers as a user regenerates them.
#include "program.hpp"

namespace mahlwerk::tests {
namespace {

class Papers : public ProgramTest {};

TEST_F(Papers, OneCommandMakesEveryFigureAndJudgesEveryClaim) {
  const Ended e = mahlwerk("papers vertical-vibration-mill --out out");
  ASSERT_EQ(e.code, 0) << e.said;
  for (const char* file :
       {"out/paper.html", "out/claims.csv", "out/claims.md", "out/diameter/campaign.csv",
        "out/size/point-005/summary.json", "out/figures/figure-7-d90.svg",
        "out/figures/figure-6b-energy_contact_point_mean_above_threshold.svg"})
    EXPECT_TRUE(exists(file)) << file;
  // What the verification tests prove of this mill with tolerances of their own.
  EXPECT_NE(e.said.find("6a     yes"), std::string::npos) << e.said;
  EXPECT_NE(e.said.find("6b     yes"), std::string::npos) << e.said;
  EXPECT_NE(e.said.find("7      yes"), std::string::npos) << e.said;
  EXPECT_NE(e.said.find("intro  no"), std::string::npos) << e.said;
  // Again into the same folder: by --force alone, and then the same numbers.
  const std::string claims = text("out/claims.csv");
  EXPECT_EQ(mahlwerk("papers vertical-vibration-mill --out out").code, 2);
  EXPECT_EQ(mahlwerk("papers vertical-vibration-mill --out out --force --quiet --threads 1").code,
            0);
  EXPECT_EQ(text("out/claims.csv"), claims);
}

/// Runs of a second and more: their states are kept.
constexpr const char* long_runs = R"(
title = "Long runs"
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
[run]
engine = "event"
time = "4000 s"
replicates = 2
[sweep]
"mill.frequency" = ["10 Hz", "15 Hz", "20 Hz"]
)";

TEST_F(Papers, AKilledPaperGoesOnAndGivesTheSame) {
  std::filesystem::create_directory(here_ / "mine");
  std::ofstream(here_ / "mine" / "long.toml") << long_runs;
  std::ofstream(here_ / "mine" / "paper.toml")
      << "title = \"T\"\nsource = \"S\"\n[[claim]]\nfigure = \"1\"\nsays = \"s\"\nkind = "
         "\"trend\"\ncampaign = \"long\"\nquantity = \"dissipated_power\"\nagainst = "
         "\"mill.frequency\"\nis = \"rises\"\n";
  const Ended whole = mahlwerk("papers mine --out whole");
  ASSERT_EQ(whole.code, 0) << whole.said;
  EXPECT_FALSE(exists("whole.checkpoints")) << "all is written";
  EXPECT_EQ(mahlwerk_until("out.checkpoints", SIGKILL, "papers mine --out out").code,
            128 + SIGKILL);
  const Ended again = mahlwerk("papers mine --out out --threads 1");
  ASSERT_EQ(again.code, 0) << again.said;
  EXPECT_NE(again.said.find("of 3 settings go on where they were ended"), std::string::npos)
      << again.said;
  EXPECT_EQ(text("out/claims.csv"), text("whole/claims.csv"));
  EXPECT_EQ(text("out/long/campaign.csv"), text("whole/long/campaign.csv"));
  EXPECT_FALSE(exists("out.checkpoints"));
}

TEST_F(Papers, AnInterruptedPaperWritesNothingAndGoesOn) {
  std::filesystem::create_directory(here_ / "mine");
  std::ofstream(here_ / "mine" / "long.toml") << long_runs;
  std::ofstream(here_ / "mine" / "paper.toml")
      << "title = \"T\"\nsource = \"S\"\n[[figure]]\n"
         "number = \"1\"\ntitle = \"t\"\ncampaign = \"long\"\nquantity = \"dissipated_power\"\n"
         "against = \"mill.frequency\"\n";
  const Ended ended = mahlwerk_until("out.checkpoints", SIGINT, "papers mine --out out");
  EXPECT_EQ(ended.code, 130) << ended.said;
  EXPECT_NE(ended.said.find("the same command goes on"), std::string::npos) << ended.said;
  EXPECT_FALSE(exists("out")) << "half a paper is no paper";
  EXPECT_EQ(mahlwerk("papers mine --out out").code, 0);
}

TEST_F(Papers, WhatIsWrongIsSaidBeforeAnythingRuns) {
  expect_refused("papers no-such-mill --out out", "there is no paper of this name");
  std::filesystem::create_directory(here_ / "mine");
  std::ofstream(here_ / "mine" / "paper.toml")
      << "title = \"T\"\nsource = \"S\"\n[[claim]]\nfigure = \"1\"\nsays = \"s\"\nkind = "
         "\"trend\"\ncampaign = \"c\"\nquantity = \"flight_share\"\nagainst = "
         "\"mill.amplitude\"\nis = \"rises\"\n";
  expect_refused("papers mine --out out", "there is no such case file");
  std::filesystem::copy_file(
      std::filesystem::path(MAHLWERK_HOME) / "papers/vertical-vibration-mill/frequency.toml",
      here_ / "mine" / "c.toml");
  expect_refused("papers mine --out out", "c.toml does not vary mill.amplitude");
  expect_refused("papers mine --out out", "has no quantity flight_share");
}

}  // namespace
}  // namespace mahlwerk::tests

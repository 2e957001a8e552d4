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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `papers`.
#include "program.hpp"

namespace mahlwerk::tests::papers_test {
namespace {

class Papers : public ProgramTest {
 protected:
  /// A paper with one campaign, c.toml, and one claim about `quantity` against `key`.
  void paper(const std::string& quantity, const std::string& key) const {
    std::filesystem::create_directory(here_ / "mine");
    std::ofstream(here_ / "mine" / "paper.toml")
        << "title = \"T\"\nsource = \"S\"\n[[claim]]\nfigure = \"1\"\nsays = \"s\"\nkind = "
           "\"trend\"\ncampaign = \"c\"\nquantity = \""
        << quantity << "\"\nagainst = \"" << key << "\"\nis = \"rises\"\n";
  }
  void campaign() const {
    std::filesystem::copy_file(
        std::filesystem::path(MAHLWERK_HOME) / "papers/vertical-vibration-mill/frequency.toml",
        here_ / "mine" / "c.toml");
  }
  /// Six settings of a vial, to be run with `longer`: many checkpoints of each are written.
  void long_paper() const {
    paper("dissipated_power", "mill.frequency");
    campaign();
  }
  const std::string longer =
      "papers mine --set run.time='4000 s' --set run.replicates=1 --checkpoint 0.05 ";
};

TEST_F(Papers, one_command_makes_every_figure_and_judges_every_claim) {
  const std::string few = "papers vertical-vibration-mill --set run.replicates=8";
  const ProgramResult e = mahlwerk(few + " --out out");
  ASSERT_EQ(e.code, 0) << e.output;
  for (const char* file :
       {"out/paper.html", "out/claims.csv", "out/claims.md", "out/diameter/campaign.csv",
        "out/size/point-005/summary.json", "out/figures/figure-7.svg", "out/figures/figure-7a.csv",
        "out/figures/figure-6.svg", "out/figures/figure-6a.csv", "out/figures/figure-6b.csv",
        "out/figures/captions.md"})
    EXPECT_TRUE(exists(file)) << file;
  // The verification tests prove the same claims for this mill with tolerances of their own.
  EXPECT_NE(e.output.find("6a     yes"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("6b     yes"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("7      yes"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("intro  partly"), std::string::npos) << e.output;
  // A second run into the same folder needs --force, and gives the same numbers.
  const std::string claims = text("out/claims.csv");
  EXPECT_EQ(mahlwerk(few + " --out out").code, 2);
  EXPECT_EQ(mahlwerk(few + " --out out --force --quiet --threads 1").code, 0);
  EXPECT_EQ(text("out/claims.csv"), claims);
}

TEST_F(Papers, figures_have_pdf_and_png_files_or_a_warning_says_why_not) {
  paper("dissipated_power", "mill.frequency");
  campaign();
  std::ofstream(here_ / "mine" / "paper.toml", std::ios::app)
      << "[[figure]]\nnumber = \"1\"\ntitle = \"t\"\ncampaign = \"c\"\nquantity = "
         "\"dissipated_power\"\nagainst = \"mill.frequency\"\n";
  const std::string command = "papers mine --set run.time='1 s' --force --out out";
  const std::string search_path = std::getenv("PATH");
  const auto run_with = [&](const std::string& script) {
    std::filesystem::create_directory(here_ / "bin");
    std::filesystem::remove(here_ / "bin" / "rsvg-convert");
    if (!script.empty()) {
      std::ofstream(here_ / "bin" / "rsvg-convert") << "#!/bin/sh\n" << script;
      std::filesystem::permissions(here_ / "bin" / "rsvg-convert",
                                   std::filesystem::perms::owner_all);
    }
    ::setenv("PATH", (here_ / "bin").c_str(), 1);
    const ProgramResult e = mahlwerk(command);
    ::setenv("PATH", search_path.c_str(), 1);
    EXPECT_EQ(e.code, 0) << e.output;
    EXPECT_TRUE(exists("out/figures/figure-1.svg"));
    return e.output;
  };
  EXPECT_NE(run_with("").find("apt install librsvg2-bin"), std::string::npos);
  EXPECT_FALSE(exists("out/figures/figure-1.pdf"));
  EXPECT_NE(run_with("echo 'no such font' >&2; exit 1\n").find("failed: no such font"),
            std::string::npos);
  EXPECT_FALSE(exists("out/figures/figure-1.pdf"));
  // --format pdf --output FILE ...
  EXPECT_EQ(run_with("echo \"$2\" > \"$4\"\n").find("warning"), std::string::npos);
  EXPECT_EQ(text("out/figures/figure-1.pdf"), "pdf\n");
  EXPECT_EQ(text("out/figures/figure-1.png"), "png\n");
}

TEST_F(Papers, a_killed_paper_goes_on_and_gives_the_same) {
  long_paper();
  const ProgramResult whole = mahlwerk(longer + "--out whole");
  ASSERT_EQ(whole.code, 0) << whole.output;
  EXPECT_FALSE(exists("whole.checkpoints")) << "all is written";
  EXPECT_EQ(mahlwerk_until("out.checkpoints", SIGKILL, longer + "--out out").code, 128 + SIGKILL);
  EXPECT_FALSE(exists("out"));
  const ProgramResult again = mahlwerk(longer + "--out out --threads 1");
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_NE(again.output.find("of 6 settings where they were ended"), std::string::npos)
      << again.output;
  EXPECT_EQ(text("out/claims.csv"), text("whole/claims.csv"));
  EXPECT_EQ(text("out/c/campaign.csv"), text("whole/c/campaign.csv"));
  EXPECT_FALSE(exists("out.checkpoints"));
}

TEST_F(Papers, an_interrupted_paper_writes_nothing_and_goes_on) {
  long_paper();
  const ProgramResult ended = mahlwerk_until("out.checkpoints", SIGINT, longer + "--out out");
  EXPECT_EQ(ended.code, 130) << ended.output;
  EXPECT_NE(ended.output.find("run the same command again to resume"), std::string::npos)
      << ended.output;
  EXPECT_FALSE(exists("out")) << "half a paper is no paper";
  EXPECT_EQ(mahlwerk(longer + "--out out").code, 0);
}

TEST_F(Papers, what_is_wrong_is_said_before_anything_runs) {
  expect_refused("papers no-such-mill --out out", "there is no paper with this name");
  paper("flight_share", "mill.amplitude");
  expect_refused("papers mine --out out", "there is no such case file");
  campaign();
  expect_refused("papers mine --out out", "c.toml does not vary mill.amplitude");
  expect_refused("papers mine --out out", "has no quantity flight_share");
}

}  // namespace
}  // namespace mahlwerk::tests::papers_test

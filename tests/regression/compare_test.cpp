// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `compare`: one case with both engines.
#include <sstream>

#include "program.hpp"

namespace mahlwerk::tests::compare_test {
namespace {

class Compare : public ProgramTest {
 protected:
  std::string short_ = example("05-planetary-soft") +
                       " --set run.time=\"0.1 s\" --set run.settle=\"0.05 s\" --out out ";
};

TEST_F(Compare, leaves_both_results_a_table_and_a_page) {
  const ProgramResult e = mahlwerk("compare " + short_ + "--set observe.frames=\"10 ms\"");
  EXPECT_EQ(e.code, 0) << e.output;
  for (const char* words : {"soft/event", "dissipated power", "1 to 2 m/s", "How to read it"})
    EXPECT_NE(e.output.find(words), std::string::npos) << words << "\n" << e.output;
  for (const char* file :
       {"compare.csv", "compare.html", "compare.json", "event/summary.json", "soft/summary.json",
        "event/report.html", "soft/report.html", "soft/frames-5.xyz"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  const std::string table = text("out/compare.csv");
  EXPECT_TRUE(table.starts_with("quantity,unit,event,event_ci95,soft,soft_ci95,ratio,"));
  EXPECT_NE(table.find("\ndissipated_power,W,"), std::string::npos) << table;
  EXPECT_NE(table.find("\ncollision_rate_by_energy_normal,1/s,"), std::string::npos) << table;
  EXPECT_NE(text("out/soft/summary.json").find("\"engine\": \"soft\""), std::string::npos);
  EXPECT_EQ(mahlwerk("compare " + short_ + "--quiet").code, 2) << "the result is there already";
  EXPECT_EQ(mahlwerk("compare " + short_ + "--force --quiet --seed 3").output, "");
  EXPECT_FALSE(exists("out/soft/frames-5.xyz")) << "replaced";
}

TEST_F(Compare, each_result_is_that_of_a_run) {
  ASSERT_EQ(mahlwerk("compare " + short_ + "--quiet --threads 2").code, 0);
  std::filesystem::rename(here_ / "out", here_ / "both");
  for (const std::string engine : {"event", "soft"}) {
    ASSERT_EQ(mahlwerk("run " + short_ + "--force --quiet --set run.engine=" + engine).code, 0);
    EXPECT_EQ(text("both/" + engine + "/spectrum.csv"), text("out/spectrum.csv"));
  }
}

TEST_F(Compare, that_is_interrupted_or_killed_writes_nothing_and_resumes_to_the_same) {
  const std::string longer = "compare " + example("05-planetary-soft") +
                             " --set run.time='2 s' --set run.settle='0 s' --checkpoint 0.05 ";
  ASSERT_EQ(mahlwerk(longer + "--quiet --out whole").code, 0);
  const ProgramResult ended = mahlwerk_until("out.checkpoints", SIGINT, longer + "--out out");
  EXPECT_EQ(ended.code, 130) << ended.output;
  EXPECT_NE(ended.output.find("out.checkpoints; run the same command again to resume"),
            std::string::npos)
      << ended.output;
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(mahlwerk_until("out.checkpoints", SIGKILL, longer + "--out out").code, 128 + SIGKILL);
  const ProgramResult again = mahlwerk(longer + "--out out --threads 1");
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_NE(again.output.find("of 2 settings where they were ended"), std::string::npos)
      << again.output;
  const auto numbers = [&](const std::string& folder) {
    std::stringstream table(text(folder + "/compare.csv"));
    std::string kept;
    for (std::string line; std::getline(table, line);)
      if (!line.starts_with("computing_time")) kept += line + '\n';
    return kept;
  };
  EXPECT_EQ(numbers("out"), numbers("whole"));
  EXPECT_FALSE(exists("out.checkpoints"));
}

TEST_F(Compare, json_has_both_columns) {
  const ProgramResult e = mahlwerk("compare " + short_ + "--json");
  EXPECT_EQ(e.code, 0) << e.output;
  for (const char* word : {"\"study\": \"compare\"", "\"collision_rate_by_energy_normal\"",
                           "\"event_ci95\"", "\"soft_ci95\"", "\"apart\""})
    EXPECT_NE(e.output.find(word), std::string::npos) << e.output;
}

TEST_F(Compare, one_ball_may_roll_where_several_may_not) {
  const std::string one = example("01-one-ball") + " --set run.time=\"0.2 s\" --out one --quiet";
  EXPECT_EQ(mahlwerk("compare " + one).code, 0);
  expect_refused("compare " + short_ + "--set contact.lasting=roll",
                 "the event engine cannot run this case");
}

TEST_F(Compare, what_only_one_engine_can_run_is_refused) {
  expect_refused("compare " + short_ +
                     "--set contact.restitution_law=viscoelastic "
                     "--set 'contact.restitution_speed=1 m/s'",
                 "the soft engine cannot run this case");
  std::ofstream(here_ / "swept.toml")
      << std::ifstream(std::string(MAHLWERK_HOME) + "/examples/05-planetary-soft/case.toml").rdbuf()
      << "\n[sweep]\n\"mill.speed\" = [\"300 rpm\", \"400 rpm\"]\n";
  expect_refused("compare swept.toml --out out", "[sweep]");
  std::ofstream(here_ / "other.toml") << "";
  expect_refused("compare . --out out", "compare takes one");
}

}  // namespace
}  // namespace mahlwerk::tests::compare_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The commands `optimise` (best settings) and `match` (settings that reproduce another mill).
#include <sys/file.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "program.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::search_test {
namespace {

class Search : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    // The power of this ball has no maximum inside the range: it grows with the frequency.
    write("fast.toml", mill +
                           "[optimise]\nmaximise = \"dissipated_power\"\nsettings = 12\n"
                           "replicates = 4\nover = { \"mill.frequency\" = { from = \"8 Hz\", to = "
                           "\"16 Hz\" } }\n");
    write("limited.toml", mill +
                              "[optimise]\nmaximise = \"dissipated_power\"\nsettings = 16\n"
                              "replicates = 6\nlimits = { impact_speed_normal_mean = \"below 1 "
                              "m/s\" }\nover = { \"mill.frequency\" = { from = \"8 Hz\", to = "
                              "\"16 Hz\" } }\n");
    write("like.toml", mill);
    write("in.toml", mill +
                         "[match]\nsettings = 16\nreplicates = 6\nover = { \"mill.frequency\" = "
                         "{ from = \"6 Hz\", to = \"16 Hz\" } }\n");
  }
  void write(const std::string& name, const std::string& said) const {
    std::ofstream(here_ / name) << said;
  }
  /// The number after "key": in a file, searched from the first occurrence of `after`.
  double number(const std::string& file, const std::string& after, const std::string& key) const {
    const std::string all = text(file);
    const auto from = all.find(after);
    const auto at = all.find("\"" + key + "\": ", from);
    EXPECT_NE(at, std::string::npos) << key << " in " << all;
    return std::strtod(all.c_str() + at + key.size() + 4 + (all[at + key.size() + 4] == '"'),
                       nullptr);
  }

  static std::size_t lines(const std::string& said) {
    return static_cast<std::size_t>(std::ranges::count(said, '\n'));
  }

  const std::string range = "\"mill.frequency\" = { from = \"8 Hz\", to = \"16 Hz\" }";
  const std::string mill = R"(title = "A ball in a vial"
[mill]
kind = "vibration"
frequency = "12 Hz"
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
settle = "0 s"
time = "10 s"
replicates = 3
)";
};

TEST_F(Search, the_fastest_mill_has_the_most_power_and_the_edge_is_told) {
  const ProgramResult e = mahlwerk("optimise fast.toml --out out");
  ASSERT_EQ(e.code, 0) << e.output;
  EXPECT_NE(e.output.find("lies at the upper end of its range, 16 Hz"), std::string::npos)
      << e.output;
  EXPECT_GT(number("out/optimise.json", "keys", "best"), 15.9);
  for (const char* file : {"optimise.html", "settings.csv", "best.toml"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  const ProgramResult best = mahlwerk("check out/best.toml");
  EXPECT_EQ(best.code, 0) << best.output;
  EXPECT_EQ(text("out/best.toml").find("[optimise]"), std::string::npos);
}

TEST_F(Search, a_best_outside_its_engines_validity_is_checked_by_the_other_engine) {
  std::string sticky = mill +
                       "[optimise]\nmaximise = \"dissipated_power\"\nsettings = 6\n"
                       "replicates = 2\nover = { \"mill.frequency\" = { from = \"8 Hz\", "
                       "to = \"16 Hz\" } }\n";
  sticky.replace(sticky.find("tangential_restitution = 0.9"), 28,
                 "law = \"jkr\"\nsurface_energy = \"0.5 J/m2\"");
  sticky.replace(sticky.find("10 s"), 4, "0.3 s");
  write("sticky.toml", sticky);
  const ProgramResult e = mahlwerk("optimise sticky.toml --out out");
  ASSERT_EQ(e.code, 0) << e.output;
  const std::string json = text("out/optimise.json");
  EXPECT_NE(json.find("\"certain\": false"), std::string::npos) << json;
  EXPECT_NE(json.find("\"valid\": false"), std::string::npos) << json;
  EXPECT_NE(json.find("\"code\": \"sticking-law-ignored\""), std::string::npos) << json;
  EXPECT_NE(e.output.find("The optimum is not certain"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("the soft engine gives a dissipated power of"), std::string::npos)
      << e.output;
  EXPECT_NE(text("out/settings.csv").find("sticking-law-ignored"), std::string::npos);
  // The check is a run of the best case with the soft engine and the replicates of the search.
  ASSERT_EQ(mahlwerk("run out/best.toml --out soft --quiet --set run.engine=soft --set "
                     "run.replicates=2")
                .code,
            0);
  EXPECT_EQ(number("out/optimise.json", "\"check\"", "value"),
            number("soft/summary.json", "\"dissipated_power\"", "value"));
}

TEST_F(Search, a_limit_holds_the_mill_back) {
  const ProgramResult e = mahlwerk("optimise limited.toml --out out --quiet");
  ASSERT_EQ(e.code, 0) << e.output;
  EXPECT_NE(text("out/optimise.json").find("\"binds\": true"), std::string::npos);
  const double best = number("out/optimise.json", "keys", "best");
  EXPECT_LT(best, 15.9);
  ASSERT_EQ(mahlwerk("run out/best.toml --out run --quiet --set run.replicates=12").code, 0);
  const double speed = number("run/summary.json", "impact_speed_normal_mean", "value");
  const double half = number("run/summary.json", "impact_speed_normal_mean", "ci95");
  stays_below("mean speed at the best [m/s]", speed - 2 * half, 1, "the limit");
}

TEST_F(Search, the_answer_does_not_hang_on_the_number_of_jobs) {
  ASSERT_EQ(mahlwerk("optimise fast.toml --out one --quiet --jobs 1").code, 0);
  ASSERT_EQ(mahlwerk("optimise fast.toml --out two --quiet --jobs 2").code, 0);
  EXPECT_EQ(text("one/optimise.json"), text("two/optimise.json"));
  EXPECT_EQ(text("one/settings.csv"), text("two/settings.csv"));
  EXPECT_EQ(text("one/optimise.html"), text("two/optimise.html"));
}

TEST_F(Search, a_mill_matches_itself_at_its_own_speed) {
  const ProgramResult e = mahlwerk("match like.toml --in in.toml --out out");
  ASSERT_EQ(e.code, 0) << e.output;
  const double low = number("out/match.json", "keys", "low");
  const double high = number("out/match.json", "keys", "high");
  std::printf("    frequency of the mill itself 12 Hz, found %g to %g Hz\n", low, high);
  EXPECT_LE(low, 12);
  EXPECT_GE(high, 12);
  EXPECT_LT(high - low, 5);
  EXPECT_GT(number("out/match.json", "", "overlap"), 0.8);
  for (const char* file : {"match.html", "best.toml", "a/summary.json", "b/summary.json"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
}

TEST_F(Search, a_match_interrupted_in_mill_a_goes_on_and_gives_the_same) {
  const std::string longer = "match like.toml --in in.toml --jobs 2 --checkpoint 0.1 --out ";
  write("like.toml", std::string(mill).replace(mill.find("10 s"), 4, "1000 s"));
  const ProgramResult ended = mahlwerk_until("out.checkpoints", SIGINT, longer + "out");
  EXPECT_EQ(ended.code, 130) << ended.output;
  EXPECT_NE(ended.output.find("kept in"), std::string::npos) << ended.output;
  EXPECT_TRUE(exists("out.checkpoints")) << ended.output;
  EXPECT_FALSE(exists("out"));
  const ProgramResult again = mahlwerk(longer + "out");
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_NE(again.output.find("resuming a run where it was ended"), std::string::npos)
      << again.output;
  EXPECT_FALSE(exists("out.checkpoints")) << "all is written";
  ASSERT_EQ(mahlwerk(longer + "whole").code, 0);
  EXPECT_EQ(text("out/match.json"), text("whole/match.json"));
  EXPECT_EQ(text("out/match.html"), text("whole/match.html"));
}

TEST_F(Search, what_an_interrupted_search_says_of_what_is_kept_is_true) {
  const ProgramResult ended = mahlwerk_until(
      "out.checkpoints/lock", SIGINT, "optimise fast.toml --set run.time='1000 s' --out out");
  EXPECT_EQ(ended.code, 130) << ended.output;
  const bool kept = ended.output.find("kept in") != std::string::npos;
  EXPECT_EQ(exists("out.checkpoints/trials.sqlite"), kept) << ended.output;
  EXPECT_EQ(exists("out.checkpoints"), kept) << ended.output;
  EXPECT_EQ(ended.output.find("to start over") != std::string::npos, !kept) << ended.output;
  ASSERT_EQ(mahlwerk("optimise fast.toml --out out").code, 0);
  EXPECT_FALSE(exists("out.checkpoints"));
}

TEST_F(Search, two_at_once_in_one_place_are_refused_at_once) {
  std::filesystem::create_directory(here_ / "out.checkpoints");
  const int other = ::open((here_ / "out.checkpoints/lock").c_str(), O_CREAT | O_RDWR, 0600);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  expect_refused("optimise fast.toml --out out", "another process is at work on it");
  expect_refused("match like.toml --in in.toml --out out", "campaign-at-work");
  ::close(other);
  EXPECT_EQ(mahlwerk("optimise fast.toml --out out --quiet").code, 0);
}

TEST_F(Search, what_makes_no_sense_is_refused) {
  expect_refused("optimise like.toml --out out", "has no [optimise]");
  expect_refused("match like.toml --in like.toml --out out", "has no [match]");
  expect_refused("match like.toml --out out", "--in");
  write("wrong.toml", mill +
                          "[optimise]\nmaximise = \"disipated_power\"\nover = { "
                          "\"mill.frequency\" = { from = \"8 Hz\", to = \"16 Hz\" } }\n");
  expect_refused("optimise wrong.toml --out out", "did you mean \"dissipated_power\"?");
  write("unit.toml", mill +
                         "[optimise]\nmaximise = \"dissipated_power\"\nlimits = { drawn_power = "
                         "\"below 3 mm\" }\nover = { \"mill.frequency\" = { from = \"8 Hz\", to "
                         "= \"16 Hz\" } }\n");
  expect_refused("optimise unit.toml --out out", "drawn_power");
}

TEST_F(Search, a_quantity_that_needs_a_section_is_named_with_it) {
  const auto goal = [&](const std::string& wanted) {
    write("goal.toml", mill + "[optimise]\n" + wanted + "\nover = { " + range + " }\n");
    return std::string("optimise goal.toml --out out");
  };
  const std::string line = "goal.toml:" + std::to_string(lines(mill) + 2);
  expect_refused(goal("minimise = \"d50\""), line + ": a run of this case has no quantity \"d50\"");
  expect_refused(goal("minimise = \"d50\""), "needs [grinding]");
  expect_refused(goal("maximise = \"conversion\""), "needs [kinetics]");
  expect_refused(goal("minimise = \"wear_rate\""),
                 "did you mean \"wear_rate_balls\" or \"wear_rate_jar\"? It needs [wear]");
  const std::string best = "maximise = \"dissipated_power\"\nlimits = ";
  expect_refused(goal(best + "{ wear_rate_jr = \"below 1 mg/h\" }"),
                 "did you mean \"wear_rate_jar\"");
  expect_refused(goal(best + "{ contact_time_share = \"below 3 mm\" }"), "a number without a unit");
}

TEST_F(Search, an_end_of_a_range_that_cannot_be_is_cited_as_it_is_written) {
  const auto over = [&](const std::string& said) {
    write("over.toml", mill + "[optimise]\nmaximise = \"dissipated_power\"\nover = { " + said +
                           " }\n[match]\nover = { " + said + " }\n");
  };
  const auto place = [&](std::size_t below) {
    return "over.toml:" + std::to_string(lines(mill) + below) + ": ";
  };
  over("\"mill.frequency\" = { from = 8, to = 16 }");
  const std::string first = "\"mill.frequency\" from = 8: the unit is missing";
  expect_refused("optimise over.toml --out out", place(3) + first);
  expect_refused("optimise over.toml --out out", "to = 16: the unit is missing");
  expect_refused("match like.toml --in over.toml --out out", place(5) + first);
  over("\"mill.frequensy\" = { from = \"8 Hz\", to = \"16 Hz\" }");
  expect_refused("optimise over.toml --out out", place(3) + "unknown key `frequensy` in [mill]");
  over("\"contact.restitution\" = { from = 0.5, to = 1.2 }");
  expect_refused("optimise over.toml --out out",
                 "\"contact.restitution\" to = 1.2 is out of range");
  over("\"mill.frequency\" = { from = \"8 Hz\", to = \"16 mm\" }");
  expect_refused("optimise over.toml --out out", place(3) + "\"mill.frequency\" from \"8 Hz\"");
}

TEST_F(Search, what_a_search_found_is_its_own_in_the_case_it_leaves) {
  ASSERT_EQ(mahlwerk("optimise fast.toml --out out --quiet").code, 0);
  const std::string best = text("out/best.toml");
  EXPECT_EQ(best.find("--set"), std::string::npos) << best;
  EXPECT_NE(best.find("found by optimise"), std::string::npos) << best;
}

}  // namespace
}  // namespace mahlwerk::tests::search_test

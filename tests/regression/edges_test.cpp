// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Messages for edge cases: absurd and unusual values, ignored keys, results that depend on the TC
// rule.
#include "program.hpp"

namespace mahlwerk::tests::edges_test {
namespace {

constexpr const char* vial = R"(title = "vial"
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "10 mm"
[jar]
kind = "cylinder"
diameter = "24 mm"
height = "40 mm"
[[balls]]
count = 2
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.3
[run]
engine = "event"
time = "0.05 s"
replicates = 1
)";

class Edges : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::ofstream(here_ / "case.toml") << vial;
  }
  void in_mill(const std::string& lines) {
    std::string other = vial;
    const auto mill = other.find("[mill]"), jar = other.find("[jar]");
    other.replace(mill, jar - mill, "[mill]\n" + lines);
    std::ofstream(here_ / "case.toml") << other;
  }
  /// Runs the case with these settings, separated by semicolons.
  ProgramResult with(const std::string& settings) {
    std::string words = "run case.toml --force --out out";
    std::stringstream all(settings);
    for (std::string one; std::getline(all, one, ';');) words += " --set '" + one + "'";
    return mahlwerk(words);
  }
  void refuses(const std::string& settings, const std::string& code, const std::string& words) {
    const ProgramResult e = with(settings);
    EXPECT_EQ(e.code, 2) << e.output;
    EXPECT_NE(e.output.find("#" + code), std::string::npos) << e.output;
    EXPECT_NE(e.output.find(words), std::string::npos) << e.output;
  }
  void tells(const std::string& settings, const std::string& code) {
    const ProgramResult e = with(settings);
    EXPECT_EQ(e.code, 0) << e.output;
    EXPECT_NE(text("out/summary.json").find("\"" + code + "\""), std::string::npos) << e.output;
  }
};

TEST_F(Edges, absurd_values_are_refused) {
  refuses("run.start_speed=1e9 m/s", "out-of-range", "start_speed");
  refuses("run.time=1e12 s", "out-of-range", "time");
  refuses("mill.frequency=100 kHz", "absurd-speed", "more than 1000 m/s");
}

TEST_F(Edges, unusual_values_get_a_word) {
  tells("balls.density=7.85 kg/m3", "unusual-value");
  in_mill("kind = \"planetary\"\nspeed = \"300 rpm\"\norbit_radius = \"70 mm\"\nratio = 2\n");
  tells("run.time=0.01 s", "unusual-ratio");
}

TEST_F(Edges, a_maker_s_range_is_told_beside_a_kind) {
  in_mill(
      "model = \"retsch-mm400\"\nkind = \"arc-shaker\"\nfrequency = \"25 Hz\"\n"
      "arm = \"136 mm\"\nswing = \"3.8 deg\"\n");
  tells("run.time=0.01 s;mill.frequency=50 Hz", "beyond-mill-range");
  with("run.time=0.01 s");
  EXPECT_EQ(text("out/summary.json").find("beyond-mill-range"), std::string::npos);
  refuses("mill.model=retsch-mm400;mill.kind=planetary", "model-and-kind", "not \"planetary\"");
}

TEST_F(Edges, keys_that_the_engine_ignores_are_told) {
  tells("run.time_step=1 us", "ignored-keys");
  EXPECT_NE(text("out/summary.json").find("run.time_step"), std::string::npos);
  with("run.time=0.01 s");
  EXPECT_EQ(text("out/summary.json").find("ignored-keys"), std::string::npos) << "nothing to tell";
}

TEST_F(Edges, two_balls_that_just_fit_are_refused_by_the_event_engine_and_taken_by_the_soft_one) {
  refuses("balls.diameter=12 mm", "exact-fit", "fit exactly across the jar");
  const ProgramResult e = with(
      "balls.diameter=12 mm;run.engine=auto;contact.softening=0.01;"
      "run.time=0.01 s");
  EXPECT_EQ(e.code, 0) << e.output;
  EXPECT_NE(e.output.find("Engine: soft, chosen by auto. Two balls fit exactly"), std::string::npos)
      << e.output;
}

TEST_F(Edges, a_result_that_depends_on_the_contact_time_says_by_how_much) {
  // Sixty balls shaken at 800 g: a t_c of 0.5 ms, some 140 times the default, and one near the
  // default.
  const std::string fast =
      "mill.frequency=100 Hz;mill.amplitude=20 mm;balls.count=60;balls.diameter=3 mm;"
      "jar.diameter=14 mm;jar.height=24 mm;contact.restitution=0.8;contact.friction=0.1;"
      "run.time=0.3 s;contact.contact_time=";
  tells(fast + "0.5 ms", "contact-time");
  EXPECT_NE(text("out/summary.json").find("\"invalid\""), std::string::npos)
      << text("out/summary.json").substr(0, 2000);
  // Near the default the rule withholds little power. Half of the hits still share their impact
  // with another, and a warning says what that changes.
  tells(fast + "3.5 us", "simultaneous-hits");
  const std::string summary = text("out/summary.json");
  EXPECT_EQ(summary.find("\"invalid\""), std::string::npos) << summary.substr(0, 3000);
  const std::string share = "\"withheld_power_share\": {\n    \"value\": ";
  const auto at = summary.find(share);
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(std::stod(summary.substr(at + share.size())), 0.02) << "withheld_share_limit";
}

TEST_F(Edges, an_unknown_command_is_named_and_the_likely_one_too) {
  const ProgramResult simulate = mahlwerk("simulate case.toml");
  EXPECT_EQ(simulate.code, 2);
  EXPECT_NE(simulate.output.find("unknown command 'simulate'"), std::string::npos)
      << simulate.output;
  EXPECT_NE(simulate.output.find("did you mean 'mahlwerk run'?"), std::string::npos);
  EXPECT_NE(mahlwerk("optimize case.toml").output.find("mahlwerk optimise"), std::string::npos);
}

TEST_F(Edges, check_of_a_long_run_names_what_makes_it_cheaper_with_its_time) {
  const std::string set = "check case.toml --set run.engine=soft --set run.replicates=5 ";
  const ProgramResult longer = mahlwerk(set + "--set 'run.time=50000 s'");
  EXPECT_EQ(longer.code, 0) << longer.output;
  for (const char* part : {"The run takes about", "contact.softening = 0.1",
                           "impacts last 2.5 times", "run.replicates = 3", "run.replicates = 1"})
    EXPECT_NE(longer.output.find(part), std::string::npos) << part << "\n" << longer.output;
  const ProgramResult shorter = mahlwerk(set + "--set 'run.time=0.05 s'");
  EXPECT_EQ(shorter.output.find("The run takes about"), std::string::npos) << shorter.output;
}

/// A run of many replicates forgets their maps and spectra, 0.26 MB each; a sweep keeps them.
TEST_F(Edges, check_of_a_sweep_states_the_memory_of_whole_replicates) {
  const auto memory = [&](const std::string& sweep) {
    std::ofstream(here_ / "case.toml") << vial << sweep;
    const std::string told = mahlwerk("check case.toml --json --set run.replicates=60").output;
    const std::size_t at = told.find("\"value\": ", told.find("\"memory\""));
    return at == std::string::npos ? -1 : std::strtod(told.c_str() + at + 9, nullptr);
  };
  const double run = memory(""), sweep = memory("[sweep]\n\"mill.frequency\" = [\"10 Hz\"]\n");
  EXPECT_GT(run, 0);
  EXPECT_GT(sweep, run + 10) << "MB";
}

TEST_F(Edges, table_begins_with_key_numbers_and_says_what_assumed_values_decide) {
  std::string assumed = vial;
  assumed.erase(assumed.find("restitution = 0.5\n"), std::string("restitution = 0.5\n").size());
  std::ofstream(here_ / "case.toml") << assumed << "[powder]\nmass = \"1 g\"\n";
  const ProgramResult e = with("run.replicates=5");
  EXPECT_EQ(e.code, 0) << e.output;
  const std::size_t key = e.output.find("key numbers"), all = e.output.find("all collisions");
  EXPECT_LT(key, e.output.find("dissipated power"));
  EXPECT_LT(key, all);
  for (const char* part : {"specific energy dose per hour", "no milling time given",
                           "contact.restitution  0.3 to 0.9, assumed 0.8"})
    EXPECT_LT(e.output.find(part), all) << part << "\n" << e.output;
  EXPECT_NE(text("out/summary.json").find("_sensitivity"), std::string::npos);
  with("run.replicates=5;run.sensitivity=off");
  EXPECT_EQ(text("out/summary.json").find("_sensitivity"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::tests::edges_test

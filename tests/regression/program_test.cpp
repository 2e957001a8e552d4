// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command line program: its output files, and its messages for faulty input.
#include "program.hpp"

namespace mahlwerk::tests::program_test {
namespace {

namespace fs = std::filesystem;

class Program : public ProgramTest {
 protected:
  std::string example_ = example("01-one-ball");
  std::string short_ = example_ + " --set run.time=\"0.5 s\" --out out ";
};

TEST_F(Program, run_leaves_every_file_and_a_table) {
  const ProgramResult e = mahlwerk("run " + short_ + "--set observe.collisions=true");
  EXPECT_EQ(e.code, 0) << e.output;
  EXPECT_NE(e.output.find("collision rate"), std::string::npos) << e.output;
  for (const char* file :
       {"summary.json", "case.resolved.toml", "collisions.h5", "spectrum.csv", "speeds.csv",
        "angles.csv", "timeseries.csv", "replicates.csv", "report.html"})
    EXPECT_TRUE(fs::exists(here_ / "out" / file)) << file;
  EXPECT_EQ(std::distance(fs::directory_iterator(here_), {}), 1) << "nothing beside the result";
}

TEST_F(Program, resolved_case_gives_the_same_result_on_any_number_of_threads) {
  EXPECT_EQ(mahlwerk("run " + short_ + "--threads 1 --quiet").code, 0);
  EXPECT_EQ(mahlwerk("run out/case.resolved.toml --out again --threads 3 --quiet").code, 0);
  EXPECT_EQ(text("out/timeseries.csv"), text("again/timeseries.csv"));
  EXPECT_EQ(text("out/spectrum.csv"), text("again/spectrum.csv"));
}

TEST_F(Program, keeping_every_record_changes_no_trajectory) {
  EXPECT_EQ(mahlwerk("run " + short_ + "--quiet").code, 0);
  EXPECT_EQ(mahlwerk("run " + example_ +
                     " --set run.time=\"0.5 s\" --out kept --quiet "
                     "--set observe.collisions=true")
                .code,
            0);
  EXPECT_EQ(text("out/replicates.csv"), text("kept/replicates.csv"));
}

TEST_F(Program, check_shows_the_rule_of_each_pair) {
  const fs::path example = fs::path(MAHLWERK_HOME) / "examples/01-one-ball/case.toml";
  fs::copy_file(example, here_ / "case.toml");
  std::ofstream(here_ / "case.toml", std::ios::app)
      << "\n[[contact.pairs]]\nbetween = [\"balls\", \"jar\"]\nrestitution = 0.123\n";
  const ProgramResult e = mahlwerk("check case.toml");
  EXPECT_EQ(e.code, 0) << e.output;
  for (const char* line : {"balls.1 on jar.wall", "restitution 0.123, tangential 0.9"})
    EXPECT_NE(e.output.find(line), std::string::npos) << e.output;
}

TEST_F(Program, describe_shows_the_keys_of_sections_kinds_and_single_keys) {
  const auto shows = [&](const std::string& what, std::initializer_list<const char*> parts) {
    const ProgramResult e = mahlwerk("describe " + what);
    EXPECT_EQ(e.code, 0) << e.output;
    for (const char* part : parts)
      EXPECT_NE(e.output.find(part), std::string::npos) << part << '\n' << e.output;
  };
  shows("mill", {"[mill]", "jars_carried", "planetary", "mahlwerk describe KIND"});
  shows("planetary", {"orbit_radius", "required", "mahlwerk describe mill"});
  shows("mill.speed", {"planetary", "tumbling", "critical speed"});
  shows("mill.planetary", {"orbit_radius"});
  shows("fritsch-p7-classic", {"mills/fritsch-p7-classic"});
  shows("materials/steel-304", {"density"});
  shows("planetary --json", {"\"key\": \"orbit_radius\"", "\"least_excluded\": true"});
  shows("top", {"title", "gravity"});
  const ProgramResult all = mahlwerk("list keys --json");
  EXPECT_EQ(all.code, 0);
  EXPECT_NE(all.output.find("\"section\": \"optimise\""), std::string::npos);
}

TEST_F(Program, describe_shows_both_if_a_kind_and_an_entry_have_the_same_name) {
  fs::create_directories(here_ / "own" / "materials");
  std::ofstream(here_ / "own/materials/sphere.toml")
      << "title = \"A material called sphere\"\nabout = \"For a test.\"\n"
         "[density]\nvalue = \"1 kg/m3\"\nsource = \"a test\"\n";
  const auto described = [&](const std::string& what) {
    return mahlwerk("--version >/dev/null; MAHLWERK_CATALOGUE=own '" MAHLWERK_PROGRAM
                    "' describe " +
                    what)
        .output;
  };
  const std::string both = described("sphere");
  EXPECT_NE(both.find("[jar] kind = \"sphere\""), std::string::npos) << both;
  EXPECT_NE(both.find("materials/sphere"), std::string::npos) << both;
  EXPECT_EQ(described("jar.sphere").find("a test"), std::string::npos);
  const std::string entry = described("materials/sphere");
  EXPECT_TRUE(entry.starts_with("A material called sphere")) << entry;
}

TEST_F(Program, an_existing_result_is_refused_unless_forced) {
  EXPECT_EQ(mahlwerk("run " + short_ + "--quiet").code, 0);
  const std::string before = text("out/summary.json");
  const ProgramResult e = mahlwerk("run " + short_ + "--seed 7");
  EXPECT_EQ(e.code, 2);
  EXPECT_NE(e.output.find("--force"), std::string::npos) << e.output;
  EXPECT_EQ(text("out/summary.json"), before);
  EXPECT_EQ(mahlwerk("run " + short_ + "--seed 7 --force --quiet").code, 0);
  EXPECT_NE(text("out/summary.json"), before);
}

TEST_F(Program, report_gives_a_page_the_form_of_this_version) {
  EXPECT_EQ(mahlwerk("run " + short_ + "--quiet").code, 0);
  const std::string whole = text("out/report.html");
  std::string old = whole;
  const std::size_t style = old.find("<style>") + 7;
  old.replace(style, old.find("</style>") - style, "b{}");
  std::ofstream(here_ / "out/report.html") << old;
  EXPECT_EQ(mahlwerk("report out").code, 0);
  EXPECT_EQ(text("out/report.html"), whole);
  std::ofstream(here_ / "out/report.html") << "cut";
  const ProgramResult damaged = mahlwerk("report out");
  EXPECT_EQ(damaged.code, 2);
  EXPECT_NE(damaged.output.find("damaged"), std::string::npos) << damaged.output;
  EXPECT_EQ(text("out/report.html"), "cut") << "nothing is written over it";
  EXPECT_EQ(mahlwerk("report nowhere").code, 2);
}

TEST_F(Program, nonsense_is_refused_with_place_and_remedy) {
  expect_refused("run " + short_ + "--set balls.diameter=\"20 mm\"", "not smaller than");
  expect_refused("run " + short_ + "--set balls.diameter=\"0 mm\"", "balls.diameter");
  expect_refused("run " + short_ + "--set jar.diameter=\"-12 mm\"", "jar.diameter");
  expect_refused("run " + short_ + "--set contact.restitution=1.5", "contact.restitution");
  expect_refused("run " + short_ + "--set contact.tangential_restitution=-2",
                 "tangential_restitution");
  expect_refused("run " + short_ + "--set mill.amplitude=nan", "amplitude");
  expect_refused("run " + short_ + "--set mill.frequency=10", "10 Hz");
  expect_refused("run " + short_ + "--set mill.freqency=\"10 Hz\"", "frequency");
  expect_refused("run " + short_ + "--set nonsense", "key=value");
  expect_refused("run missing.toml --out out", "no such file");
  expect_refused("run " + short_ +
                     "--set run.engine=soft --set contact.restitution_law=viscoelastic "
                     "--set 'contact.restitution_speed=1 m/s'",
                 "soft engine");
  expect_refused("describe fritsch-p7-clasic", "fritsch-p7-classic");
  expect_refused("describe plantary", "planetary");
  expect_refused("describe mill.spede", "mill.speed");
  expect_refused("fly", "");
}

TEST_F(Program, places_that_cannot_be_written_are_refused_before_anything_runs) {
  const std::string long_run = example_ + " --set run.time=\"1000000 s\" ";
  expect_refused("run " + long_run + "--out /proc/out", "/proc/out");
  std::ofstream(here_ / "file") << "mine";
  expect_refused("run " + long_run + "--out file", "file");
  EXPECT_EQ(text("file"), "mine");
  fs::create_directories(here_ / "folder");
  std::ofstream(here_ / "folder" / "precious.txt") << "mine";
  expect_refused("run " + long_run + "--out folder --force", "folder");
  EXPECT_EQ(text("folder/precious.txt"), "mine");
}

TEST_F(Program, ctrl_c_keeps_what_was_computed_and_says_so) {
  const ProgramResult e = mahlwerk("run " + example_ +
                                   " --set run.time=\"1000000 s\" --out out & "
                                   "sleep 1; kill -INT $!; wait $!");
  EXPECT_EQ(e.code, 130) << e.output;
  EXPECT_NE(e.output.find("interrupted"), std::string::npos) << e.output;
  EXPECT_NE(text("out/summary.json").find("\"complete\": false"), std::string::npos);
}

TEST_F(Program, inelastic_collapse_without_a_remedy_ends_with_an_explanation) {
  const ProgramResult e = mahlwerk("run " + example_ +
                                   " --set contact.lasting=none --set contact.restitution=0.5 "
                                   "--out out");
  EXPECT_EQ(e.code, 3) << e.output;
  EXPECT_NE(e.output.find("lasting = \"none\". Leave it out"), std::string::npos) << e.output;
  EXPECT_TRUE(fs::exists(here_ / "out" / "summary.json")) << "what was computed is kept";
}

TEST_F(Program, check_says_what_follows) {
  const ProgramResult e = mahlwerk("check " + example_);
  EXPECT_EQ(e.code, 0);
  for (const char* name :
       {"peak_wall_speed", "acceleration_number", "expected_impact_energy", "run_time"})
    EXPECT_NE(e.output.find(name), std::string::npos) << e.output;
}

TEST_F(Program, completion_offers_every_option_of_every_command_and_no_other) {
  const auto offered = [&](const std::string& command) {  // completions after these words
    std::ofstream(here_ / "ask") << "source <('" MAHLWERK_PROGRAM "' completion bash)\n"
                                 << "COMP_WORDS=(mahlwerk " << command << ")\n"
                                 << "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                                 << "_mahlwerk\nprintf '%s\\n' \"${COMPREPLY[@]}\" | sort\n";
    return mahlwerk("--version >/dev/null; bash ask").output;
  };
  const auto helped = [&](const std::string& command) {  // options that its --help lists
    return mahlwerk(command +
                    " --help | grep -oE '(^ *|,)(-[a-z],)?--[a-z-]+' | grep -oE "
                    "'\\-\\-[a-z-]+' | sort -u")
        .output;
  };
  for (const char* command : {"run", "sweep", "sweep status", "sweep export", "sweep retry",
                              "sweep merge", "compare", "fit", "optimise", "match", "papers",
                              "check", "new", "list", "describe", "completion", "manual"}) {
    EXPECT_EQ(offered(command + std::string(" --")), helped(command)) << command;
    EXPECT_NE(helped(command), "") << command;
  }
  EXPECT_EQ(offered("sw"), "sweep\n");
  EXPECT_EQ(offered("sweep st"), "status\n");
  EXPECT_EQ(offered("stat"), "\n") << "a part of a command is none";
  EXPECT_EQ(offered("list mi"), "mills\n");
  EXPECT_EQ(offered("describe tav"), "tavares\n");
  EXPECT_EQ(offered("new --kind plan"), "planetary\n");
  EXPECT_EQ(offered("new --mill x --jar-kind lif"), "lifter-cylinder\n");
  EXPECT_EQ(offered("run case.toml --set mill.speed_r"), "mill.speed_repeats=\n");
  std::ofstream(here_ / "mine.toml") << "";
  EXPECT_EQ(offered("run mi"), "mine.toml\n");
}

}  // namespace
}  // namespace mahlwerk::tests::program_test

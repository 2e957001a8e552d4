// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Output of the program: texts and their streams, and what remains after a fault of its files or
// its terminal, or a conflict with a second process.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "mahlwerk/results/files/hdf5.hpp"
#include "program.hpp"

namespace mahlwerk::tests::output_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Output : public ProgramTest {
 protected:
  std::string ball_ = example("01-one-ball") + " --set run.replicates=1 ";
  std::string short_ = "run " + ball_ + "--set run.time=\"0.1 s\" --out out ";
  std::string long_ = "run " + ball_ + "--set run.time=\"1000000 s\" --out out ";

  /// Runs a shell script with the program as $M and both output streams merged.
  ProgramResult script(const std::string& text) const {
    const std::string command = "cd '" + here_.string() + "' && M='" +
                                std::string(MAHLWERK_PROGRAM) + "' && { " + text + "; } 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string said;
    char part[4096];
    while (const std::size_t n = fread(part, 1, sizeof part, pipe)) said.append(part, n);
    return {WEXITSTATUS(pclose(pipe)), said};
  }
  /// The JSON object with which the program reports its end.
  static json last_line(const std::string& said) {
    const std::size_t begin = said.rfind("{\"ended\"");
    if (begin == std::string::npos) return said;
    return json::parse(said.substr(begin, said.find('\n', begin) - begin));
  }
  static void expect_lost(const ProgramResult& e, const std::string& why) {
    EXPECT_EQ(e.code, 4) << e.output;
    EXPECT_NE(e.output.find("standard output cannot be written: " + why), std::string::npos)
        << e.output;
    EXPECT_EQ(e.output.find("internal"), std::string::npos) << e.output;
  }
};

TEST_F(Output, that_is_lost_is_an_error_with_a_code_of_its_own) {
  for (const std::string command :
       {"list", "list --json", "describe fritsch-p7-classic", "completion bash", "--help"}) {
    expect_lost(mahlwerk(command + " > /dev/full"), "No space left on device");
    expect_lost(mahlwerk(command + " >&-"), "Bad file descriptor");
  }
}

TEST_F(Output, for_a_reader_that_has_gone_is_lost) {
  script(
      "{ while [ ! -e gone ]; do sleep 0.01; done; \"$M\" list 2> said; echo $? > code; } | "
      "{ exec 0<&-; touch gone; }");
  expect_lost({std::stoi("0" + text("code")), text("said")}, "Broken pipe");
}

TEST_F(Output, that_is_lost_leaves_whole_results) {
  expect_lost(mahlwerk(short_ + "> /dev/full"), "No space left on device");
  EXPECT_TRUE(exists("out/summary.json"));
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(Output, errors_under_json_are_json) {
  const ProgramResult ball = mahlwerk("check " + ball_ + " --json --set balls.diameter=\"20 mm\"");
  EXPECT_EQ(ball.code, 2);
  const json said = last_line(ball.output);
  EXPECT_EQ(said.at("ended"), "bad-input");
  EXPECT_EQ(said.at("exit"), 2);
  const json& fault = said.at("faults").at(0);
  EXPECT_EQ(fault.at("code"), "ball-too-large");
  EXPECT_EQ(fault.at("where"), "--set balls.diameter");
  for (const char* name : {"what", "remedy"})
    EXPECT_GT(fault.at(name).get<std::string>().size(), 10U) << name;
  EXPECT_EQ(last_line(mahlwerk("check --bogus --json").output).at("faults").at(0).at("code"),
            "bad-command-line");
  EXPECT_EQ(last_line(mahlwerk("list --json 2>&1 > /dev/full").output).at("ended"), "output-lost");
  const ProgramResult stopped = mahlwerk(short_ +
                                         "--json --set contact.lasting=none --set "
                                         "contact.restitution=0.5 --set run.time=\"5 s\" "
                                         "2>&1 > /dev/null");
  EXPECT_EQ(stopped.code, 3);
  EXPECT_EQ(last_line(stopped.output).at("ended"), "stopped");
}

TEST_F(Output, names_that_are_no_utf8_are_shown_with_marks_in_json) {
  const ProgramResult e = script("\"$M\" run " + ball_ +
                                 " --json --set run.time=\"1 ms\" --out \"$(printf "
                                 "'x\\377')\" 2> /dev/null");
  EXPECT_EQ(e.code, 0) << e.output;
  EXPECT_EQ(json::parse(e.output).at(0).at("results"), "x\uFFFD");
}

TEST_F(Output, a_signal_of_any_kind_keeps_what_was_computed) {
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) {
    const ProgramResult e =
        mahlwerk_until("out.checkpoint", signal, long_ + "--json --checkpoint 0.01");
    EXPECT_EQ(e.code, 130) << e.output;
    EXPECT_EQ(last_line(e.output).at("ended"), "interrupted");
    EXPECT_NE(text("out/summary.json").find("\"complete\": false"), std::string::npos);
    EXPECT_FALSE(exists(".out.lock"));
    fs::remove_all(here_ / "out");
    fs::remove(here_ / "out.checkpoint");
  }
}

TEST_F(Output, long_work_tells_where_it_is_without_a_terminal) {
  const auto told = [&](const std::string& more) {
    return mahlwerk("run " + ball_ + more +
                    "--set run.time=\"2000 s\" --force --out out 2>&1 > "
                    "/dev/null")
        .output;
  };
  ::setenv("MAHLWERK_PROGRESS_EVERY", "3600", 1);
  EXPECT_EQ(told(""), "") << "not before the interval has passed";
  ::setenv("MAHLWERK_PROGRESS_EVERY", "0", 1);
  const std::string lines = told("");
  EXPECT_NE(lines.find("s simulated"), std::string::npos) << lines;
  EXPECT_NE(lines.find("s left"), std::string::npos) << lines;
  EXPECT_EQ(lines.find('\r'), std::string::npos) << "no line over another";
  EXPECT_EQ(told("--quiet "), "");
  ::unsetenv("MAHLWERK_PROGRESS_EVERY");
}

TEST_F(Output, a_checkpoint_that_cannot_be_written_is_told_at_once_and_again) {
  fs::create_directories(here_ / "out.checkpoint" / "in the way");
  const ProgramResult e =
      script("\"$M\" " + long_ +
             "--checkpoint 0.05 --quiet > told 2>&1 & while ! grep -q "
             "cannot told; do sleep 0.02; done; kill -INT $!; wait $!; code=$?; cat "
             "told; exit $code");
  EXPECT_EQ(e.code, 130) << e.output;
  const std::string words = "the checkpoint cannot be written";
  const std::size_t first = e.output.find(words), end = e.output.find("interrupted");
  EXPECT_LT(first, end) << e.output;
  EXPECT_NE(e.output.find(words, end), std::string::npos) << e.output;
  EXPECT_TRUE(exists("out/summary.json"));
}

TEST_F(Output, two_runs_into_one_place_are_refused_before_they_compute) {
  const ProgramResult e = script("\"$M\" " + long_ +
                                 "--quiet --checkpoint 0.01 & while [ ! -e "
                                 "out.checkpoint ]; do sleep 0.02; done; \"$M\" " +
                                 long_ + "; echo code $?; kill -INT $!; wait $!");
  EXPECT_NE(e.output.find("another process is at work"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("code 2"), std::string::npos) << e.output;
  EXPECT_EQ(e.code, 130) << e.output;
  EXPECT_TRUE(exists("out/summary.json"));
}

TEST_F(Output, what_a_killed_run_left_is_cleaned_by_the_next) {
  mahlwerk_until("out.checkpoint", SIGKILL, long_ + "--checkpoint 0.05 --quiet");
  fs::remove(here_ / "said");
  std::ofstream(here_ / "out.checkpoint.part") << "half";
  ASSERT_TRUE(exists(".out.lock"));
  EXPECT_EQ(mahlwerk(short_ + "--quiet --checkpoint 60").code, 0);
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(here_))
    left.push_back(entry.path().filename().string());
  EXPECT_EQ(left, std::vector<std::string>{"out"});
}

TEST_F(Output, what_a_case_says_moves_no_cursor) {
  const ProgramResult e = mahlwerk("run " + ball_ +
                                   "--set run.time=\"0.1 s\" --set "
                                   "\"title=$(printf 'a\\033[31mb')\" --out out");
  EXPECT_EQ(e.code, 0) << e.output;
  EXPECT_EQ(e.output.find('\x1b'), std::string::npos);
  EXPECT_NE(e.output.find("a\\u001b[31mb"), std::string::npos) << e.output;
  EXPECT_EQ(text("out/report.html").find('\x1b'), std::string::npos);
}

TEST_F(Output, options_for_slurm_are_a_line_each) {
  std::ofstream(here_ / "case.toml")
      << "title = \"x\"\n[mill]\nkind = \"vibration\"\nfrequency = \"10 Hz\"\namplitude = \"25 "
         "mm\"\n[jar]\nkind = \"capsule\"\ndiameter = \"12 mm\"\nvolume = \"5 ml\"\n[[balls]]\n"
         "count = 1\ndiameter = \"8 mm\"\ndensity = \"7850 kg/m3\"\n[contact]\nrestitution = "
         "0.9\n[run]\ntime = \"1 s\"\n[sweep]\n\"mill.frequency\" = [\"10 Hz\", \"12 Hz\"]\n";
  expect_refused("sweep case.toml --out out --slurm 2 --slurm-option \"$(printf 'a\\nrm x')\"",
                 "a line end");
}

TEST_F(Output, collisions_are_in_the_order_in_which_they_end) {
  for (const std::string engine : {"event", "soft"}) {
    ASSERT_EQ(mahlwerk("run " + example("05-planetary-soft") +
                       " --quiet --set run.time=\"50 ms\" --set run.settle=\"5 ms\" --set "
                       "run.replicates=1 --set observe.collisions=true --set run.engine=" +
                       engine + " --out " + engine)
                  .code,
              0);
    const auto hits = results::read_collisions(here_ / engine / "collisions.h5", 0);
    ASSERT_GT(hits.size(), 100U);
    double last = 0;
    int begin_later = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const double end = hits[i].time + hits[i].duration;
      EXPECT_GE(end, last * (1 - 2 * std::numeric_limits<double>::epsilon())) << i;
      last = end;
      begin_later += i > 0 && hits[i].time < hits[i - 1].time ? 1 : 0;
    }
    EXPECT_GT(begin_later, 0) << engine << ": contacts of both engines last, and overlap in time";
  }
}

}  // namespace
}  // namespace mahlwerk::tests::output_test

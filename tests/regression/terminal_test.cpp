// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The program on a terminal (a pseudo-terminal of 60 columns), and its help.
#include <pty.h>

#include "program.hpp"

namespace mahlwerk::tests::terminal_test {
namespace {

class OnTerminal : public ProgramTest {
 protected:
  /// What the program shows on a terminal; `environment` as words of `env`.
  std::string shown(const std::string& words, const std::string& environment = "") const {
    int terminal = -1;
    winsize size{.ws_row = 24, .ws_col = 60, .ws_xpixel = 0, .ws_ypixel = 0};
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    const std::string command = "cd '" + here_.string() +
                                "' && exec env -u NO_COLOR -u COLUMNS TERM=xterm " + environment +
                                " '" + MAHLWERK_PROGRAM + "' " + words;
    if (child == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    std::string said;
    char part[4096];
    for (ssize_t n; (n = read(terminal, part, sizeof part)) > 0;)
      said.append(part, static_cast<std::size_t>(n));
    close(terminal);
    waitpid(child, nullptr, 0);
    return said;
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(OnTerminal, faults_have_colours_and_links_that_open) {
  const std::string fault = shown("rnu");
  EXPECT_TRUE(contains(fault, "\033[1;31mmahlwerk:\033[0m unknown command 'rnu'")) << fault;
  EXPECT_TRUE(contains(fault, "\033]8;;file://" MAHLWERK_HOME "/docs/errors.md#bad-command-line"))
      << fault;
}

TEST_F(OnTerminal, colours_can_be_switched_off_and_on) {
  for (const auto& [words, environment] :
       {std::pair{"rnu --color never", ""}, std::pair{"--color=never rnu", ""},
        std::pair{"rnu", "NO_COLOR=1"}, std::pair{"rnu", "TERM=dumb"}})
    EXPECT_FALSE(contains(shown(words, environment), "\033")) << words << environment;
  EXPECT_TRUE(contains(shown("--color always rnu", "NO_COLOR=1"), "\033[1;31m"));
  EXPECT_TRUE(contains(mahlwerk("list mills --color always").output, "\033[1mmills\033[0m"));
  expect_refused("list --color=blue", "'blue' is not auto, always or never");
}

TEST_F(OnTerminal, tables_fit_its_width) {
  const auto longest_line = [&](const std::string& words, const std::string& environment) {
    std::stringstream lines(shown(words, "NO_COLOR=1 " + environment));
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);)
      if (!contains(line, "/docs/")) longest = std::max(longest, line.find('\r'));
    return longest;
  };
  for (const char* words : {"list quantities power", "describe planetary", "help run"}) {
    EXPECT_LE(longest_line(words, ""), 60U) << words;
    EXPECT_GT(longest_line(words, "COLUMNS=75"), 60U) << words;
    EXPECT_LE(longest_line(words, "COLUMNS=75"), 75U) << words;
  }
}

TEST_F(OnTerminal, a_run_links_its_files_and_ends_its_line_of_progress) {
  const std::string run =
      shown("run " + example("01-one-ball") + " --set run.time=\"0.5 s\" --out out");
  EXPECT_TRUE(contains(run, "\033]8;;file://" + here_.string() + "/out/report.html\033\\")) << run;
  EXPECT_TRUE(contains(run, "\r\033[K\033[1mOne ball in a vertically vibrating vial\033[0m"))
      << run;
}

TEST_F(OnTerminal, a_bare_call_shows_five_commands_and_where_to_read_on) {
  const ProgramResult bare = mahlwerk("");
  EXPECT_EQ(bare.code, 0);
  for (const char* part : {"Start with:  mahlwerk run ", "  estimate  ", "  new ", "  check ",
                           "  run ", "  sweep ", "mahlwerk help", "docs/tutorial/index.md"})
    EXPECT_TRUE(contains(bare.output, part)) << part << '\n' << bare.output;
  EXPECT_FALSE(contains(bare.output, "surrogate"));
}

TEST_F(OnTerminal, help_is_that_of_the_option) {
  EXPECT_EQ(mahlwerk("help").output, mahlwerk("--help").output);
  EXPECT_EQ(mahlwerk("help sweep status").output, mahlwerk("sweep status --help").output);
  EXPECT_TRUE(contains(mahlwerk("help sweep status").output, "FOLDER"));
  EXPECT_EQ(mahlwerk("-V").output, mahlwerk("--version").output);
  expect_refused("help rnu", "did you mean 'mahlwerk run'?");
}

TEST_F(OnTerminal, misspelt_words_get_the_nearest) {
  expect_refused("run x --jsob", "unknown option '--jsob'\n    remedy: did you mean '--json'?");
  expect_refused("sweep x --results al", "did you mean 'all'?");
  expect_refused("--quiet run x", "write it behind: mahlwerk run ... --quiet");
  expect_refused("list mils", "did you mean 'mills'?");
}

TEST_F(OnTerminal, lists_can_be_searched) {
  const std::string power = mahlwerk("list quantities POWER").output;
  EXPECT_TRUE(contains(power, "dissipated_power ")) << power;
  EXPECT_TRUE(contains(power, "power dissipated in collisions")) << "the sentence: " << power;
  EXPECT_FALSE(contains(power, "impact_angle_mean"));
  EXPECT_TRUE(contains(mahlwerk("list keys \"mass of the powder\"").output, "powder.mass"));
  EXPECT_FALSE(contains(mahlwerk("list mills retsch").output, "fritsch"));
  EXPECT_TRUE(contains(mahlwerk("list mills tumbling").output, "bond-mill")) << "by their kind";
  EXPECT_TRUE(contains(mahlwerk("list materials ZrO2").output, "zirconia-ytzp")) << "other names";
  expect_refused("list quantities zzz", "nothing there has the word 'zzz'");
}

TEST_F(OnTerminal, a_key_can_be_taken_from_a_case) {
  const std::string case_of = "check " + example("02-mixer-mill");
  EXPECT_TRUE(contains(mahlwerk(case_of).output, "powder_mass"));
  const ProgramResult without = mahlwerk(case_of + " --unset powder");
  EXPECT_EQ(without.code, 0) << without.output;
  EXPECT_FALSE(contains(without.output, "powder_mass"));
  EXPECT_TRUE(
      contains(mahlwerk(case_of + " --unset contact.friction").output,
               "  contact.friction                       0.3            0.1 to 0.6; default"))
      << "its default is assumed";
  EXPECT_FALSE(
      contains(mahlwerk(case_of + " --unset contact.friction --set contact.friction=0.4").output,
               "  contact.friction "))
      << "--set counts after --unset";
  expect_refused(case_of + " --unset powder.masse", "did you mean powder.mass?");
}

}  // namespace
}  // namespace mahlwerk::tests::terminal_test

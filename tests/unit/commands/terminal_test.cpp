// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/terminal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/help/find_command.hpp"

namespace mahlwerk::commands::terminal_test {
namespace {

/// Colours as on a terminal, for one test.
class Terminal : public ::testing::Test {
 protected:
  void SetUp() override { set_color(ColorMode::always); }
  void TearDown() override { set_color(ColorMode::automatic); }
};

TEST(WrappedLine, a_line_that_fits_stays) {
  EXPECT_EQ(wrapped_line("  key   about it", 16), "  key   about it");
}

TEST(WrappedLine, the_last_cell_of_a_table_continues_below_itself) {
  EXPECT_EQ(wrapped_line("  key   what it is and does", 20),
            "  key   what it is\n        and does");
}

TEST(WrappedLine, a_last_cell_in_the_right_half_gets_lines_of_its_own) {
  EXPECT_EQ(wrapped_line("  a_long_name_of_it  m/s  what it is", 30),
            "  a_long_name_of_it  m/s\n      what it is");
}

TEST(WrappedLine, a_paragraph_keeps_its_margin_and_every_word) {
  const std::string text = "    one two \u00b1 four five six seven eight";
  std::stringstream lines(wrapped_line(text, 16));
  std::string words;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.starts_with("    ")) << line;
    EXPECT_LE(line.size(), 17U) << "16 characters, of which one has two bytes: " << line;
    words += (words.empty() ? "    " : " ") + line.substr(4);
  }
  EXPECT_EQ(words, text);
}

TEST(WrappedLine, a_word_longer_than_the_line_is_not_cut) {
  EXPECT_EQ(wrapped_line("/a/path/longer/than/this and more", 10),
            "/a/path/longer/than/this\nand more");
}

TEST(Page, without_terminal_nothing_changes) {  // the tests run without one
  const std::string page = "Heading\n  " + std::string(300, 'x') + " y\n\nWarning: z";
  EXPECT_EQ(page_for(Stream::output, page), page);
  EXPECT_EQ(faults_for(Stream::errors, Style::error, "a: b\n    more:   docs/errors.md#x\n"),
            "a: b\n    more:   docs/errors.md#x\n");
  EXPECT_EQ(styled(Style::heading, "x", Stream::output), "x");
  EXPECT_EQ(linked("x", "/x", Stream::output), "x");
}

TEST_F(Terminal, headings_stand_above_indented_lines_and_end_with_their_first_cell) {
  EXPECT_EQ(page_for(Stream::output, "text\nHeading  about\n  line\nWarning: w\n"),
            "text\n\033[1mHeading\033[0m  about\n  line\n\033[1;33mWarning:\033[0m w\n");
}

TEST_F(Terminal, a_fault_shows_its_place_and_a_document_that_exists) {
  const std::string name = "docs/errors.md#unknown-key", place = document(name);
  const std::string shown =
      faults_for(Stream::errors, Style::error, "case.toml:3: bad\n    more:   " + name + "\n");
  EXPECT_NE(shown.find("\033[1;31mcase.toml:3:\033[0m bad\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find(place), std::string::npos) << shown;
}

TEST_F(Terminal, a_link_is_an_address_without_blanks) {
  const std::string shown = linked("x", "/a b/c.md#d", Stream::output);
  EXPECT_EQ(shown, "\033]8;;file:///a%20b/c.md#d\033\\x\033]8;;\033\\");
}

std::string remedy_of(const std::vector<std::string>& words) {
  const std::vector<Command> all = all_commands();
  try {
    check_command_words(all, words);
    return "";
  } catch (const InputError& error) {
    return error.faults().front().remedy;
  }
}

TEST(CommandWords, the_nearest_command_is_suggested) {
  EXPECT_TRUE(remedy_of({"rnu"}).starts_with("did you mean 'mahlwerk run'?"));
  EXPECT_TRUE(remedy_of({"simulate", "x"}).starts_with("did you mean 'mahlwerk run'?"));
  EXPECT_TRUE(remedy_of({"sweep", "stauts"}).starts_with("did you mean 'mahlwerk sweep status'?"));
  EXPECT_EQ(remedy_of({"sweep", "status"}), "");
  EXPECT_EQ(remedy_of({"sweep", "my-case"}), "");
  EXPECT_EQ(remedy_of({"--help"}), "");
  EXPECT_EQ(remedy_of({"xyzzyx"}), "mahlwerk --help lists all commands");
}

TEST(CommandWords, the_nearest_option_is_suggested) {
  const std::vector<Command> all = all_commands();
  const Command& run = find_command(all, {"run"});
  EXPECT_EQ(nearest_option(run, "--jsob"), "--json");
  EXPECT_EQ(nearest_option(run, "--theads=3"), "--threads");
  EXPECT_EQ(nearest_option(run, "--colour"), "--color");
  EXPECT_EQ(nearest_option(run, "--qqqqqqqq"), "");
}

TEST(CommandWords, every_command_has_a_help_of_its_own_name) {
  const std::vector<Command> all = all_commands();
  for (const Command& command : all) {
    EXPECT_EQ(&find_command(all, {command.name}), &command);
    for (const Command& part : command.subcommands)
      EXPECT_EQ(&find_command(all, {command.name, part.name}), &part);
  }
}

}  // namespace
}  // namespace mahlwerk::commands::terminal_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/help/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/commands/help/about.hpp"
#include "mahlwerk/commands/help/find_command.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"

namespace mahlwerk::commands {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// A heading and two columns below it; empty without rows. A long first cell has a line of its own.
std::string section_text(std::string_view heading, const Rows& rows) {
  constexpr std::size_t widest = 24;
  if (rows.empty()) return "";
  std::size_t column = 0;
  for (const auto& [word, about] : rows)
    if (word.size() <= widest) column = std::max(column, word.size());
  std::string text = fmt::format("\n{}:\n", heading);
  for (const auto& [word, about] : rows)
    text += word.size() <= column ? fmt::format("  {:<{}}  {}\n", word, column, about)
                                  : fmt::format("  {}\n  {:<{}}  {}\n", word, "", column, about);
  return text;
}

Rows command_rows(const std::vector<Command>& list) {
  Rows rows;
  for (const Command& command : list) rows.emplace_back(command.name, command.about);
  return rows;
}

Rows general_rows() {
  Rows rows;
  for (const Explained& option : general_options())
    rows.emplace_back(std::string(option.word), std::string(option.meaning));
  return rows;
}

bool is_positional(const Option& option) {
  return !option.name.starts_with("-");
}

std::string usage(const std::string& path, const Command& command) {
  std::string text = fmt::format("Usage: mahlwerk {} [OPTION ...]", path);
  for (const Option& option : command.options)
    if (is_positional(option))
      text += option.required ? ' ' + option.name : fmt::format(" [{}]", option.name);
  if (!command.subcommands.empty()) text += fmt::format("\n       mahlwerk {} COMMAND ...", path);
  return text + '\n';
}

std::string exit_code_line() {
  std::string line;
  for (const Explained& code : exit_codes())
    line += fmt::format("{}{} {}", line.empty() ? "Exit codes: " : ", ", code.word, code.meaning);
  return line + ".\n";
}

std::string program_help(const std::vector<Command>& all) {
  return fmt::format(
      "{}\nStart with:  mahlwerk run {}\n\nUsage: mahlwerk COMMAND [OPTION ...] [CASE]\n"
      "       mahlwerk help COMMAND\n{}{}\n{}",
      purpose(), first_example(), section_text("Options", general_rows()),
      section_text("Commands", command_rows(all)), exit_code_line());
}

std::string command_help(const std::string& path, const Command& command) {
  Rows arguments, options;
  for (const Option& option : command.options) {
    const std::string value = value_name(option);
    if (is_positional(option))
      arguments.emplace_back(option.name, meaning_of(option));
    else
      options.emplace_back(option.name + (value.empty() ? "" : " " + value), meaning_of(option));
  }
  for (const auto& row : general_rows())
    if (!row.first.starts_with("-V")) options.push_back(row);
  return fmt::format("{}\n\n{}{}{}{}\n{}", command.about, usage(path, command),
                     section_text("Arguments", arguments), section_text("Options", options),
                     section_text("Commands", command_rows(command.subcommands)), exit_code_line());
}

}  // namespace

void print_short_help(const std::vector<Command>& all) {
  constexpr std::array<std::string_view, 5> most_used{"estimate", "new", "check", "run", "sweep"};
  Rows rows;
  for (const std::string_view name : most_used)
    rows.emplace_back(name, find_command(all, {std::string(name)}).about);
  to_stdout(
      fmt::format("{}\nStart with:  mahlwerk run {}\n{}\nAll commands:  mahlwerk help\n"
                  "One command:   mahlwerk help run\n",
                  purpose(), first_example(), section_text("Commands most used", rows)));
  places_to_stdout({{"Read on", document("docs/tutorial/index.md")}});
}

void print_help(const std::vector<Command>& all, const std::vector<std::string>& words) {
  to_stdout(words.empty()
                ? program_help(all)
                : command_help(fmt::format("{}", fmt::join(words, " ")), find_command(all, words)));
  places_to_stdout({{"Read on", document("docs/cli.md")}});
}

Command help_command() {
  const auto words = std::make_shared<std::vector<std::string>>();
  return {"help",
          "show all commands, or the arguments and options of a command",
          {{.name = "COMMAND",
            .target = words.get(),
            .about = "a command, or a command and its subcommand: sweep status",
            .completions = std::string(command_completions())}},
          [words] {
            print_help(all_commands(), *words);
            return static_cast<int>(success);
          }};
}

}  // namespace mahlwerk::commands

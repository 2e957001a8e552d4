// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/help/find_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/commands/help/about.hpp"

namespace mahlwerk::commands {
namespace {

/// Command names of other programs, and our command for each.
constexpr std::array<std::array<std::string_view, 2>, 11> synonyms{{{"simulate", "run"},
                                                                    {"start", "run"},
                                                                    {"solve", "run"},
                                                                    {"validate", "check"},
                                                                    {"info", "describe"},
                                                                    {"show", "describe"},
                                                                    {"calibrate", "fit"},
                                                                    {"campaign", "sweep"},
                                                                    {"init", "new"},
                                                                    {"create", "new"},
                                                                    {"template", "new"}}};

/// The name of a command in `level` that is meant by `word`; empty if none is near.
std::string meant_by(std::string_view word, const std::vector<Command>& level) {
  std::vector<std::string> known;
  for (const Command& command : level) known.push_back(command.name);
  for (const auto& [other, ours] : synonyms)
    if (word == other && std::ranges::find(known, ours) != known.end()) return std::string(ours);
  return nearest_word(word, known);
}

/// `before` are the words before, "sweep ", or empty.
InputError unknown_command(const std::string& before, const std::string& word,
                           const std::vector<Command>& level) {
  const std::string meant = meant_by(word, level);
  return InputError(
      Fault{"mahlwerk", fmt::format("unknown command '{}{}'", before, word),
            (meant.empty() ? "" : fmt::format("did you mean 'mahlwerk {}{}'? ", before, meant)) +
                fmt::format("mahlwerk {}--help lists {}commands", before,
                            before.empty() ? "all " : "its "),
            "bad-command-line"});
}

}  // namespace

const Command& find_command(const std::vector<Command>& all,
                            const std::vector<std::string>& words) {
  const std::vector<Command>* level = &all;
  const Command* found = nullptr;
  std::string before;
  for (const std::string& word : words) {
    const auto at = std::ranges::find(*level, word, &Command::name);
    if (at == level->end()) throw unknown_command(before, word, *level);
    found = &*at;
    level = &found->subcommands;
    before += word + ' ';
  }
  if (found == nullptr) throw std::invalid_argument("no command is named");
  return *found;
}

void check_command_words(const std::vector<Command>& all, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with("-")) return;
  const Command& command = find_command(all, {words.front()});
  if (words.size() < 2 || words[1].starts_with("-") ||
      meant_by(words[1], command.subcommands).empty())
    return;
  std::error_code failed;
  if (!std::filesystem::exists(words[1], failed)) find_command(all, {words[0], words[1]});
}

std::string nearest_option(const Command& command, std::string_view word) {
  std::vector<std::string> known{"--help"};
  for (const Explained& option : general_options())
    known.emplace_back(option.word.substr(option.word.find("--"), option.word.find(' ')));
  for (const Option& option : command.options) {
    std::stringstream names(option.name);
    for (std::string name; std::getline(names, name, ',');)
      if (name.starts_with("-")) known.push_back(name);
  }
  return nearest_word(word.substr(0, word.find('=')), known);
}

}  // namespace mahlwerk::commands

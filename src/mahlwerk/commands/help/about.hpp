// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/commands/command.hpp"

// Texts about the program as a whole, for its help and its manual pages.
namespace mahlwerk::commands {

/// A word that the user meets, and its meaning.
struct Explained {
  std::string_view word, meaning;
};

/// Shell words that list the commands, for completions.
std::string_view command_completions();
/// What the program does, one sentence.
std::string_view purpose();
/// The folder of the first example, as the user can type it.
std::string first_example();
/// The exit codes, in increasing order.
const std::vector<Explained>& exit_codes();
/// Options of the program, which every command takes.
const std::vector<Explained>& general_options();
/// The name of an option's value: "PATH"; empty for a flag.
std::string value_name(const Option& option);
/// What an option does, with its limits and what it goes with.
std::string meaning_of(const Option& option);
/// Environment variables that the program reads.
const std::vector<Explained>& environment_variables();

}  // namespace mahlwerk::commands

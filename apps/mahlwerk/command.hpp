// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "commands.hpp"

// Description of a command. main.cpp builds the command-line parser from it, completion.cpp the
// shell completion.
namespace mahlwerk::app {

/// The member of Request that receives the value of an option; `bool` is a flag without a value.
using Target =
    std::variant<bool Request::*, int Request::*, std::string Request::*,
                 std::vector<std::string> Request::*, std::vector<cases::Override> Request::*,
                 std::optional<std::filesystem::path> Request::*,
                 std::optional<std::uint64_t> Request::*, std::optional<double> Request::*>;

/// An option, or a positional argument.
struct Option {
  std::string name;  ///< "--out", "--jobs,--threads"; of a positional argument "CASE"
  Target target;
  std::string about;
  std::string type = {};  ///< name of its value in the help; empty: by its C++ type
  bool required = false;
  std::array<int, 2> range = {};          ///< allowed integers; {0, 0}: any
  std::vector<std::string> values = {};   ///< allowed values; empty: all
  std::string excludes = {}, needs = {};  ///< another option, listed before
  /// Shell completions of an argument: words, or a command that prints them; empty: files for a
  /// positional argument, nothing for an option.
  std::string completions = {};
  /// More of them, computed only when a completion script is printed; null: none.
  std::string (*more_completions)() = nullptr;
};
using Options = std::vector<Option>;

struct Command {
  std::string name, about;
  Options options;
  int (*perform)(const Request&);
  std::vector<Command> subcommands = {};  ///< "status" of "sweep status"
};

/// All commands, in the order of the help. Each command has a function and a file of its own.
std::vector<Command> commands();

// Options that several commands share.

Option one_case();       ///< CASE
Option several_cases();  ///< CASE, or a folder of cases
Options changes();       ///< --set, --seed
/// --out, --force, --jobs, --quiet. The help names the default result folder, with `suffix`.
Options running(std::string_view suffix = {});
Option threads();                           ///< --jobs
Option quiet();                             ///< --quiet
Option json();                              ///< --json
Option checkpoint(std::string_view about);  ///< --checkpoint
Option resumable_checkpoint();              ///< the same for commands that resume by themselves

/// The lists, concatenated.
Options joined(std::initializer_list<Options> lists);

}  // namespace mahlwerk::app

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mahlwerk/cases/read.hpp"

// Description of a command. apps/mahlwerk builds the command-line parser from it, completion.cpp
// the shell completion, manual.cpp the manual pages, and the Python module sets options by their
// names.
namespace mahlwerk::commands {

/// Where the value of an option goes: a member of the arguments of its command; `bool` is a flag
/// without a value.
using Target = std::variant<bool*, int*, std::string*, std::vector<std::string>*,
                            std::vector<cases::Override>*, std::optional<std::filesystem::path>*,
                            std::optional<std::uint64_t>*, std::optional<double>*>;

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
  std::vector<std::string> (*more_completions)() = nullptr;
};
using Options = std::vector<Option>;

/// A command owns its arguments: `perform` holds the object into which `options` point.
struct Command {
  std::string name, about;
  Options options;
  std::function<int()> perform;           ///< returns the exit code
  std::vector<Command> subcommands = {};  ///< "status" of "sweep status"
};

/// All commands, in the order of the help, without arguments. Each has a function and a file of its
/// own.
std::vector<Command> all_commands();

}  // namespace mahlwerk::commands

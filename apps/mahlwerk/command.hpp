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

// What a command says of itself: main.cpp reads the command line by it, completion.cpp offers it to
// a shell.
namespace mahlwerk::app {

/// Where the value of an option goes; `bool` takes none.
using Target =
    std::variant<bool Request::*, int Request::*, std::string Request::*,
                 std::vector<std::string> Request::*, std::vector<cases::Override> Request::*,
                 std::optional<std::filesystem::path> Request::*,
                 std::optional<std::uint64_t> Request::*, std::optional<double> Request::*>;

/// An option, or a word without one.
struct Option {
  std::string name;  ///< "--out", "--jobs,--threads", or "CASE" of a word
  Target target;
  std::string about;
  std::string type = {};  ///< what the help calls its value; empty: by its kind
  bool required = false;
  std::array<int, 2> range = {};          ///< of a whole number; {0, 0}: any
  std::vector<std::string> values = {};   ///< that are allowed; empty: all
  std::string excludes = {}, needs = {};  ///< another option, given before
  /// Of a word: what a shell may offer, words or a command that prints them; empty: files.
  std::string completions = {};
};
using Options = std::vector<Option>;

struct Command {
  std::string name, about;
  Options options;
  int (*perform)(const Request&);
  std::vector<Command> subcommands = {};  ///< "status" of "sweep status"
};

/// All there are, in the order of the help. A command is a function here and a file.
std::vector<Command> commands();

// Options that several commands take.

Option one_case();       ///< CASE
Option several_cases();  ///< CASE, or a folder of cases
Options changes();       ///< --set, --seed
/// --out, --force, --jobs, --quiet; the help says that results go to the usual place and `suffix`.
Options running(std::string_view suffix = {});
Option threads();                           ///< --jobs
Option quiet();                             ///< --quiet
Option json();                              ///< --json
Option checkpoint(std::string_view about);  ///< --checkpoint
Option kept_checkpoint();                   ///< the same where a command goes on unasked

/// One list after the other.
Options joined(std::initializer_list<Options> lists);

}  // namespace mahlwerk::app

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

// Other programs as child processes (POSIX).
namespace mahlwerk::commands {

/// How a program ended: its exit status and what it wrote to stderr; or why it did not start.
struct ProgramEnd {
  int start_error = 0;  ///< errno
  int status = -1;
  std::string errors;
};

/// Runs a program of the search path without a shell, with the environment of this process and
/// `variable` ("NAME=VALUE").
ProgramEnd run_program(std::vector<std::string> words, std::string variable);

/// What a command of the shell wrote to stdout and stderr, and its exit code: -1 if it did not
/// start or was ended by a signal.
struct CommandOutput {
  std::string text;
  int exit_code = -1;
};
CommandOutput shell_output(const std::string& command);

}  // namespace mahlwerk::commands

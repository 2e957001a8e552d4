// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/results/files/json_value.hpp"

// What is printed on stdout arrives, or its loss is an error with an exit code of its own.
namespace mahlwerk::app {

/// Prints text that may hold what a case or a user said: control characters are escaped.
void to_stdout(std::string_view text);

/// Prints what a command found, for programs to read.
void json_to_stdout(const results::Json& json);

/// Before anything is printed or opened: a reader that has gone ends no run, and no file takes the
/// place of a stream that is closed.
void guard_output();

/// Whether a byte of stdout could not be written; `error` is the number of the error met just now.
bool output_failed(int error);

/// Once all is printed: the exit code, of lost output where `code` tells of nothing worse.
int finish_output(int code);

}  // namespace mahlwerk::app

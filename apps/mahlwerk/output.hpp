// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/results/files/json_value.hpp"

// Output on stdout. Lost output is an error with its own exit code.
namespace mahlwerk::app {

/// Prints text to stdout with control characters escaped: it may contain text of a case or user.
void to_stdout(std::string_view text);

/// Prints the result of a command as JSON.
void json_to_stdout(const results::Json& json);

/// Call before anything is printed or opened. A closed pipe (SIGPIPE) then does not end a run, and
/// no file gets the descriptor of a closed standard stream.
void guard_output();

/// Whether writing to stdout failed; `error` is the errno of the current error.
bool output_failed(int error);

/// Call after all output. Returns `code`, or output_lost if writing failed and `code` is success.
int finish_output(int code);

}  // namespace mahlwerk::app

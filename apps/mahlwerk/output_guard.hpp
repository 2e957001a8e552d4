// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lost output of the program is an error with its own exit code.
namespace mahlwerk::app {

/// Call before anything is printed or opened. A closed pipe (SIGPIPE) then does not end a run, and
/// no file gets the descriptor of a closed standard stream.
void guard_output();

/// Whether writing to stdout failed; `error` is the errno of the current error.
bool output_failed(int error);

/// Call after all output. Returns `code`, or output_lost if writing failed and `code` is success.
int finish_output(int code);

}  // namespace mahlwerk::app

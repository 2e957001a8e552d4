// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/results/files/json_value.hpp"

// Output on stdout.
namespace mahlwerk::commands {

/// Prints text to stdout with control characters escaped: it may contain text of a case or user.
void to_stdout(std::string_view text);

/// Prints the result of a command as JSON.
void json_to_stdout(const results::Json& json);

}  // namespace mahlwerk::commands

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/commands/command.hpp"

// The help, from the descriptions of the commands.
namespace mahlwerk::commands {

/// Prints what the program does, the commands most used, and where to read on: for a call without a
/// command.
void print_short_help(const std::vector<Command>& all);
/// Prints the help of the command that `words` name, {"sweep", "status"}; without words that of the
/// program. Throws InputError if there is no such command.
void print_help(const std::vector<Command>& all, const std::vector<std::string>& words);

}  // namespace mahlwerk::commands

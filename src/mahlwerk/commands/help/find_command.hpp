// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/commands/command.hpp"

// Commands by their names, with the nearest name where there is no such command.
namespace mahlwerk::commands {

/// The command that `words` name: {"sweep", "status"}. Throws InputError with the nearest name if
/// there is none. `words` are not empty.
const Command& find_command(const std::vector<Command>& all, const std::vector<std::string>& words);

/// Throws InputError if the first word names no command of `all`, or if the second is neither a
/// subcommand nor a file and is written nearly as a subcommand. Words after an option do not count.
void check_command_words(const std::vector<Command>& all, const std::vector<std::string>& words);

/// The option of `command` whose name is nearest to `word`, "--jsob"; empty if none is near.
std::string nearest_option(const Command& command, std::string_view word);

}  // namespace mahlwerk::commands

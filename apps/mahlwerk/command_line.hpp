// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/commands/command.hpp"

namespace mahlwerk::app {

/// Sets the arguments of the command in `all` that the words of a command line name, and returns
/// it; nullptr if they asked for the help or the version, which is printed. Throws InputError, with
/// the nearest name for a misspelt option.
const commands::Command* parse_command_line(const std::vector<commands::Command>& all,
                                            std::vector<std::string> words);

}  // namespace mahlwerk::app

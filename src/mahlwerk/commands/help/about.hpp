// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

// Texts about the program as a whole, for its help and its manual pages.
namespace mahlwerk::commands {

/// A word that the user meets, and its meaning.
struct Explained {
  std::string_view word, meaning;
};

/// What the program does, one sentence.
std::string_view purpose();
/// The folder of the first example, as the user can type it.
std::string first_example();
/// The exit codes, in increasing order.
const std::vector<Explained>& exit_codes();
/// Environment variables that the program reads.
const std::vector<Explained>& environment_variables();

}  // namespace mahlwerk::commands

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"

// Locations: the catalogue, the case files that a target names, the default result
// folder.
namespace mahlwerk::commands {

/// The version of this build, and its catalogue (base/data_folder.hpp).
std::string_view version();
cases::Catalogue catalogue();

/// The one mill of the catalogue that `target` names, if there is no such file or folder; else
/// empty.
std::string mill_named(const std::string& target);

/// The case files that `target` names: the file itself, the folder's case.toml, or else every .toml
/// in the folder. Throws InputError if there is none.
std::vector<std::filesystem::path> case_files(const std::string& target);

/// The single case file that `target` names, for a command ("fit") that takes one. Throws
/// InputError if there are several.
std::filesystem::path one_case_file(const std::string& target, std::string_view command);

/// The default result folder: results/ and the name of the folder or file that the user gave,
/// followed by the case's name if there are several cases.
std::filesystem::path default_folder(const std::string& target, const std::filesystem::path& file,
                                     bool several);

/// Throws InputError if a file exists and `force` does not replace it.
void refuse_existing(const std::filesystem::path& file, bool force);

}  // namespace mahlwerk::commands

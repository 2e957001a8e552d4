// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// The list of files that Mahlwerk wrote into a folder: --force removes these and nothing else.
namespace mahlwerk::results {

/// Where it stands in the folder: a line each, relative to the folder, behind lines with "#".
constexpr std::string_view manifest_name = "mahlwerk-files.txt";

/// The files listed, or nothing where there is no list.
std::optional<std::set<std::string>> listed_files(const std::filesystem::path& folder);

/// Lists every file that is in the folder and below it, and folders with nothing in them ("a/").
void list_all_files(const std::filesystem::path& folder);

/// Adds names to the list, which is made if need be; processes may do so at the same time. Throws
/// InputError where that cannot be written.
void list_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace mahlwerk::results

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

/// File name of the list in the folder: lines with "#", then one relative path per line.
constexpr std::string_view manifest_name = "mahlwerk-files.txt";

/// The listed files, or nothing if there is no list.
std::optional<std::set<std::string>> listed_files(const std::filesystem::path& folder);

/// Writes the list of all files in the folder and its subfolders, and of empty folders ("a/").
void list_all_files(const std::filesystem::path& folder);

/// Appends names to the list, which is created if needed. Several processes may append at the same
/// time. Throws InputError on failure.
void list_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Decides which files in a folder Mahlwerk wrote: by the list of files, or by their names where an
// earlier version left no list.
namespace mahlwerk::results {

/// Whether the folder is a result: it has a list of files, or a summary, a store or a table that
/// begins as Mahlwerk writes them.
bool is_result(const std::filesystem::path& folder);

/// Files in the folder that Mahlwerk did not write, as sorted relative paths.
std::vector<std::string> foreign_files(const std::filesystem::path& folder);

/// Writes the list of a campaign's folder that has none, from the names of its files.
void list_campaign_files(const std::filesystem::path& folder);

}  // namespace mahlwerk::results

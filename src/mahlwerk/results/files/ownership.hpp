// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

// What in a folder is Mahlwerk's: by its list of files, or by names where an earlier version left
// none.
namespace mahlwerk::results {

/// A folder with a list of files; or with a summary, a store, or a table that begins as we write
/// it.
bool is_result(const std::filesystem::path& folder);

/// What is in the folder and not ours, by names relative to it, in order.
std::vector<std::string> foreign_files(const std::filesystem::path& folder);

/// Of a campaign's folder without a list: makes one of the files that are ours by their names.
void list_campaign_files(const std::filesystem::path& folder);

}  // namespace mahlwerk::results

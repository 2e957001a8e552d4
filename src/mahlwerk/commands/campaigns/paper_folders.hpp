// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mahlwerk::commands {

/// A folder with a paper.toml, and the default folder for its results.
struct PaperFolder {
  std::filesystem::path place, results;
};

/// Whether `target` means all sets of measured data, the folders of validation/.
bool is_validation(const std::string& target);

/// The folders that `target` names by path or name: one of papers/ or validation/, all of
/// validation/ ("validation"), or all of papers/ (empty). Throws InputError if there is none.
std::vector<PaperFolder> paper_folders(const std::string& target);

}  // namespace mahlwerk::commands

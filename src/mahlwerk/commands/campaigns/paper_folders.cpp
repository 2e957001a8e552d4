// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/campaigns/paper_folders.hpp"

#include <algorithm>
#include <system_error>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char *own_papers = "papers", *measured_sets = "validation";

bool holds_paper(const fs::path& folder) {
  return fs::exists(folder / "paper.toml");
}

/// The name of a folder, also if its path ends in a slash.
std::string name_of(const fs::path& folder) {
  return fs::weakly_canonical(folder).filename().string();
}

PaperFolder paper_folder(const fs::path& place) {
  const bool measured = fs::weakly_canonical(place).parent_path().filename() == measured_sets;
  return {place, fs::path("results") / (measured ? measured_sets : own_papers) / name_of(place)};
}

std::vector<PaperFolder> all_of(const char* collection) {
  std::vector<PaperFolder> found;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(data_folder(collection), failed))
    if (holds_paper(entry.path())) found.push_back(paper_folder(entry.path()));
  if (found.empty())
    throw InputError(Fault{data_folder(collection).string(), "there is no paper",
                           "name a folder with a paper.toml", "no-such-paper"});
  std::ranges::sort(found, {}, &PaperFolder::place);
  return found;
}

}  // namespace

bool is_validation(const std::string& target) {
  return target == measured_sets;
}

std::vector<PaperFolder> paper_folders(const std::string& target) {
  if (target.empty()) return all_of(own_papers);
  if (is_validation(target)) return all_of(measured_sets);
  if (holds_paper(target)) return {paper_folder(target)};
  for (const char* collection : {own_papers, measured_sets})
    if (const fs::path place = data_folder(collection) / target; holds_paper(place))
      return {paper_folder(place)};
  throw InputError(Fault{target,
                         "there is no paper with this name, and no folder with a paper.toml",
                         "the names are those of the folders in papers/ and validation/; "
                         "\"validation\" means all of the latter",
                         "no-such-paper"});
}

}  // namespace mahlwerk::commands

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/manifest.hpp"

#include <fstream>

#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view head =
    "# Files that Mahlwerk wrote into this folder. --force removes these and nothing else.\n";

std::string lines(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + '\n';
  return text;
}

}  // namespace

std::optional<std::set<std::string>> listed_files(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  std::error_code none;
  if (!fs::is_regular_file(fs::symlink_status(file, none))) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(
        Fault{file.string(), "cannot be read", "check your permissions there", "cannot-read"});
  std::string line;
  if (!std::getline(in, line) || line + '\n' != head) return std::nullopt;
  std::set<std::string> names{std::string(manifest_name)};
  while (std::getline(in, line))
    if (!line.empty() && line.front() != '#') names.insert(line);
  return names;
}

void list_all_files(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (!entry.is_directory())
      names.insert(name);
    else if (fs::is_empty(entry.path()))
      names.insert(name + "/");
  }
  write_text(folder / manifest_name, std::string(head) + lines(names));
}

void list_files(const fs::path& folder, const std::vector<std::string>& names) {
  const std::optional<std::set<std::string>> known = listed_files(folder);
  std::set<std::string> fresh;
  for (const std::string& name : names)
    if (!known || !known->contains(name)) fresh.insert(name);
  if (fresh.empty()) return;
  const std::string text = (known ? "" : std::string(head)) + lines(fresh);
  append_text(folder / manifest_name, text);
}

}  // namespace mahlwerk::results

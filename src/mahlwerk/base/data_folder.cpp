// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/data_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk {
namespace {

namespace fs = std::filesystem;

fs::path& chosen_folder() {
  static fs::path folder;
  return folder;
}

/// share/mahlwerk of the installation, or of the build folder, that the running program belongs to.
fs::path beside_program() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) return {};
  return program.parent_path().parent_path() / "share" / "mahlwerk";
}

}  // namespace

void set_data_folder(fs::path folder) {
  chosen_folder() = std::move(folder);
}

fs::path data_folder(std::string_view part) {
  if (const char* said = std::getenv("MAHLWERK_CATALOGUE"); part == "catalogue" && said != nullptr)
    return said;
  const fs::path folder =
      (chosen_folder().empty() ? beside_program() : chosen_folder()) / fs::path(part);
  std::error_code failed;
  fs::path found = fs::canonical(folder, failed);  // a build folder has links to the sources
  if (!failed) return found;
  throw InputError(
      Fault{folder.string(), fmt::format("the folder {} of Mahlwerk's data is not here", part),
            "install Mahlwerk again, or move its installation as a whole; for the catalogue, "
            "MAHLWERK_CATALOGUE may name another folder",
            "no-data"});
}

std::string document(std::string_view name) {
  const fs::path file = name.substr(0, name.find('#'));
  try {
    const fs::path sources = data_folder("examples").parent_path();
    for (const fs::path& root : {sources.parent_path() / "doc" / "mahlwerk", sources}) {
      std::error_code failed;
      if (fs::exists(root / file, failed)) return (root / fs::path(name)).string();
    }
  } catch (const InputError&) {  // a message names the document without data, too
  }
  return std::string(name);
}

}  // namespace mahlwerk

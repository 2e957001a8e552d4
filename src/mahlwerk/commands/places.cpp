// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/places.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands {

namespace fs = std::filesystem;

std::string_view version() {
  return MAHLWERK_VERSION;
}

cases::Catalogue catalogue() {
  return cases::Catalogue(data_folder("catalogue"));
}

namespace {

/// The mills of the catalogue that are called so; none without a catalogue.
std::vector<std::string> mills_called(const std::string& name) {
  try {
    return catalogue().entries_called("mills", name);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::string mill_named(const std::string& target) {
  std::error_code failed;
  if (fs::exists(target, failed)) return "";
  const std::vector<std::string> mills = mills_called(target);
  return mills.size() == 1 ? mills.front() : "";
}

namespace {

/// What to type where a case was expected.
std::string instead_of(const std::string& target) {
  const std::vector<std::string> mills = mills_called(target);
  if (mills.empty())
    return "give a case file, or a folder that contains one; `mahlwerk list mills` names the mills";
  if (mills.size() > 1)
    return fmt::format("several mills of the catalogue are called so: name one of {}",
                       fmt::join(mills, ", "));
  return fmt::format(
      "this is a mill of the catalogue: mahlwerk estimate {0} --balls 2x10mm gives first answers, "
      "mahlwerk new --mill {0} FILE writes a case",
      mills.front());
}

}  // namespace

std::vector<fs::path> case_files(const std::string& target) {
  const fs::path place(target);
  std::error_code failed;
  if (!fs::exists(place, failed))
    throw InputError(
        Fault{target, "there is no such file or folder", instead_of(target), "no-such-case"});
  if (!fs::is_directory(place, failed)) return {place};
  if (fs::exists(place / "case.toml", failed)) return {place / "case.toml"};
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(place, failed))
    if (entry.path().extension() == ".toml" && entry.path().stem() != "expected" &&
        entry.path().stem() != "paper")
      found.push_back(entry.path());
  if (failed)
    throw InputError(
        Fault{target, "the folder cannot be read: " + failed.message(), "", "no-such-case"});
  if (found.empty())
    throw InputError(Fault{target, "the folder contains no case",
                           "put a case.toml there, or name the case file", "no-such-case"});
  std::sort(found.begin(), found.end());
  return found;
}

fs::path one_case_file(const std::string& target, std::string_view command) {
  const std::vector<fs::path> files = case_files(target);
  if (files.size() == 1) return files.front();
  throw InputError(Fault{
      target, fmt::format("the folder contains {} cases, {} takes one", files.size(), command),
      "name one of its files", "one-case"});
}

fs::path default_folder(const std::string& target, const fs::path& file, bool several) {
  const fs::path whole = fs::weakly_canonical(fs::path(target));
  const bool by_file = !fs::is_directory(whole) && file.stem() != "case";
  const fs::path name =
      by_file ? file.stem() : (fs::is_directory(whole) ? whole : whole.parent_path()).filename();
  return several ? fs::path("results") / name / file.stem() : fs::path("results") / name;
}

void refuse_existing(const fs::path& file, bool force) {
  std::error_code failed;
  if (force || !fs::exists(file, failed)) return;
  throw InputError(Fault{file.string(), "the file already exists",
                         "choose another name, or replace it with --force", "result-exists"});
}

}  // namespace mahlwerk::commands

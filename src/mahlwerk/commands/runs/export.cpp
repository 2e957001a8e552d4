// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// export: describes the result of a run as an RO-Crate, for a notebook or a repository of data.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <memory>
#include <set>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/runs/recorded_run.hpp"
#include "mahlwerk/report/record/ro_crate.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  std::string folder;
  std::optional<fs::path> out;
  std::vector<std::string> authors;
  std::string license;
  bool force = false, json = false;
};

/// Whether it is an ORCID, "0000-0002-1825-0097", with its check digit (ISO 7064 MOD 11-2).
bool is_orcid(std::string_view text) {
  constexpr std::size_t digits = 16, group = 5;
  int sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (i % group == group - 1) {
      if (c != '-') return false;
      continue;
    }
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (++count > digits || (!digit && (c != 'X' || count != digits))) return false;
    const int value = digit ? c - '0' : 10;
    if (count < digits)
      sum = (sum + value) * 2 % 11;
    else if ((12 - sum) % 11 != value)
      return false;
  }
  return count == digits && text.back() != '-';
}

/// "Ada Lovelace" or "Ada Lovelace, 0000-0002-1825-0097".
report::CrateAuthor author_of(const std::string& text) {
  constexpr std::string_view site = "https://orcid.org/";
  const std::size_t comma = text.rfind(", ");
  std::string orcid = comma == std::string::npos ? "" : text.substr(comma + 2);
  if (orcid.starts_with(site)) orcid.erase(0, site.size());
  const bool means_orcid = std::ranges::any_of(
      orcid, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  if (!means_orcid) orcid.clear();
  const std::string name = means_orcid ? text.substr(0, comma) : text;
  if (means_orcid && !is_orcid(orcid))
    throw InputError(Fault{"--author " + text, fmt::format("{} is not an ORCID", orcid),
                           "write for instance --author \"Ada Lovelace, 0000-0002-1825-0097\"",
                           "wrong-author"});
  if (std::ranges::all_of(name, [](char c) { return c == ' '; }))
    throw InputError(Fault{"--author " + text, "the name is empty", "write the name of a person",
                           "wrong-author"});
  return {name, orcid};
}

/// Refuses what is neither an identifier of SPDX nor an address.
void check_license(const std::string& license) {
  const bool address = license.starts_with("https://") || license.starts_with("http://");
  const bool fits = std::ranges::all_of(license, [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return address ? byte > 0x20 : std::isalnum(byte) != 0 || c == '-' || c == '.' || c == '+';
  });
  if (!fits)
    throw InputError(Fault{
        "--license " + license, "this is neither an identifier of SPDX nor an address",
        "write for instance --license CC-BY-4.0, or the address of the license", "wrong-license"});
}

/// The list of files that names those of a result: its own, or that of the folder above.
struct ListOfFiles {
  fs::path folder;              ///< where the list is
  std::string below;            ///< path of the result from there: "" or "soft/"
  std::set<std::string> names;  ///< relative to the result
};

std::optional<ListOfFiles> list_of_files(const fs::path& folder) {
  if (auto own = results::listed_files(folder)) return ListOfFiles{folder, "", std::move(*own)};
  const fs::path whole = fs::weakly_canonical(folder);
  ListOfFiles list{whole.parent_path(), whole.filename().string() + "/", {}};
  const auto above = results::listed_files(list.folder);
  if (!above) return std::nullopt;
  for (const std::string& name : *above)
    if (name.starts_with(list.below)) list.names.insert(name.substr(list.below.size()));
  if (list.names.empty()) return std::nullopt;
  return list;
}

/// Files of the result, by their path relative to it: those that Mahlwerk wrote, or all files of a
/// folder without a list of them. The list itself changes with the description and is left out.
std::set<std::string> result_files(const fs::path& folder) {
  std::set<std::string> names, found;
  if (auto list = list_of_files(folder))
    names = std::move(list->names);
  else
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      names.insert(entry.path().filename().string());
  std::error_code none;
  for (const std::string& name : names) {
    const fs::path path = fs::path(name).lexically_normal();
    if (name != report::crate_file && name != results::manifest_name && path.is_relative() &&
        *path.begin() != ".." && fs::is_regular_file(folder / path, none))
      found.insert(name);
  }
  return found;
}

/// The files of the folder itself, and its subfolders.
std::vector<report::CratePart> crate_parts(const fs::path& folder,
                                           const std::set<std::string>& files) {
  std::vector<report::CratePart> parts;
  for (const std::string& name : files) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos)
      parts.push_back({name, fs::file_size(folder / name)});
    else if (parts.empty() || parts.back().path != name.substr(0, slash + 1))
      parts.push_back({name.substr(0, slash + 1)});
  }
  return parts;
}

/// Why a run is incomplete; empty if it is complete.
std::string failure_of(const results::Json& summary) {
  const results::Json& about = *summary.find("_about");
  const auto is = [&](std::string_view key) {
    const results::Json* found = about.find(key);
    const auto* truth = found == nullptr ? nullptr : std::get_if<bool>(&found->value());
    return truth != nullptr && *truth;
  };
  if (is("complete")) return "";
  return is("interrupted") ? "The run was interrupted: not all replicates are complete."
                           : "Not all replicates are complete.";
}

results::Json crate_of(const fs::path& folder, const ExportArguments& given,
                       const std::set<std::string>& files) {
  std::vector<report::CrateAuthor> authors;
  for (const std::string& text : given.authors) authors.push_back(author_of(text));
  const RecordedRun run = recorded_run(folder);
  const report::Citation cited =
      report::citation(run.mill_case, run.state, run.counted, run.version);
  return report::ro_crate(
      {.mill_case = run.mill_case,
       .summary = run.summary,
       .cited = cited,
       .methods = report::methods(run.mill_case, run.state.engine, run.counted, run.version),
       .case_file = "case.resolved.toml",
       .parts = crate_parts(folder, files),
       .authors = std::move(authors),
       .license = given.license,
       .date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))),
       .version = run.version,
       .failure = failure_of(run.summary)});
}

/// Writes a copy of the result with its description.
fs::path write_copy(const fs::path& folder, const fs::path& to, bool force,
                    const std::set<std::string>& files, const std::string& text) {
  const fs::path from = fs::weakly_canonical(folder), place = fs::weakly_canonical(to);
  const fs::path relative = place.lexically_relative(from);
  if (!relative.empty() && *relative.begin() != "..")
    throw InputError(Fault{"--out " + to.string(), "this is the result folder, or lies in it",
                           "give another folder, or leave --out away", "result-exists"});
  results::Folder out(to, force);
  for (const std::string& name : files) {
    std::error_code failed;
    fs::copy_file(folder / name, out.file(name), failed);
    if (failed) throw results::cannot_write(to / name, failed.message());
  }
  out.write(report::crate_file, text);
  out.commit();
  return to / report::crate_file;
}

/// Writes the description into the result folder, and its name into the list of files.
fs::path write_beside(const fs::path& folder, bool force, const std::string& text) {
  fs::path file = folder / report::crate_file;
  std::error_code none;
  if (!force && fs::exists(file, none))
    throw InputError(Fault{file.string(), "the result has a description already",
                           "replace it with --force, or write a copy with --out FOLDER",
                           "result-exists"});
  results::write_whole(file, text);
  if (const auto list = list_of_files(folder))
    results::list_files(list->folder, {list->below + std::string(report::crate_file)});
  return file;
}

int export_run(const ExportArguments& given) {
  check_license(given.license);
  const fs::path folder = given.folder;
  if (!holds_run(folder)) recorded_run(folder);  // says what is wrong
  const std::set<std::string> files = result_files(folder);
  const std::string text = crate_of(folder, given, files).text(2) + '\n';
  const fs::path file = given.out ? write_copy(folder, *given.out, given.force, files, text)
                                  : write_beside(folder, given.force, text);
  if (given.json)
    json_to_stdout(results::Json::object({{"record", file.string()}}));
  else
    places_to_stdout({{"record", file}});
  return success;
}

}  // namespace

Command export_command() {
  const auto given = std::make_shared<ExportArguments>();
  return {
      "export",
      "describe the result of a run as an RO-Crate: conditions, results, files, references",
      {{.name = "FOLDER",
        .target = &given->folder,
        .about = "the result folder of a run",
        .required = true},
       {"--out", &given->out,
        "write a copy of the folder with its description (default: into FOLDER)"},
       {"--author", &given->authors,
        "an author, with or without ORCID: \"NAME\" or \"NAME, ORCID\"; may be repeated", "NAME"},
       {"--license", &given->license, "license of the data: an identifier of SPDX or an address",
        "LICENSE"},
       {"--force", &given->force, "replace an existing description or copy"},
       json(given->json)},
      [given] { return export_run(*given); }};
}

}  // namespace mahlwerk::commands

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// new: a commented case to start from.
#include <fmt/format.h>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reference/case_template.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "mahlwerk/commands/reference/start_values.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// What --mill, --kind, --jar, --jar-kind and --balls can name.
void print_choices() {
  const cases::Catalogue all = catalogue();
  const auto print = [&](std::string_view option, const std::vector<std::string>& words) {
    to_stdout(fmt::format("{:<11} {}\n", option, fmt::join(words, "\n            ")));
  };
  std::vector<std::string> mills;
  for (const std::string& name : all.names("mills")) {
    const auto entry = all.find("mills", name);
    mills.push_back(fmt::format(
        "{:<20} {}{}", name, entry.title,
        entry.jars.empty() ? "" : fmt::format("; jars: {}", fmt::join(entry.jars, ", "))));
  }
  print("--mill", mills);
  print("or --kind", kinds_of("mill"));
  print("--jar", all.names("jars"));
  print("or --jar-kind", kinds_of("jar"));
  print("--balls", all.names("media"));
  to_stdout("\nFor instance: mahlwerk new --mill retsch-mm400 --jar-kind capsule my-case.toml\n");
}

/// Throws InputError if the parts do not make a case that can be run.
void check_case(const std::string& text, const fs::path& file) {
  const cases::Case made = cases::read_text(text, file, catalogue());
  if (const auto faults = cases::engine_faults(made); !faults.empty()) throw InputError(faults);
}

struct NewArguments {
  std::string file;  ///< empty: the terminal
  CaseParts parts;
  bool force = false;
};

int new_case(const NewArguments& given) {
  const fs::path file = given.file;
  CaseParts parts = given.parts;
  if (parts.mill.empty() && parts.mill_kind.empty()) {
    print_choices();
    if (file.empty()) return success;
    throw InputError(Fault{"new", "no mill is given, nothing was written",
                           "write for instance --mill retsch-mm400 or --kind planetary",
                           "bad-command-line"});
  }
  complete(parts, catalogue());
  const bool motion = parts.mill_kind == "tabulated", surface = parts.jar_kind == "mesh";
  if (file.empty() && (motion || surface))
    throw InputError(Fault{"new", "this kind needs a file beside the case",
                           "name the case: mahlwerk new ... my-case.toml", "bad-command-line"});
  const std::string stem = file.stem().string();
  std::vector<std::pair<fs::path, std::string>> files;
  if (motion) {
    parts.motion_file = stem + "-motion.csv";
    files.emplace_back(file.parent_path() / parts.motion_file, sample_motion());
  }
  if (surface) {
    parts.surface_file = stem + "-jar.stl";
    files.emplace_back(file.parent_path() / parts.surface_file, sample_surface());
  }
  const std::string text = case_template(parts, catalogue());
  if (!file.empty()) refuse_existing(file, given.force);
  for (const auto& [path, content] : files) refuse_existing(path, given.force);
  for (const auto& [path, content] : files) results::write_whole(path, content);
  try {
    check_case(text, file.empty() ? fs::path("case.toml") : file);
  } catch (const InputError&) {
    std::error_code ignored;
    for (const auto& [path, content] : files) fs::remove(path, ignored);
    throw;
  }
  if (file.empty()) {
    verbatim_to_stdout(text);
    return success;
  }
  results::write_whole(file, text);
  for (const auto& [path, content] : files) to_stdout(fmt::format("{} written\n", path.string()));
  const std::string word = shell_word(file.string());
  to_stdout(fmt::format(
      "{} written. Replace what is marked ASSUMED, then: mahlwerk check {}; mahlwerk run {}\n",
      file.string(), word, word));
  return success;
}

}  // namespace

Command new_command() {
  const auto entries = [](std::string_view category) {
    return fmt::format("$(\"${{COMP_WORDS[0]}}\" list {} 2>/dev/null | awk '/^  / {{print $1}}')",
                       category);
  };
  const auto given = std::make_shared<NewArguments>();
  CaseParts& parts = given->parts;
  return {"new",
          "write a commented case to start from; without options, list what can be given",
          {{.name = "FILE",
            .target = &given->file,
            .about = "the case file to write (default: the terminal)"},
           {.name = "--mill",
            .target = &parts.mill,
            .about = "mill of the catalogue",
            .type = "NAME",
            .completions = entries("mills")},
           {.name = "--kind",
            .target = &parts.mill_kind,
            .about = "kind of mill, with values to be replaced",
            .type = "KIND",
            .excludes = "--mill",
            .more_completions = [] { return kinds_of("mill"); }},
           {.name = "--jar",
            .target = &parts.jar,
            .about =
                "jar of the catalogue (default: a middle one of the mill, else one to be replaced)",
            .type = "NAME",
            .completions = entries("jars")},
           {.name = "--jar-kind",
            .target = &parts.jar_kind,
            .about = "kind of jar, with values to be replaced",
            .type = "KIND",
            .excludes = "--jar",
            .more_completions = [] { return kinds_of("jar"); }},
           {.name = "--balls",
            .target = &parts.balls,
            .about = "ball set of the catalogue",
            .type = "NAME",
            .completions = entries("media")},
           {"--force", &given->force, "replace an existing file"}},
          [given] { return new_case(*given); }};
}

}  // namespace mahlwerk::commands

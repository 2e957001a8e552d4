// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/runs/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/commands/places.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;
using results::Json;

constexpr std::string_view summary_name = "summary.json", case_name = "case.resolved.toml";

[[noreturn]] void refuse_damaged(const fs::path& file, std::string_view why) {
  throw InputError(Fault{file.string(),
                         fmt::format("the file is damaged or cannot be read: {}", why),
                         "run the case again", "no-result"});
}

std::string content_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) refuse_damaged(file, "no such file, or no permission");
  return text;
}

/// The value of a key of `_about`. Refuses a file that lacks it, or has another type there.
template <class T>
const T& member(const fs::path& file, const Json& about, std::string_view key) {
  const Json* found = about.find(key);
  const T* value = found == nullptr ? nullptr : std::get_if<T>(&found->value());
  if (value == nullptr) refuse_damaged(file, fmt::format("it has no valid `{}`", key));
  return *value;
}

double number_of(const fs::path& file, const Json& of, std::string_view key) {
  const Json* found = of.find(key);
  if (found != nullptr) {
    const Json::Value& value = found->value();
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* count = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*count);
  }
  refuse_damaged(file, fmt::format("it has no valid `{}`", key));
}

cases::EngineName engine_of(const fs::path& file, const Json& about) {
  const auto& name = member<std::string>(file, about, "engine");
  for (const auto engine :
       {cases::EngineName::event, cases::EngineName::soft, cases::EngineName::lammps})
    if (cases::name_of(engine) == name) return engine;
  refuse_damaged(file, fmt::format("it has an unknown engine {}", name));
}

/// The replicates that means are taken over: those that are complete if there are at least two,
/// else all with a counted time (results::averaged_replicates).
report::CountedRuns counted_of(const fs::path& file, const Json& about) {
  const auto& all = member<Json::Array>(file, about, "replicates");
  std::vector<const Json*> complete, counted;
  for (const Json& one : all) {
    if (member<bool>(file, one, "complete")) complete.push_back(&one);
    if (number_of(file, one, "time") > 0) counted.push_back(&one);
  }
  const auto& chosen = complete.size() >= 2 ? complete : counted;
  report::CountedRuns runs{.replicates = chosen.size(), .time = 0, .settling = 0};
  for (const Json* one : chosen) {
    const double share = 1 / static_cast<double>(chosen.size());
    runs.time += share * number_of(file, *one, "time");
    *runs.settling += share * number_of(file, *one, "settling");
  }
  return runs;
}

/// What stands behind the value of a line of TOML: " # comment"; empty without one.
std::string comment_of(const std::string& line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '\\')
      ++i;  // the next one is escaped
    else if (line[i] == '"')
      quoted = !quoted;
    else if (!quoted && line[i] == '#')
      return line.substr(std::min(i + 2, line.size()));
  }
  return "";
}

/// Key -> the comment behind its value: where the value came from when the case was run.
std::map<std::string, std::string> recorded_sources(const std::string& text) {
  std::map<std::string, std::string> sources;
  std::map<std::string, int> count;
  std::string section, line;
  for (std::istringstream lines(text); std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find(" = "));
    if (line.starts_with("[[")) {
      const std::string list = line.substr(2, line.find("]]") - 2);
      section = fmt::format("{}.{}.", list, ++count[list]);
    } else if (line.starts_with("[")) {
      section = line.substr(1, line.find(']') - 1) + ".";
    } else if (const std::string source = comment_of(line); !source.empty()) {
      sources[section + name] = source;
    }
  }
  return sources;
}

/// Puts the origins of the run in place of the lines of case.resolved.toml.
void restore_origins(cases::Case& c, const fs::path& file, const std::string& text,
                     const Json& about) {
  constexpr std::string_view weak = " (unverified)";
  const std::map<std::string, std::string> sources = recorded_sources(text);
  std::vector<std::string> assumed;
  for (const Json& one : member<Json::Array>(file, about, "assumed"))
    assumed.push_back(member<std::string>(file, one, "key"));
  for (cases::Origin& origin : c.origins) {
    if (const auto found = sources.find(origin.key); found != sources.end())
      origin.source = found->second;
    origin.assumed = std::ranges::find(assumed, origin.key) != assumed.end();
    origin.unverified = origin.source.ends_with(weak);
    if (origin.unverified) origin.source.resize(origin.source.size() - weak.size());
  }
}

/// Refuses a folder without the result of a run, and says which folder to give.
[[noreturn]] void refuse_folder(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder, none))
    throw InputError(Fault{folder.string(), "there is no such folder",
                           "give the folder that `mahlwerk run` wrote", "no-result"});
  if (!fs::is_directory(folder, none))
    throw InputError(Fault{folder.string(), "this is a file, not the folder of a result",
                           "give the folder that `mahlwerk run` wrote", "no-result"});
  if (fs::exists(folder / "campaign.sqlite", none))
    throw InputError(Fault{folder.string(), "this is the folder of a campaign, which has many runs",
                           "give the folder of one of them: `mahlwerk sweep --results all` keeps "
                           "them in runs/",
                           "no-result"});
  if (holds_run(folder / "event") && holds_run(folder / "soft"))
    throw InputError(Fault{folder.string(), "this folder compares the engines, with two results",
                           "give its folder event or soft", "no-result"});
  throw InputError(Fault{folder.string(),
                         "there is no summary.json: this is not the result of a run",
                         "give the folder that `mahlwerk run` wrote", "no-result"});
}

}  // namespace

bool holds_run(const fs::path& folder) {
  std::error_code none;
  return fs::is_regular_file(folder / summary_name, none);
}

RecordedRun recorded_run(const fs::path& folder) {
  if (!holds_run(folder)) refuse_folder(folder);
  const fs::path file = folder / summary_name;
  RecordedRun run;
  try {
    run.summary = Json::parse(content_of_file(file));
  } catch (const std::invalid_argument& error) {
    refuse_damaged(file, error.what());
  }
  const Json* about = run.summary.find("_about");
  if (about == nullptr) refuse_damaged(file, "it has no `_about`");
  const std::string text = content_of_file(folder / case_name);
  run.mill_case = cases::read_text(text, folder / case_name, catalogue());
  restore_origins(run.mill_case, file, text, *about);
  run.version = member<std::string>(file, *about, "mahlwerk");
  run.state = {.engine = engine_of(file, *about),
               .has_regime = !member<std::string>(file, *about, "regime").empty()};
  run.counted = counted_of(file, *about);
  return run;
}

}  // namespace mahlwerk::commands

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// list and describe: contents of the catalogue, and the keys and units of a case file.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/reference/catalogue_json.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/quantity_list.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::commands {
namespace {

using results::Json;

std::vector<std::string> requested_categories(const std::string& target) {
  const auto& all = cases::Catalogue::categories;
  if (target.empty()) return {std::begin(all), std::end(all)};
  if (std::find(std::begin(all), std::end(all), target) != std::end(all)) return {target};
  throw InputError(Fault{"list", "there is no category '" + target + "' in the catalogue",
                         "use one of mills, jars, materials, media, keys, units or quantities",
                         "unknown-name"});
}

/// The entries of this name: "steel-304", or "materials/steel-304".
std::vector<cases::CatalogueEntry> entries_named(const std::string& name) {
  const cases::Catalogue all = catalogue();
  std::vector<cases::CatalogueEntry> found;
  for (const std::string_view category : cases::Catalogue::categories)
    for (const std::string& one : all.names(category))
      if (one == name || fmt::format("{}/{}", category, one) == name)
        found.push_back(all.find(category, one));
  if (!found.empty() || !sections_named(name).empty()) return found;
  for (const std::string_view category : cases::Catalogue::categories)  // "MM 400"
    for (const std::string& one : all.entries_called(category, name))
      found.push_back(all.find(category, one));
  return found;
}

[[noreturn]] void report_unknown(const std::string& name) {
  const cases::Catalogue all = catalogue();
  std::vector<std::string> known = section_words();
  for (const std::string_view category : cases::Catalogue::categories)
    for (const std::string& one : all.names(category)) known.push_back(one);
  for (const cases::KeyInfo& key : cases::all_keys()) known.push_back(key.key);
  for (const results::Measure& m : results::all_measures()) known.push_back(m.name);
  const std::string near = cases::nearest_name(name, known);
  throw InputError(Fault{
      "describe",
      "neither the catalogue nor the keys of a case file nor the quantities of a result have '" +
          name + "'",
      near.empty() ? "see 'mahlwerk list', 'mahlwerk list keys' and 'mahlwerk list quantities'"
                   : "did you mean '" + near + "'?",
      "unknown-name"});
}

/// What `list` and `describe` are given.
struct CatalogueArguments {
  std::string name;
  bool json = false;
};

/// Whether a value of an entry has a weak source.
bool is_weak(const cases::CatalogueEntry& entry) {
  return std::any_of(entry.values.begin(), entry.values.end(),
                     [](const auto& v) { return v.second.unverified || v.second.assumed; }) ||
         std::ranges::any_of(entry.parts, [](const cases::CataloguePart& part) {
           return part.unverified || part.assumed;
         });
}

int list(const CatalogueArguments& given) {
  if (given.name == "keys") {
    given.json ? json_to_stdout(keys_as_json(all_sections()))
               : to_stdout(key_index() +
                           "\nmahlwerk describe NAME shows the keys of a section or kind.\n");
    return success;
  }
  if (given.name == "units") {
    given.json ? json_to_stdout(units_as_json()) : to_stdout(unit_table());
    return success;
  }
  if (given.name == "quantities") {
    given.json ? json_to_stdout(results::quantity_list())
               : to_stdout(results::quantity_index() +
                           "\nmahlwerk describe NAME says what a quantity is.\n");
    return success;
  }
  const cases::Catalogue all = catalogue();
  Json json = Json::array();
  for (const std::string& category : requested_categories(given.name)) {
    if (!given.json) fmt::print("{}\n", category);
    for (const std::string& name : all.names(category)) {
      const cases::CatalogueEntry entry = all.find(category, name);
      const bool weak = is_weak(entry);
      if (given.json)
        json.push_back(Json::object(
            {{"room", category}, {"name", name}, {"title", entry.title}, {"unverified", weak}}));
      else
        to_stdout(fmt::format("  {:<26} {}{}\n", name, entry.title,
                              weak ? "  (contains unverified values)" : ""));
    }
  }
  if (given.json)
    json_to_stdout(json);
  else
    fmt::print("\nmahlwerk describe NAME shows every value with its unit and source.\n");
  return success;
}

/// Mark of a value whose source is weak.
std::string_view confidence(const cases::CatalogueValue& value) {
  if (value.assumed) return "ASSUMED: ";
  if (!value.range[0].empty()) return "measured: ";
  return value.unverified ? "UNVERIFIED: " : "";
}

/// The keys of a part of a mill, its name first, and their source.
std::string part_lines(const cases::CataloguePart& part) {
  std::string name, others;
  for (const auto& [key, value] : part.keys)
    if (key == "name")
      name = value;
    else
      others += fmt::format(", {} = {}", key, value);
  return fmt::format("  [[parts]] name = {}{}\n      {}{}\n", name, others,
                     part.assumed      ? "ASSUMED: "
                     : part.unverified ? "UNVERIFIED: "
                                       : "",
                     part.source);
}

void print(const cases::CatalogueEntry& entry) {
  to_stdout(fmt::format("{}  ({}/{})\n", entry.title, entry.category, entry.name));
  if (!entry.kind.empty()) to_stdout(fmt::format("kind: {}\n", entry.kind));
  to_stdout(fmt::format("{}\n\n", entry.about));
  for (const auto& [key, value] : entry.values)
    to_stdout(fmt::format(
        "  {:<20} {:<14} {}{}{}\n", key, value.text, confidence(value),
        value.range[0].empty() ? "" : fmt::format("{} to {}; ", value.range[0], value.range[1]),
        value.source));
  for (const cases::CataloguePart& part : entry.parts) to_stdout(part_lines(part));
  if (!entry.names.empty())
    to_stdout(fmt::format("\nother names: {}\n", fmt::join(entry.names, ", ")));
  if (!entry.jars.empty()) to_stdout(fmt::format("\njars: {}\n", fmt::join(entry.jars, ", ")));
  for (const auto& check : entry.checks)
    to_stdout(fmt::format("\ncheck: {} = {:.4g}, expected {:.4g} within {:.2g} % ({})\n",
                          check.quantity, cases::derived(entry, check.quantity), check.expected,
                          100 * check.tolerance, check.source));
}

/// The keys of the sections and kinds; with `word` = "mill.speed" of this key alone.
void print(const KeySections& sections, const std::string& word) {
  const bool whole = std::ranges::none_of(
      cases::all_keys(), [&](const cases::KeyInfo& key) { return key.key == word; });
  std::string page;
  for (const cases::KeySection* s : sections)
    page += (page.empty() ? "" : "\n") + key_tables(*s, whole ? "" : word);
  to_stdout(page);
  if (!whole) return;
  for (const cases::KeySection* s : sections) {
    if (!s->kind.empty())
      to_stdout(fmt::format("\nKeys of every kind of [{0}]: mahlwerk describe {0}\n", s->section));
    if (s->kind.empty() && !s->choice.empty())
      to_stdout("\nKeys of one kind: mahlwerk describe KIND\n");
  }
}

int describe(const CatalogueArguments& given) {
  const KeySections sections = sections_named(given.name);
  const std::vector<cases::CatalogueEntry> entries = entries_named(given.name);
  if (sections.empty() && entries.empty()) {
    if (const std::string words = results::quantity_in_words(given.name); !words.empty()) {
      given.json ? json_to_stdout(results::quantity_record(given.name)) : to_stdout(words);
      return success;
    }
    report_unknown(given.name);
  }
  if (given.json) {
    json_to_stdout(sections.empty() ? entry_json(entries.front()) : keys_as_json(sections));
    return success;
  }
  if (!sections.empty()) print(sections, given.name);
  for (const cases::CatalogueEntry& entry : entries) {
    if (!sections.empty())
      to_stdout(fmt::format("\nThe catalogue has this name, too ({}/{}):\n\n", entry.category,
                            entry.name));
    print(entry);
  }
  return success;
}

}  // namespace

Command list_command() {
  const auto given = std::make_shared<CatalogueArguments>();
  return {
      "list",
      "list the contents of the catalogue: mills, jars, materials or media; the keys or the units "
      "of a case file; or the quantities of a result",
      {{.name = "CATEGORY",
        .target = &given->name,
        .about = "mills, jars, materials or media (default: all four), keys, units or quantities",
        .completions = "mills jars materials media keys units quantities"},
       json(given->json)},
      [given] { return list(*given); }};
}

Command describe_command() {
  const auto given = std::make_shared<CatalogueArguments>();
  return {
      "describe",
      "show one catalogue entry with all values and sources, the keys of a section, a kind or a "
      "model of case files, or a quantity of results",
      {{.name = "NAME",
        .target = &given->name,
        .about = "a name from 'mahlwerk list', or a section, a kind or a key from 'mahlwerk "
                 "list keys'",
        .required = true,
        .completions = "$(\"${COMP_WORDS[0]}\" list 2>/dev/null | awk '/^  / {print $1}')",
        .more_completions = section_words},
       json(given->json)},
      [given] { return describe(*given); }};
}

}  // namespace mahlwerk::commands

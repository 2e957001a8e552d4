// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// list and describe: contents of the catalogue, and the keys and units of a case file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/reference/catalogue_json.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/quantity_list.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::commands {
namespace {

/// What `list` lists besides the categories of the catalogue.
constexpr std::string_view indices[] = {"keys", "units", "quantities"};

using results::Json;

std::vector<std::string> requested_categories(const std::string& target) {
  const auto& all = cases::Catalogue::categories;
  if (target.empty()) return {std::begin(all), std::end(all)};
  if (std::find(std::begin(all), std::end(all), target) != std::end(all)) return {target};
  std::vector<std::string> lists(std::begin(all), std::end(all));
  lists.insert(lists.end(), std::begin(indices), std::end(indices));
  const std::string near = nearest_word(target, lists);
  throw InputError(Fault{"list", "there is no category '" + target + "' in the catalogue",
                         (near.empty() ? "" : "did you mean '" + near + "'? ") +
                             fmt::format("use one of {}", fmt::join(lists, ", ")),
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
  std::string name, word;
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

[[noreturn]] void report_no_match(const CatalogueArguments& given) {
  throw InputError(Fault{fmt::format("list {} {}", given.name, given.word),
                         fmt::format("nothing there has the word '{}'", given.word),
                         fmt::format("mahlwerk list {} lists all", given.name), "unknown-name"});
}

/// The keys that have the word in their name or their meaning, one a line.
std::string keys_with(std::string_view word) {
  std::string text;
  for (const cases::KeySection* s : all_sections())
    for (const cases::KeyInfo& key : s->keys)
      if (contains_word(key.key + '\n' + key.about, word))
        text += fmt::format("  {:<34} {:<8} {}{}\n", key.key, key.unit.empty() ? "-" : key.unit,
                            key_meaning(key, true),
                            s->kind.empty() ? "" : fmt::format(" ({})", s->kind));
  return text;
}

/// keys, units and quantities; empty if the category is none of them.
std::string index_of(const CatalogueArguments& given) {
  if (given.name == "keys")
    return (given.word.empty() ? key_index() : keys_with(given.word)) +
           "\nmahlwerk describe NAME shows the keys of a section or kind.\n";
  if (given.name == "units") return unit_table();
  if (given.name == "quantities")
    return results::quantity_index(given.word) +
           "\nmahlwerk describe NAME says what a quantity is.\n";
  return "";
}

/// The same as JSON, always whole; null if the category is none of them.
Json index_as_json(const std::string& category) {
  if (category == "keys") return keys_as_json(all_sections());
  if (category == "units") return units_as_json();
  return category == "quantities" ? results::quantity_list() : Json();
}

/// The words by which a list finds an entry: its names, and for a mill or a jar its kind.
std::string searched_words(const cases::CatalogueEntry& entry) {
  return fmt::format("{}\n{}\n{}\n{}", entry.name, entry.title, entry.kind,
                     fmt::join(entry.names, "\n"));
}

int list_catalogue(const CatalogueArguments& given) {
  const cases::Catalogue all = catalogue();
  Json json = Json::array();
  bool found = false;
  for (const std::string& category : requested_categories(given.name)) {
    std::string text;
    for (const std::string& name : all.names(category)) {
      const cases::CatalogueEntry entry = all.find(category, name);
      if (!contains_word(searched_words(entry), given.word)) continue;
      const bool weak = is_weak(entry);
      json.push_back(Json::object(
          {{"room", category}, {"name", name}, {"title", entry.title}, {"unverified", weak}}));
      text += fmt::format("  {:<26} {}{}\n", name, entry.title,
                          weak ? "  (contains unverified values)" : "");
    }
    found = found || !text.empty();
    if (!given.json && !text.empty()) to_stdout(fmt::format("{}\n{}", category, text));
  }
  if (!found) report_no_match(given);
  if (given.json)
    json_to_stdout(json);
  else
    fmt::print("\nmahlwerk describe NAME shows every value with its unit and source.\n");
  return success;
}

int list(const CatalogueArguments& given) {
  const std::string index = index_of(given);
  if (index.empty()) return list_catalogue(given);
  if (!given.word.empty() && (given.json || given.name == "units"))
    throw InputError(
        Fault{fmt::format("list {}", given.name), "this list is not searched for a word",
              "leave out " + given.word + (given.json ? ", or --json" : ""), "bad-command-line"});
  if (index.starts_with("\n")) report_no_match(given);
  given.json ? json_to_stdout(index_as_json(given.name)) : to_stdout(index);
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
  title_to_stdout(fmt::format("{}  ({}/{})", entry.title, entry.category, entry.name));
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
  for (const auto& check : entry.checks) {
    const double found = cases::derived(entry, check.quantity);
    const bool agrees =
        std::abs(found - check.expected) <= check.tolerance * std::abs(check.expected);
    to_stdout(fmt::format("\ncheck: {} = {:.4g}, expected {:.4g} within {:.2g} % ({}){}\n",
                          check.quantity, found, check.expected, 100 * check.tolerance,
                          check.source, agrees ? "" : ": DOES NOT AGREE"));
  }
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
        .completions = fmt::format("{} {}", fmt::join(cases::Catalogue::categories, " "),
                                   fmt::join(indices, " "))},
       {.name = "WORD",
        .target = &given->word,
        .about =
            "only what has this word in its name or description: mahlwerk list quantities power",
        .completions = " "},
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

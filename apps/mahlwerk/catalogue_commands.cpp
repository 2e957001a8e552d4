// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// list and describe: contents of the catalogue.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "command.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/json_value.hpp"
#include "output.hpp"

namespace mahlwerk::app {
namespace {

using results::Json;

std::vector<std::string> requested_categories(const std::string& target) {
  const auto& all = cases::Catalogue::categories;
  if (target.empty()) return {std::begin(all), std::end(all)};
  if (std::find(std::begin(all), std::end(all), target) != std::end(all)) return {target};
  throw InputError(Fault{"list", "there is no category '" + target + "' in the catalogue",
                         "use one of mills, jars, materials, media", "unknown-name"});
}

cases::CatalogueEntry entry_named(const std::string& name) {
  const cases::Catalogue all = catalogue();
  std::vector<std::string> known;
  for (const std::string_view category : cases::Catalogue::categories)
    for (const std::string& one : all.names(category)) {
      if (one == name) return all.find(category, name);
      known.push_back(one);
    }
  const std::string near = cases::nearest_name(name, known);
  throw InputError(Fault{"describe", "the catalogue has no '" + name + "'",
                         near.empty() ? "see 'mahlwerk list'" : "did you mean '" + near + "'?",
                         "unknown-name"});
}

Json as_json(const cases::CatalogueEntry& entry) {
  Json values;
  for (const auto& [key, value] : entry.values)
    values[key] = Json::object(
        {{"value", value.text}, {"source", value.source}, {"unverified", value.unverified}});
  Json made =
      Json::object({{"room", entry.category}, {"name", entry.name}, {"title", entry.title}});
  if (!entry.kind.empty()) made["kind"] = entry.kind;
  made["about"] = entry.about;
  made["values"] = values;
  if (!entry.jars.empty()) made["jars"] = entry.jars;
  return made;
}

int list(const Request& request) {
  const cases::Catalogue all = catalogue();
  Json json = Json::array();
  for (const std::string& category : requested_categories(request.target)) {
    if (!request.json) fmt::print("{}\n", category);
    for (const std::string& name : all.names(category)) {
      const cases::CatalogueEntry entry = all.find(category, name);
      const bool weak = std::any_of(entry.values.begin(), entry.values.end(),
                                    [](const auto& v) { return v.second.unverified; });
      if (request.json)
        json.push_back(Json::object(
            {{"room", category}, {"name", name}, {"title", entry.title}, {"unverified", weak}}));
      else
        to_stdout(fmt::format("  {:<26} {}{}\n", name, entry.title,
                              weak ? "  (contains unverified values)" : ""));
    }
  }
  if (request.json)
    json_to_stdout(json);
  else
    fmt::print("\nmahlwerk describe NAME shows every value with its unit and source.\n");
  return success;
}

int describe(const Request& request) {
  const cases::CatalogueEntry entry = entry_named(request.target);
  if (request.json) {
    json_to_stdout(as_json(entry));
    return success;
  }
  to_stdout(fmt::format("{}  ({}/{})\n", entry.title, entry.category, entry.name));
  if (!entry.kind.empty()) to_stdout(fmt::format("kind: {}\n", entry.kind));
  to_stdout(fmt::format("{}\n\n", entry.about));
  for (const auto& [key, value] : entry.values)
    to_stdout(fmt::format("  {:<20} {:<14} {}{}\n", key, value.text,
                          value.unverified ? "UNVERIFIED: " : "", value.source));
  if (!entry.jars.empty()) to_stdout(fmt::format("\njars: {}\n", fmt::join(entry.jars, ", ")));
  for (const auto& check : entry.checks)
    to_stdout(fmt::format("\ncheck: {} = {:.4g}, expected {:.4g} within {:.2g} % ({})\n",
                          check.quantity, cases::derived(entry, check.quantity), check.expected,
                          100 * check.tolerance, check.source));
  return success;
}

}  // namespace

Command list_command() {
  return {"list",
          "list the contents of the catalogue: mills, jars, materials or media",
          {{.name = "CATEGORY",
            .target = &Request::target,
            .about = "mills, jars, materials or media (default: all)",
            .completions = "mills jars materials media"},
           json()},
          list};
}

Command describe_command() {
  return {"describe",
          "show one catalogue entry: all values with units and sources",
          {{.name = "NAME",
            .target = &Request::target,
            .about = "a name from 'mahlwerk list'",
            .required = true,
            .completions = "$(\"${COMP_WORDS[0]}\" list 2>/dev/null | awk '/^  / {print $1}')"},
           json()},
          describe};
}

}  // namespace mahlwerk::app

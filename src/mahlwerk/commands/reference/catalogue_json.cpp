// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/catalogue_json.hpp"

namespace mahlwerk::commands {

results::Json entry_json(const cases::CatalogueEntry& entry) {
  results::Json values;
  for (const auto& [key, value] : entry.values) {
    results::Json& one = values[key];
    one = results::Json::object({{"value", value.text},
                                 {"source", value.source},
                                 {"unverified", value.unverified},
                                 {"assumed", value.assumed}});
    if (value.range[0].empty()) continue;
    one["from"] = value.range[0];
    one["to"] = value.range[1];
  }
  results::Json made = results::Json::object(
      {{"room", entry.category}, {"name", entry.name}, {"title", entry.title}});
  if (!entry.kind.empty()) made["kind"] = entry.kind;
  if (!entry.names.empty()) made["names"] = entry.names;
  made["about"] = entry.about;
  made["values"] = values;
  if (!entry.jars.empty()) made["jars"] = entry.jars;
  if (entry.parts.empty()) return made;
  results::Json parts = results::Json::array();
  for (const cases::CataloguePart& part : entry.parts) {
    results::Json one = results::Json::object(
        {{"source", part.source}, {"unverified", part.unverified}, {"assumed", part.assumed}});
    for (const auto& [key, value] : part.keys) one[key] = value;
    parts.push_back(one);
  }
  made["parts"] = parts;
  return made;
}

}  // namespace mahlwerk::commands

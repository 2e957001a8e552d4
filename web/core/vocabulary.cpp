// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "vocabulary.hpp"

#include <string>
#include <utility>

#include "key_pages.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "session.hpp"

namespace mahlwerk::web {
namespace {

using results::Json;

Json entry_json(const cases::CatalogueEntry& entry) {
  Json values = Json::object();
  for (const auto& [key, value] : entry.values)
    values[key] = Json::object(
        {{"value", value.text}, {"source", value.source}, {"unverified", value.unverified}});
  return Json::object({{"name", entry.name},
                       {"title", entry.title},
                       {"kind", entry.kind},
                       {"about", entry.about},
                       {"jars", entry.jars},
                       {"values", std::move(values)}});
}

}  // namespace

Json vocabulary() {
  const cases::Catalogue& known = catalogue();
  Json entries = Json::object();
  for (const std::string_view category : cases::Catalogue::categories) {
    Json list = Json::array();
    for (const std::string& name : known.names(category))
      list.push_back(entry_json(known.find(category, name)));
    entries[category] = std::move(list);
  }
  return Json::object(
      {{"keys", app::keys_as_json(app::all_sections())}, {"catalogue", std::move(entries)}});
}

}  // namespace mahlwerk::web

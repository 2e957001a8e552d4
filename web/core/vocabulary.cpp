// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "vocabulary.hpp"

#include <string>
#include <utility>

#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/commands/reference/catalogue_json.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "session.hpp"

namespace mahlwerk::web {

results::Json vocabulary() {
  const cases::Catalogue& known = catalogue();
  results::Json entries = results::Json::object();
  for (const std::string_view category : cases::Catalogue::categories) {
    results::Json list = results::Json::array();
    for (const std::string& name : known.names(category))
      list.push_back(commands::entry_json(known.find(category, name)));
    entries[category] = std::move(list);
  }
  return results::Json::object({{"keys", commands::keys_as_json(commands::all_sections())},
                                {"units", commands::units_as_json()},
                                {"catalogue", std::move(entries)}});
}

}  // namespace mahlwerk::web

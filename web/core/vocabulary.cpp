// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "vocabulary.hpp"

#include <string>
#include <utility>

#include "catalogue_json.hpp"
#include "key_pages.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "session.hpp"
#include "unit_pages.hpp"

namespace mahlwerk::web {

results::Json vocabulary() {
  const cases::Catalogue& known = catalogue();
  results::Json entries = results::Json::object();
  for (const std::string_view category : cases::Catalogue::categories) {
    results::Json list = results::Json::array();
    for (const std::string& name : known.names(category))
      list.push_back(app::entry_json(known.find(category, name)));
    entries[category] = std::move(list);
  }
  return results::Json::object({{"keys", app::keys_as_json(app::all_sections())},
                                {"units", app::units_as_json()},
                                {"catalogue", std::move(entries)}});
}

}  // namespace mahlwerk::web

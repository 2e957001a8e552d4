// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/unit_pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/unit_table.hpp"

namespace mahlwerk::commands {

std::string unit_table() {
  const auto units = listed_units();
  std::vector<std::string_view> dimensions;  // by their SI units
  for (const ListedUnit& u : units)
    if (std::ranges::find(dimensions, u.si) == dimensions.end()) dimensions.push_back(u.si);
  std::string page;
  for (const std::string_view si : dimensions) {
    page += fmt::format("{:<8}", si.empty() ? "number" : si);
    for (const ListedUnit& u : units)
      if (u.si == si && !u.symbol.empty()) page += fmt::format(" {}", u.symbol);
    page += '\n';
  }
  return page +
         "\nUnits multiply and divide: kg/m3, J/(kg K), kWh/t. \"200 mesh\" is the opening of that "
         "test sieve of ASTM E11.\n";
}

results::Json units_as_json() {
  results::Json all = results::Json::array();
  for (const ListedUnit& u : listed_units())
    all.push_back(results::Json::object({{"unit", std::string(u.symbol)},
                                         {"si", std::string(u.si)},
                                         {"factor", u.factor},
                                         {"offset", u.offset},
                                         {"offered", u.offered}}));
  return all;
}

}  // namespace mahlwerk::commands

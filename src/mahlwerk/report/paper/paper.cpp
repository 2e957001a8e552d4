// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/paper.hpp"

#include <algorithm>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::report {

double Measurement::Value::in(std::string_view unit) const {
  return parse_in(text, unit == "1" ? "" : unit);
}

double Measurement::Value::error_in(std::string_view unit) const {
  return parse_in(error_text, unit == "1" ? "" : unit);
}

const Measurement* Paper::measurement(std::string_view name) const {
  const auto found = std::ranges::find(measured, name, &Measurement::name);
  return found == measured.end() ? nullptr : &*found;
}

std::vector<std::string> Paper::campaigns() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const PaperFigure& figure : figures) add(figure.campaign);
  for (const Claim& claim : claims) add(claim.campaign);
  for (const PaperTable& table : tables) add(table.campaign);
  return names;
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/axis_labels.hpp"

#include <fmt/format.h>

#include "mahlwerk/cases/keys.hpp"

namespace mahlwerk::report {
namespace {

std::string axis_text(std::string words, std::string_view symbol, std::string_view unit) {
  if (!symbol.empty()) words += fmt::format(", {}", symbol);
  return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

}  // namespace

std::string symbol_of_quantity(std::string_view quantity) {
  return std::string(results::traits_of(quantity).symbol);
}

std::string symbol_of_key(std::string_view key) {
  const cases::KeyInfo* known = cases::find_key(key);
  return known == nullptr ? "" : known->symbol;
}

std::string quantity_axis(std::string_view quantity, const Multiple& m) {
  std::string unit = m.unit == "1" ? "–" : m.unit == "deg" ? "°" : m.unit == "degC" ? "°C" : m.unit;
  if (unit == "m2/kg") unit = "m²/kg";
  return axis_text(label(quantity), symbol_of_quantity(quantity), unit);
}

std::string key_axis(std::string_view key, std::string_view unit) {
  const cases::KeyInfo* known = cases::find_key(key);
  if (known == nullptr) return axis_text(std::string(key), "", unit);
  const bool number = known->type == "number" || known->type == "integer";
  const std::string_view none = number && known->unit.empty() ? "–" : "";
  return axis_text(known->label, known->symbol, unit.empty() ? none : unit);
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/ucum.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "mahlwerk/base/unit_table.hpp"

namespace mahlwerk::report {
namespace {

/// Simple units that UCUM writes otherwise.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> other_codes{
    {{"rpm", "{rev}/min"},
     {"turn", "{turn}"},
     {"degC", "Cel"},
     {"l", "L"},
     {"ml", "mL"},
     {"ul", "uL"},
     {"cc", "cm3"},
     {"in", "[in_i]"},
     {"ft", "[ft_i]"},
     {"lb", "[lb_av]"},
     {"Wh", "(W.h)"},
     {"kWh", "(kW.h)"},
     {"MWh", "(MW.h)"}}};

std::string simple_code(std::string_view symbol) {
  const auto found =
      std::ranges::find(other_codes, symbol, &std::pair<std::string_view, std::string_view>::first);
  return std::string(found == other_codes.end() ? symbol : found->second);
}

bool is_known(std::string_view unit) {
  if (unit == "degC") return true;
  try {
    parse_unit(unit);
    return true;
  } catch (const UnitError&) {
    return false;
  }
}

/// Takes the next simple unit from the front, without its exponent.
std::string_view taken_symbol(std::string_view& rest) {
  const auto end = std::ranges::find_if(rest, [](char c) {
    return c == ' ' || c == '/' || c == '(' || c == ')' || c == '-' ||
           std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
  const std::string_view symbol = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  rest.remove_prefix(symbol.size());
  return symbol;
}

}  // namespace

std::string ucum(std::string_view unit) {
  if (unit.empty() || unit == "1") return "1";
  if (!is_known(unit)) return "";
  std::string code;
  char between = '.';     // before the next factor
  bool in_group = false;  // inside the parentheses of a denominator
  if (unit.starts_with("1/")) unit.remove_prefix(1);
  while (!unit.empty()) {
    const char c = unit.front();
    if (const std::string_view symbol = taken_symbol(unit); !symbol.empty()) {
      if (!code.empty() || between == '/') code += between;
      code += simple_code(symbol);
      between = in_group ? '/' : '.';
      continue;
    }
    unit.remove_prefix(1);
    if (c == '/') between = '/';
    if (c == '(' || c == ')') in_group = c == '(';
    if (c == ')') between = '.';
    if (c == '-' || std::isdigit(static_cast<unsigned char>(c)) != 0) code += c;
  }
  return code;
}

}  // namespace mahlwerk::report

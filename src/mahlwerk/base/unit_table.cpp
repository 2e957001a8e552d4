// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/unit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

namespace mahlwerk {
namespace {

constexpr Dimension number{}, length{.length = 1}, mass{.mass = 1}, time{.time = 1},
    temperature{.temperature = 1}, angle{.angle = 1}, cycles{.time = -1, .angle = 1},
    volume{.length = 3}, force{.length = 1, .mass = 1, .time = -2},
    pressure{.length = -1, .mass = 1, .time = -2}, viscosity{.length = -1, .mass = 1, .time = -1},
    energy{.length = 2, .mass = 1, .time = -2}, power{.length = 2, .mass = 1, .time = -3},
    amount{.amount = 1};

constexpr Unit table[] = {
    {"%", {1, 100}, number},
    {"m", {}, length},
    {"mm", {1, 1e3}, length},
    {"cm", {1, 1e2}, length},
    {"dm", {1, 10}, length},
    {"um", {1, 1e6}, length},
    {"nm", {1, 1e9}, length},
    {"km", {1e3}, length},
    {"in", {127, 5000}, length},
    {"ft", {381, 1250}, length},
    {"kg", {}, mass},
    {"g", {1, 1e3}, mass},
    {"mg", {1, 1e6}, mass},
    {"ug", {1, 1e9}, mass},
    {"t", {1e3}, mass},
    {"lb", {45359237, 1e8}, mass},
    {"s", {}, time},
    {"ms", {1, 1e3}, time},
    {"us", {1, 1e6}, time},
    {"ns", {1, 1e9}, time},
    {"min", {60}, time},
    {"h", {3600}, time},
    {"d", {86400}, time},
    {"Hz", {1, 1, 1}, cycles},
    {"mHz", {1, 1e3, 1}, cycles},
    {"kHz", {1e3, 1, 1}, cycles},
    {"rpm", {1, 60, 1}, cycles},
    {"rad", {}, angle},
    {"deg", {1, 360, 1}, angle},
    {"turn", {1, 1, 1}, angle},
    {"l", {1, 1e3}, volume},
    {"ml", {1, 1e6}, volume},
    {"ul", {1, 1e9}, volume},
    {"L", {1, 1e3}, volume},
    {"mL", {1, 1e6}, volume},
    {"uL", {1, 1e9}, volume},
    {"cc", {1, 1e6}, volume},
    {"N", {}, force},
    {"mN", {1, 1e3}, force},
    {"kN", {1e3}, force},
    {"Pa", {}, pressure},
    {"mPa", {1, 1e3}, pressure},
    {"kPa", {1e3}, pressure},
    {"MPa", {1e6}, pressure},
    {"GPa", {1e9}, pressure},
    {"bar", {1e5}, pressure},
    {"mbar", {100}, pressure},
    {"atm", {101325}, pressure},
    {"P", {1, 10}, viscosity},
    {"cP", {1, 1e3}, viscosity},
    {"J", {}, energy},
    {"mJ", {1, 1e3}, energy},
    {"uJ", {1, 1e6}, energy},
    {"nJ", {1, 1e9}, energy},
    {"kJ", {1e3}, energy},
    {"MJ", {1e6}, energy},
    {"GJ", {1e9}, energy},
    {"Wh", {3600}, energy},
    {"kWh", {3600000}, energy},
    {"MWh", {3600000000}, energy},
    {"cal", {523, 125}, energy},
    {"kcal", {4184}, energy},
    {"W", {}, power},
    {"mW", {1, 1e3}, power},
    {"uW", {1, 1e6}, power},
    {"kW", {1e3}, power},
    {"MW", {1e6}, power},
    {"GW", {1e9}, power},
    {"K", {}, temperature},
    {"mol", {}, amount},
    {"mmol", {1, 1e3}, amount},
};

/// Multiples that show a value, and the units that a menu offers: those, unless it has its own
/// list. Unused entries are empty.
struct DisplayUnits {
  std::string_view unit;
  std::array<std::string_view, 5> as, menu = {};
};

constexpr DisplayUnits display_table[] = {
    {"m", {"mm", "m", "um", "nm", "km"}, {"m", "cm", "mm", "um"}},
    {"kg", {"g", "kg", "mg", "ug"}, {"kg", "g", "mg"}},
    {"s", {"s", "ms", "us", "ns"}, {"s", "ms", "us", "min", "h"}},
    {"rad/s", {"rad/s", "rpm"}},
    {"Hz", {"Hz", "kHz", "mHz"}, {"Hz", "rpm"}},
    {"rad", {"deg", "rad"}},
    {"m/s", {"m/s", "mm/s"}},
    {"m3", {"ml", "l", "m3", "ul"}, {"m3", "l", "ml"}},
    {"N", {"N", "kN", "mN"}},
    {"Pa", {"GPa", "MPa", "kPa", "Pa"}, {"Pa", "MPa", "GPa"}},
    {"Pa s", {"mPa s", "Pa s"}},
    {"J", {"J", "mJ", "uJ", "nJ", "kJ"}},
    {"W", {"W", "mW", "uW", "kW"}},
    {"J/kg", {"J/kg", "kJ/kg", "kJ/g"}},
    {"kg/m2", {"kg/m2", "g/m2"}},
    {"kg/m3", {}, {"kg/m3", "g/cm3"}},
    {"", {}, {"%"}},
};

/// SI unit of a dimension, of those that values have in this table.
std::string_view si_unit(const Dimension& dimension) {
  for (const DisplayUnits& s : display_table)
    if (parse_unit(s.unit).dimension == dimension) return s.unit;
  for (const Unit& u : table)
    if (u.dimension == dimension && u.scale.numerator == u.scale.denominator) return u.symbol;
  return {};
}

/// Value of one unit of this scale in SI units.
double factor_of(const Scale& scale) {
  constexpr double turn = 2 * std::numbers::pi;
  double factor = scale.numerator / scale.denominator;
  for (int i = 0; i < scale.turns; ++i) factor *= turn;
  return factor;
}

bool is_offered(std::string_view symbol) {
  return std::ranges::any_of(display_table, [&](const DisplayUnits& s) {
    const auto& menu = s.menu.front().empty() ? s.as : s.menu;
    return std::ranges::find(menu, symbol) != menu.end();
  });
}

/// Openings of ASTM E11-20, table 1, which are those of ISO 565 (R 20/3 and R 40/3).
struct Sieve {
  double number, micrometres;
};
constexpr Sieve sieves[] = {
    {3.5, 5600}, {4, 4750},  {5, 4000},  {6, 3350},  {7, 2800}, {8, 2360}, {10, 2000},
    {12, 1700},  {14, 1400}, {16, 1180}, {18, 1000}, {20, 850}, {25, 710}, {30, 600},
    {35, 500},   {40, 425},  {45, 355},  {50, 300},  {60, 250}, {70, 212}, {80, 180},
    {100, 150},  {120, 125}, {140, 106}, {170, 90},  {200, 75}, {230, 63}, {270, 53},
    {325, 45},   {400, 38},  {450, 32},  {500, 25},  {635, 20},
};

}  // namespace

std::span<const Unit> all_units() {
  return table;
}

std::span<const std::string_view> display_units(std::string_view unit) {
  for (const DisplayUnits& s : display_table) {
    if (s.unit != unit) continue;
    std::size_t n = 0;
    while (n < s.as.size() && !s.as[n].empty()) ++n;
    return {s.as.data(), n};
  }
  return {};
}

std::vector<ListedUnit> listed_units() {
  std::vector<ListedUnit> list;
  const auto add = [&](std::string_view symbol) {
    if (std::ranges::find(list, symbol, &ListedUnit::symbol) != list.end()) return;
    const ParsedUnit parsed = parse_unit(symbol);
    list.push_back({symbol, si_unit(parsed.dimension), factor_of(parsed.scale), 0,
                    is_offered(symbol) || symbol.empty()});
  };
  for (const Unit& u : table) add(u.symbol);
  for (const DisplayUnits& s : display_table) {
    add(s.unit);
    for (const std::string_view symbol : s.as)
      if (!symbol.empty()) add(symbol);
    for (const std::string_view symbol : s.menu)
      if (!symbol.empty()) add(symbol);
  }
  constexpr double ice_point = 273.15;  // [K]
  list.push_back({"degC", "K", 1, ice_point, true});
  std::ranges::find(list, "K", &ListedUnit::symbol)->offered = true;
  return list;
}

std::optional<double> mesh_opening(double mesh) {
  const auto at = std::ranges::find(sieves, mesh, [](const Sieve& s) { return s.number; });
  if (at == std::end(sieves)) return std::nullopt;
  return at->micrometres / 1e6;
}

std::string nearest_meshes(double mesh) {
  std::string text;
  const auto above = std::ranges::find_if(sieves, [&](const Sieve& s) { return s.number > mesh; });
  if (above != std::begin(sieves)) text += fmt::format("{} mesh", std::prev(above)->number);
  if (above != std::end(sieves))
    text += fmt::format("{}{} mesh", text.empty() ? "" : ", ", above->number);
  return text;
}

}  // namespace mahlwerk

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/unit_table.hpp"

#include <array>

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
    {"K", {}, temperature},
    {"mol", {}, amount},
    {"mmol", {1, 1e3}, amount},
};

struct DisplayUnits {
  std::string_view unit;
  std::array<std::string_view, 5> as;  // unused entries are empty
};

constexpr DisplayUnits display_table[] = {
    {"m", {"mm", "m", "um", "nm", "km"}},
    {"kg", {"g", "kg", "mg", "ug"}},
    {"s", {"s", "ms", "us", "ns"}},
    {"Hz", {"Hz", "kHz", "mHz"}},
    {"rad/s", {"rad/s", "rpm"}},
    {"rad", {"deg", "rad"}},
    {"m/s", {"m/s", "mm/s"}},
    {"m3", {"ml", "l", "m3", "ul"}},
    {"N", {"N", "kN", "mN"}},
    {"Pa", {"GPa", "MPa", "kPa", "Pa"}},
    {"Pa s", {"mPa s", "Pa s"}},
    {"J", {"J", "mJ", "uJ", "nJ", "kJ"}},
    {"W", {"W", "mW", "uW", "kW"}},
    {"J/kg", {"J/kg", "kJ/kg", "kJ/g"}},
    {"kg/m2", {"kg/m2", "g/m2"}},
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

}  // namespace mahlwerk

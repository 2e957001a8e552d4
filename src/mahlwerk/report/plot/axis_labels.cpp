// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/axis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mahlwerk/cases/keys.hpp"

namespace mahlwerk::report {
namespace {

struct Named {
  std::string_view name, words, symbol;
  std::string_view unit = "";  // of values without unit
};

/// Quantities with a symbol; without words, label() names them.
constexpr std::array quantities{
    Named{"collision_rate", "", "$n$"},
    Named{"energy_normal_mean", "", "$E_{n}$"},
    Named{"energy_tangential_mean", "", "$E_{t}$"},
    Named{"energy_contact_point_mean", "", "$E_{c}$"},
    Named{"energy_centre_mean", "", "$E_{m}$"},
    Named{"energy_lost_mean", "", "$E_{l}$"},
    Named{"stress_energy", "", "$E$"},
    Named{"dissipated_power", "", "$P$"},
    Named{"drawn_power", "", "$P$"},
    Named{"shaft_torque", "", "$M$"},
    Named{"rotor_torque", "torque of the rotor", "$M$"},
    Named{"power_number", "power number", "$N_{p}$"},
    Named{"drum_speed", "speed of the drum", "$n$"},
    Named{"bulk_filling", "bulk filling of balls", "$J$"},
    Named{"void_filling", "powder filling of the voids", "$U$"},
    Named{"impact_efficiency", "", "$η$"},
    Named{"flight_share", "share of time in flight", "$φ$"},
    Named{"ball_speed_seen_from_carrier", "ball speed in the frame of the carrier", "$v$"},
    Named{"ball_spin", "angular velocity of the balls", "$ω$"},
    Named{"ball_speed_seen_from_jar", "ball speed in the frame of the jar", "$v$"},
    Named{"impact_speed_normal_mean", "", "$u_{n}$"},
    Named{"impact_speed_tangential_mean", "", "$u_{t}$"},
    Named{"d10", "size with 10 % of the mass below", "$d_{10}$"},
    Named{"d50", "median size", "$d_{50}$"},
    Named{"d90", "size with 90 % of the mass below", "$d_{90}$"},
    Named{"specific_surface", "", "$S_{m}$"},
    Named{"conversion", "", "$X$"}};

template <class List>
Named entry(const List& list, std::string_view name) {
  const auto at = std::ranges::find(list, name, &Named::name);
  return at == list.end() ? Named{} : *at;
}

std::string_view without_threshold(std::string_view quantity) {
  constexpr std::string_view above = "_above_threshold";
  if (quantity.ends_with(above)) quantity.remove_suffix(above.size());
  return quantity;
}

std::string axis_text(std::string words, std::string_view symbol, std::string_view unit) {
  if (!symbol.empty()) words += fmt::format(", {}", symbol);
  return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

}  // namespace

std::string symbol_of_quantity(std::string_view quantity) {
  return std::string(entry(quantities, without_threshold(quantity)).symbol);
}

std::string symbol_of_key(std::string_view key) {
  const cases::KeyInfo* known = cases::find_key(key);
  return known == nullptr ? "" : known->symbol;
}

std::string quantity_axis(std::string_view quantity, const Multiple& m) {
  const Named known = entry(quantities, quantity);
  std::string unit = m.unit == "1" ? "–" : m.unit == "deg" ? "°" : m.unit == "degC" ? "°C" : m.unit;
  if (unit == "m2/kg") unit = "m²/kg";
  return axis_text(known.words.empty() ? label(quantity) : std::string(known.words),
                   symbol_of_quantity(quantity), unit);
}

std::string key_axis(std::string_view key, std::string_view unit) {
  const cases::KeyInfo* known = cases::find_key(key);
  if (known == nullptr) return axis_text(std::string(key), "", unit);
  const bool number = known->type == "number" || known->type == "integer";
  const std::string_view none = number && known->unit.empty() ? "–" : "";
  return axis_text(known->label, known->symbol, unit.empty() ? none : unit);
}

}  // namespace mahlwerk::report

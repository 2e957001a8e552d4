// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/axis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

/// Keys whose last word alone is ambiguous, or that have a symbol.
constexpr std::array keys{Named{"mill.frequency", "vibration frequency", "$f$"},
                          Named{"mill.amplitude", "vibration amplitude", "$A$"},
                          Named{"mill.speed", "speed of the mill", "$ω$"},
                          Named{"mill.ratio", "speed ratio", "$k$", "–"},
                          Named{"jar.diameter", "jar diameter", "$D$"},
                          Named{"balls.diameter", "ball diameter", "$d$"},
                          Named{"balls.count", "number of balls", "$N$", "–"},
                          Named{"balls.filling", "solid filling of balls", ""},
                          Named{"balls.bulk_filling", "bulk filling of balls", "$J$"},
                          Named{"powder.void_filling", "powder filling of the voids", "$U$"},
                          Named{"powder.filling", "powder filling", ""},
                          Named{"contact.friction", "friction coefficient", "$µ$", "–"},
                          Named{"contact.rolling_friction", "rolling friction", "$µ_{r}$", "–"},
                          Named{"contact.restitution", "coefficient of restitution", "$e$", "–"},
                          Named{"breakage.f_mat", "", "$f_{Mat}$"},
                          Named{"breakage.x_w_min", "", "$xW_{m,min}$"},
                          Named{"run.time", "simulated time", "$t$"},
                          Named{"grinding.time", "milling time", "$t$"}};

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
  return std::string(entry(keys, key).symbol);
}

std::string quantity_axis(std::string_view quantity, const Multiple& m) {
  const Named known = entry(quantities, quantity);
  std::string unit = m.unit == "1" ? "–" : m.unit == "deg" ? "°" : m.unit == "degC" ? "°C" : m.unit;
  if (unit == "m2/kg") unit = "m²/kg";
  return axis_text(known.words.empty() ? label(quantity) : std::string(known.words),
                   symbol_of_quantity(quantity), unit);
}

std::string key_axis(std::string_view key, std::string_view unit) {
  const Named known = entry(keys, key);
  std::string words(known.words);
  if (words.empty()) {
    words = key.substr(key.rfind('.') + 1);
    std::ranges::replace(words, '_', ' ');
  }
  return axis_text(std::move(words), known.symbol, unit.empty() ? known.unit : unit);
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/catalogue/catalogue_read.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double standard_gravity = 9.81;  // [m/s2] unit of manufacturers' g values
constexpr double pi = std::numbers::pi;

InputError missing(const CatalogueEntry& entry, std::string_view key) {
  return InputError(
      Fault{entry.file, fmt::format("{} '{}' gives no {}", entry.category, entry.name, key),
            fmt::format("add [{}] with a value and a source, or remove the check", key),
            "bad-catalogue-file"});
}

double number(const CatalogueEntry& entry, const std::string& key, std::string_view unit) {
  const auto value = entry.values.find(key);
  if (value == entry.values.end()) throw missing(entry, key);
  return parse_in(value->second.text, unit);
}

/// The value of the first of several keys that the entry gives.
double first_of(const CatalogueEntry& entry, std::initializer_list<std::string> keys,
                std::string_view unit) {
  for (const std::string& key : keys)
    if (entry.values.contains(key)) return number(entry, key, unit);
  throw missing(entry, *keys.begin());
}

struct Swing {
  double omega, amplitude;  // [rad/s], [m]
};

/// The fastest circle or oscillation of the jar's centre that a mill offers.
Swing fastest(const CatalogueEntry& e) {
  if (e.kind == "planetary" || e.kind == "circular")
    return {first_of(e, {"speed_most", "speed"}, "rad/s"),
            number(e, e.kind == "planetary" ? "orbit_radius" : "radius", "m")};
  return {2 * pi * first_of(e, {"frequency_most", "frequency"}, "Hz"),
          first_of(e, {"amplitude_most", "amplitude", "arc_amplitude"}, "m")};
}

double acceleration_number(const CatalogueEntry& e) {
  const Swing s = fastest(e);
  return s.omega * s.omega * s.amplitude / standard_gravity;
}

double peak_wall_speed(const CatalogueEntry& e) {
  const Swing s = fastest(e);
  return s.omega * s.amplitude;
}

/// The volume of a jar of kind `Shape`, else no value.
template <class Shape>
std::optional<double> volume_as(const CatalogueEntry& e) {
  if (e.kind != Shape::name) return std::nullopt;
  Shape shape;
  for (const auto& field : Shape::fields()) {
    const std::string key(field.key);
    const bool standard = field.standard && !e.values.contains(key);
    shape.*field.value = standard ? *field.standard : number(e, key, field.unit);
  }
  return shape.volume();
}

template <class... Shapes>
double volume_among(const CatalogueEntry& e, const std::variant<Shapes...>*) {
  std::optional<double> volume;
  ((volume = volume ? volume : volume_as<Shapes>(e)), ...);
  if (!volume) throw missing(e, "kind that is a jar's shape");
  return *volume;
}

double jar_volume(const CatalogueEntry& e) {
  return 1e6 * volume_among(e, static_cast<const geometry::FormulaShape*>(nullptr));  // m3 to ml
}

double shear_modulus(const CatalogueEntry& e) {
  return 1e-9 * number(e, "youngs_modulus", "Pa") / (2 * (1 + number(e, "poisson_ratio", "")));
}

double ball_mass(const CatalogueEntry& e) {
  const double d = number(e, "diameter", "m");
  return 1e3 * pi / 6 * d * d * d * number(e, "density", "kg/m3");  // kg to g
}

struct Row {
  CheckQuantity quantity;
  double (*value)(const CatalogueEntry&);
};

constexpr Row derived_rows[] = {
    {{"relative_centrifugal_acceleration", "",
      "largest acceleration of the jar's centre on its circle over 9.81 m/s2: the maker's g "
      "figure"},
     acceleration_number},
    {{"peak_acceleration_number", "",
      "largest acceleration of the swinging jar's centre over 9.81 m/s2"},
     acceleration_number},
    {{"peak_wall_speed", "m/s", "largest speed of the jar's centre"}, peak_wall_speed},
    {{"jar_volume", "ml", "inner volume from shape and sizes"}, jar_volume},
    {{"shear_modulus", "GPa", "E / (2 (1 + nu))"}, shear_modulus},
    {{"ball_mass", "g", "mass of one ball from diameter and density"}, ball_mass},
};

}  // namespace

const std::vector<CheckQuantity>& check_quantities() {
  static const std::vector<CheckQuantity> quantities = [] {
    std::vector<CheckQuantity> all;
    for (const Row& row : derived_rows) all.push_back(row.quantity);
    return all;
  }();
  return quantities;
}

double derived(const CatalogueEntry& entry, std::string_view quantity) {
  std::vector<std::string> known;
  for (const Row& row : derived_rows) {
    if (row.quantity.name == quantity) return row.value(entry);
    known.emplace_back(row.quantity.name);
  }
  throw InputError(Fault{entry.file, fmt::format("unknown quantity '{}'", quantity),
                         suggestion(quantity, known), "unknown-quantity"});
}

}  // namespace mahlwerk::cases

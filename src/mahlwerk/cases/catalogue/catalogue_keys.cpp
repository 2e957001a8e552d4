// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue/catalogue_keys.hpp"

#include <variant>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

/// A key of all entries of a category or kind, besides the fields of motions or shapes.
struct Extra {
  std::string_view category, kind;  // an empty kind stands for all kinds
  std::string_view key, unit;
  Range range;
  std::string_view about;
};

constexpr Extra extras[] = {
    {"mills", "", "jars_carried", "", positive, "number of jars that the mill moves at once"},
    {"mills", "", "jar_axis", an_axis, any_number, "direction of the axis of the mounted jar"},
    {"mills", "", "power", "W", positive, "power of the motor"},
    {"mills", "arc-shaker", "arc_amplitude", "m", positive,
     "half the length of the arc: arm times swing"},
    {"jars", "", "volume", "m3", positive, "nominal volume, as sold"},
    {"jars", "", "wall", "m", positive, "thickness of the wall"},
    {"jars", "", "material", a_material, any_number, "material of the wall"},
    {"materials", "", "density", "kg/m3", positive, "density of the solid or liquid"},
    {"materials", "", "youngs_modulus", "Pa", positive, "Young's modulus"},
    {"materials", "", "poisson_ratio", "", poisson_ratios, "Poisson's ratio"},
    {"materials", "", "hardness", "", positive, "Vickers hardness number"},
    {"materials", "", "conductivity", "W/m/K", positive, "thermal conductivity"},
    {"materials", "", "heat_capacity", "J/kg/K", positive, "specific heat capacity"},
    {"materials", "", "viscosity", "Pa s", positive, "dynamic viscosity of a liquid"},
    {"materials", "", "e_infinity", "J/kg", positive,
     "median specific fracture energy of large grains, of the breakage model tavares"},
    {"materials", "", "d_0", "m", positive,
     "size below which grains are stronger, of the breakage model tavares"},
    {"materials", "", "phi", "", positive,
     "exponent of this size effect, of the breakage model tavares"},
    {"materials", "", "size_least", "m", positive, "least grain size of the powder as fed"},
    {"materials", "", "size_most", "m", positive, "largest grain size of the powder as fed"},
    {"media", "", "diameter", "m", positive, "diameter of the balls"},
    {"media", "", "count", "", positive, "number of balls"},
    {"media", "", "density", "kg/m3", positive, "density of the balls"},
    {"media", "", "material", a_material, any_number, "material of the balls"},
    {"media", "", "jar_volume", "m3", positive, "nominal volume of the jar the set is meant for"},
    {"media", "", "sample_least", "m3", positive, "least amount of sample for such a jar"},
    {"media", "", "sample_most", "m3", positive, "largest amount of sample for such a jar"},
    {"media", "", "feed_most", "m", positive, "largest grain to feed into such a jar"},
};

/// Calls `visit` with a default-constructed value of every type of a register.
template <class Visit, class... Models>
void for_each_model(const std::variant<Models...>*, Visit visit) {
  (visit(Models{}), ...);
}
constexpr const kinematics::AnyMotion* motions = nullptr;
constexpr const geometry::FormulaShape* shapes = nullptr;

/// A range that a machine offers is that of the magnitude, whatever the sense of turning.
void add_range(std::vector<CatalogueKey>& keys, const CatalogueKey& of) {
  const Range range = of.range.without_zero ? positive : of.range;
  keys.push_back({of.key + "_least", of.unit, range, "least value the mill offers: " + of.about});
  keys.push_back({of.key + "_most", of.unit, range, "largest value the mill offers: " + of.about});
}

/// The fields of the model called `kind` in a register.
template <class Register>
std::vector<CatalogueKey> fields_of(const Register* models, std::string_view kind) {
  std::vector<CatalogueKey> keys;
  for_each_model(models, [&](const auto& model) {
    if (model.name != kind) return;
    for (const auto& field : model.fields())
      keys.push_back({std::string(field.key), field.unit, field.range, std::string(field.about)});
  });
  return keys;
}

template <class Register>
std::vector<std::string> names_of(const Register* models) {
  std::vector<std::string> names;
  for_each_model(models, [&](const auto& model) { names.emplace_back(model.name); });
  return names;
}

}  // namespace

std::vector<std::string> catalogue_kinds(std::string_view category) {
  if (category == "mills") return names_of(motions);
  if (category == "jars") return names_of(shapes);
  return {};
}

std::vector<CatalogueKey> catalogue_keys(std::string_view category, std::string_view kind) {
  std::vector<CatalogueKey> keys;
  if (category == "jars") keys = fields_of(shapes, kind);
  if (category == "mills") {
    for (const CatalogueKey& field : fields_of(motions, kind)) {
      keys.push_back(field);
      add_range(keys, field);
    }
  }
  for (const Extra& extra : extras) {
    if (extra.category == category && (extra.kind.empty() || extra.kind == kind))
      keys.push_back({std::string(extra.key), extra.unit, extra.range, std::string(extra.about)});
  }
  return keys;
}

double number_of(std::string_view text, const CatalogueKey& key) {
  const auto colon = text.find(':');
  if (!key.key.starts_with("ratio") || colon == std::string_view::npos)
    return parse_in(text, key.unit);
  return parse_in(text.substr(colon + 1), "") / parse_in(text.substr(0, colon), "");
}

}  // namespace mahlwerk::cases

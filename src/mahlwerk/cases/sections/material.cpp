// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Properties that a section takes from the material it names.
#include <fmt/format.h>

#include <set>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// Elastic constants of a ball or a jar, for the soft engine.
constexpr auto elastic_fields() {
  using E = contact::ElasticConstants;
  return std::array{Field<E>{"youngs_modulus", "Pa", &E::youngs_modulus, positive,
                             "Young's modulus of the material", steel.youngs_modulus,
                             "steel, handbook; uncalibrated"}
                        .plausible_within("0.1 MPa", "2000 GPa"),
                    Field<E>{"poisson_ratio", "", &E::poisson_ratio, poisson_ratios,
                             "Poisson's ratio of the material", steel.poisson_ratio,
                             "steel, handbook; uncalibrated"}};
}

/// Properties of a ball or a jar, for wear and heat.
constexpr auto substance_fields() {
  using S = Substance;
  constexpr std::string_view source = "hardened steel (1.4034), handbook; uncalibrated";
  return std::array{Field<S>{"hardness", "", &S::hardness, positive, "Vickers hardness number",
                             hardened_steel.hardness, source}
                        .plausible_within("0.5", "10000"),
                    Field<S>{"conductivity", "W/m/K", &S::conductivity, positive,
                             "thermal conductivity", hardened_steel.conductivity, source},
                    Field<S>{"heat_capacity", "J/kg/K", &S::heat_capacity, positive,
                             "specific heat capacity", hardened_steel.heat_capacity, source}};
}

/// Fields of a jar's wall.
constexpr Field<Jar> wall_density{"density",
                                  "kg/m3",
                                  &Jar::density,
                                  positive,
                                  "density of the jar's wall",
                                  hardened_steel_density,
                                  "hardened steel (1.4034), handbook; uncalibrated"};
constexpr Field<Jar> wall_thickness{"wall",
                                    "m",
                                    &Jar::wall,
                                    positive,
                                    "thickness of the jar's wall",
                                    default_wall_thickness,
                                    "a small steel jar's; uncalibrated, 3-15 mm"};

/// Whether the material's value counts: `key` is not given, or given with lower precedence than
/// `material`.
bool by_material(SectionReader& in, std::string_view key) {
  const Node *own = in.find(key), *name = in.find("material");
  return name != nullptr && !name->text.empty() &&
         (own == nullptr || name->precedence > own->precedence);
}

/// The entry's value, with its origin recorded; no value if the entry gives none.
std::optional<double> of_entry(SectionReader& in, const NumberSpec& spec,
                               const CatalogueEntry& entry) {
  const auto found = entry.values.find(std::string(spec.key));
  if (found == entry.values.end()) return std::nullopt;
  Node node = value_from_text(found->second.text, entry.file, Precedence::catalogue);
  node.source = fmt::format("catalogue materials/{}: {}", entry.name, found->second.source);
  node.unverified = found->second.unverified;
  node.assumed = found->second.assumed;
  node.range = found->second.range;
  const double value = in.quantity(node, spec);
  in.record_origin(spec.key, show(value, spec.unit), &node);
  return value;
}

/// The catalogue entry of a material; no value for a material that the catalogue lacks.
std::optional<CatalogueEntry> known_material(SectionReader& in, const std::string& material) {
  if (!in.catalogue().has("materials", material)) return std::nullopt;
  return find_entry(in, "materials", material, *in.find("material"));
}

/// The given value, else that of the material, else the default.
double of_material(SectionReader& in, const NumberSpec& spec, const std::string& material,
                   const std::optional<CatalogueEntry>& entry) {
  if (!by_material(in, spec.key)) return in.value(spec);
  if (const auto found = entry ? of_entry(in, spec, *entry) : std::nullopt) return *found;
  in.record_default(spec.key, show(*spec.standard, spec.unit),
                    fmt::format("{}; the catalogue gives none for {}", spec.source, material));
  return *spec.standard;
}

/// For lists of keys: the default of a property is the material's own.
NumberSpec listed(NumberSpec spec) {
  static std::set<std::string> sources;  // a spec does not own its texts
  spec.source = *sources.insert(fmt::format("that of the material, else {}", spec.source)).first;
  return spec;
}

template <class Owner, class Fields>
void describe_fields(KeyVisitor& v, Owner& owner, const Fields& fields,
                     const std::string& material) {
  SectionReader* in = v.reader();
  if (in == nullptr) {
    for (const auto& f : fields)
      v.number(v.tries_all_words() ? listed(NumberSpec(f)) : NumberSpec(f), owner.*f.value);
    return;
  }
  const auto entry = known_material(*in, material);
  for (const auto& field : fields)
    owner.*field.value = of_material(*in, NumberSpec(field), material, entry);
}

}  // namespace

std::optional<double> read_density(SectionReader& in, const NumberSpec& spec,
                                   std::string& material) {
  return read_of_material(in, spec, material);
}

std::optional<double> read_of_material(SectionReader& in, const NumberSpec& spec,
                                       std::string& material) {
  const Node* name = in.find("material");
  if (name != nullptr) {
    const auto given = in.entry_name("material", "materials");
    if (!given) return invalid_value;  // already reported
    material = *given;
  }
  if (material.empty() || !by_material(in, spec.key)) return in.optional_number(spec);
  const auto entry = find_entry(in, "materials", material, *name);
  return entry ? of_entry(in, spec, *entry) : invalid_value;
}

void describe(KeyVisitor& v, contact::ElasticConstants& elastic, const std::string& material) {
  describe_fields(v, elastic, elastic_fields(), material);
}

void describe(KeyVisitor& v, Substance& substance, const std::string& material) {
  describe_fields(v, substance, substance_fields(), material);
}

void describe_wall(KeyVisitor& v, Jar& jar) {
  describe(v, jar.elastic, jar.material);
  describe(v, jar.substance, jar.material);
  describe_fields(v, jar, std::array{wall_density}, jar.material);
  v.number(NumberSpec(wall_thickness), jar.wall);
}

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a section takes from the material it names.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

/// Whether the material's name counts, not what is said under `key` itself.
bool by_material(Section& in, std::string_view key) {
  const Node *own = in.find(key), *name = in.find("material");
  return name != nullptr && !name->text.empty() && (own == nullptr || name->rank > own->rank);
}

/// What the catalogue says under `key`, noted; nothing if it is silent.
std::optional<double> of_entry(Section& in, const Wanted& wanted, const CatalogueEntry& entry) {
  const auto found = entry.values.find(std::string(wanted.key));
  if (found == entry.values.end()) return std::nullopt;
  Node node = loose_value(found->second.text, entry.file, Rank::catalogue);
  node.source = fmt::format("catalogue materials/{}: {}", entry.name, found->second.source);
  node.unverified = found->second.unverified;
  const double value = in.quantity(node, wanted);
  in.note(wanted.key, show(value, wanted.unit), &node);
  return value;
}

/// The catalogue's entry of a material; nothing for one it lacks, which may be a mere name.
std::optional<CatalogueEntry> known_material(Section& in, const std::string& material,
                                             const Catalogue& catalogue) {
  if (!catalogue.has("materials", material)) return std::nullopt;
  return look_up(catalogue, "materials", *in.find("material"), in.findings());
}

/// From where it is said, from the material, or the default.
double of_material(Section& in, const Wanted& wanted, const std::string& material,
                   const std::optional<CatalogueEntry>& entry) {
  if (!by_material(in, wanted.key)) return in.value(wanted);
  if (const auto found = entry ? of_entry(in, wanted, *entry) : std::nullopt) return *found;
  in.note_default(wanted.key, show(*wanted.standard, wanted.unit),
                  fmt::format("{}; the catalogue gives none for {}", wanted.source, material));
  return *wanted.standard;
}

template <class Owner, class Fields>
Owner all_of_material(Section& in, const Fields& fields, const std::string& material,
                      const Catalogue& catalogue) {
  const auto entry = known_material(in, material, catalogue);
  Owner owner;
  for (const auto& field : fields)
    owner.*field.value = of_material(in, Wanted(field), material, entry);
  return owner;
}

}  // namespace

std::optional<double> read_density(Section& in, const Wanted& wanted, std::string& material,
                                   const Catalogue& catalogue) {
  const Node* name = in.find("material");
  if (name != nullptr) material = in.text("material").value_or("");
  if (material.empty() || !by_material(in, wanted.key)) return in.maybe(wanted);
  const auto entry = look_up(catalogue, "materials", *name, in.findings());
  return entry ? of_entry(in, wanted, *entry) : unread;
}

contact::Elastic read_elastic(Section& in, const std::string& material,
                              const Catalogue& catalogue) {
  return all_of_material<contact::Elastic>(in, elastic_fields(), material, catalogue);
}

Substance read_substance(Section& in, const std::string& material, const Catalogue& catalogue) {
  return all_of_material<Substance>(in, substance_fields(), material, catalogue);
}

void read_wall(Section& in, Jar& jar, const Catalogue& catalogue) {
  jar.elastic = read_elastic(in, jar.material, catalogue);
  jar.substance = read_substance(in, jar.material, catalogue);
  jar.density = of_material(in, Wanted(wall_density), jar.material,
                            known_material(in, jar.material, catalogue));
  jar.wall = in.value(Wanted(wall_thickness));
}

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a section takes from the material it names.
#include <fmt/format.h>

#include <algorithm>

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
  std::optional<CatalogueEntry> entry;  // a material the catalogue lacks may be a mere name
  const std::vector<std::string> known = catalogue.names("materials");
  if (!material.empty() && std::ranges::binary_search(known, material))
    entry = look_up(catalogue, "materials", *in.find("material"), in.findings());
  contact::Elastic elastic;
  for (const auto& field : elastic_fields()) {
    const Wanted wanted(field);
    double& value = elastic.*field.value;
    if (!by_material(in, field.key)) {
      value = in.value(wanted);
      continue;
    }
    const auto found = entry ? of_entry(in, wanted, *entry) : std::nullopt;
    value = found.value_or(*field.standard);
    if (!found)
      in.note_default(field.key, show(value, field.unit),
                      fmt::format("{}; the catalogue gives none for {}", field.source, material));
  }
  return elastic;
}

}  // namespace mahlwerk::cases

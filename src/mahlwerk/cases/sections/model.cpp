// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

std::optional<CatalogueEntry> look_up(Section& in, std::string_view room, const Node& at) {
  try {
    return in.catalogue().find(room, at.text, at.where);
  } catch (const InputError& error) {
    auto& found = in.findings().faults;
    found.insert(found.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

namespace {

/// A `model` beside `kind` is held to the catalogue, too, where it is known there: a case that was
/// written with all its values needs no catalogue.
void beside(Model& model, Section& in, std::string_view room, const Node& name) {
  model.name = in.text("model").value_or("");
  if (model.name.empty() || model.kind.empty() || !in.catalogue().has(room, model.name)) return;
  model.entry = look_up(in, room, name);
  if (!model.entry || model.entry->kind == model.kind) return;
  in.fault(name,
           fmt::format("model = \"{}\" is of kind \"{}\", not \"{}\"", model.name,
                       model.entry->kind, model.kind),
           "leave out one of `model` and `kind`", "model-and-kind");
  model.entry.reset();
}

}  // namespace

Model read_model(Section& in, std::string_view room, const std::vector<std::string>& kinds) {
  const Node *kind = in.find("kind"), *name = in.find("model");
  if (kind == nullptr && name == nullptr) {
    in.missing("kind", "",
               fmt::format("write kind = ..., one of {}, or model = \"...\" with a name `mahlwerk "
                           "list {}` shows",
                           listed(kinds), room));
    return {};
  }
  Model model;
  if (kind == nullptr || (name != nullptr && name->rank > kind->rank)) {
    model.name = in.text("model").value_or("");
    if (model.name.empty()) return model;
    model.entry = look_up(in, room, *name);
    if (!model.entry) return model;
    in.lend(*model.entry);
    model.kind = model.entry->kind;
    in.note("kind", fmt::format("\"{}\"", model.kind), name,
            fmt::format("catalogue {}/{}", room, model.name));
    return model;
  }
  model.kind = in.choice({"kind", kinds, ""});
  if (name != nullptr && name->rank == kind->rank) beside(model, in, room, *name);
  return model;
}

}  // namespace mahlwerk::cases

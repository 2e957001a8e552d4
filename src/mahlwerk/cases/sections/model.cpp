// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

std::optional<CatalogueEntry> find_entry(SectionReader& in, std::string_view category,
                                         const std::string& name, const Node& at) {
  try {
    return in.catalogue().find(category, name, at.where);
  } catch (const InputError& error) {
    auto& found = in.findings().faults;
    found.insert(found.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

namespace {

/// Checks a `model` given together with `kind` against its catalogue entry, if there is one: a
/// resolved case with all its values must not need a catalogue.
void check_model_name(Model& model, SectionReader& in, std::string_view category,
                      const Node& name) {
  model.name = in.entry_name("model", category).value_or("");
  if (model.name.empty() || model.kind.empty() || !in.catalogue().has(category, model.name)) return;
  model.entry = find_entry(in, category, model.name, name);
  if (!model.entry || model.entry->kind == model.kind) return;
  in.fault(name,
           fmt::format("model = \"{}\" is of kind \"{}\", not \"{}\"", model.name,
                       model.entry->kind, model.kind),
           "leave out one of `model` and `kind`", "model-and-kind");
  model.entry.reset();
}

}  // namespace

Model read_model(SectionReader& in, std::string_view category,
                 const std::vector<std::string>& kinds) {
  const Node *kind = in.find("kind"), *name = in.find("model");
  if (kind == nullptr && name == nullptr) {
    in.missing("kind", "",
               fmt::format("write kind = ..., one of {}, or model = \"...\" with a name from "
                           "`mahlwerk list {}`",
                           quoted_list(kinds), category));
    return {};
  }
  Model model;
  if (kind == nullptr || (name != nullptr && name->precedence > kind->precedence)) {
    model.name = in.entry_name("model", category).value_or("");
    if (model.name.empty()) return model;
    model.entry = find_entry(in, category, model.name, *name);
    if (!model.entry) return model;
    in.add_defaults(*model.entry);
    model.kind = model.entry->kind;
    in.record_origin("kind", fmt::format("\"{}\"", model.kind), name,
                     fmt::format("catalogue {}/{}", category, model.name));
    return model;
  }
  model.kind = in.choice({"kind", kinds, ""});
  if (name != nullptr && name->precedence == kind->precedence)
    check_model_name(model, in, category, *name);
  return model;
}

}  // namespace mahlwerk::cases

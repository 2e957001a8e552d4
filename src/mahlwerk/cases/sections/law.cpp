// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The keys of [contact] for the contact model of the soft engine.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::cases {
namespace {

void refuse_meaningless(SectionReader& in, std::string_view key, std::string_view kind,
                        std::string_view chosen) {
  in.refuse({key}, fmt::format("under {} = \"{}\"", kind, chosen),
            fmt::format("remove it, or choose another {}", kind));
}

template <class L>
void describe_switch(KeyVisitor& v, L& law, const contact::LawSwitch<L>& one) {
  const std::string first(one.words[0]), second(one.words[1]);
  v.word(Choice{one.key,
                {first, second},
                first,
                one.source,
                one.about,
                {one.meanings[0], one.meanings[1]}}
             .read_by(soft_and_lammps),
         law.*one.second);
}

std::vector<std::string_view> rolling_meanings() {
  std::vector<std::string_view> meanings;
  for (const contact::RollingRule& rule : contact::rolling_rules) meanings.push_back(rule.about);
  return meanings;
}

const std::vector<std::string>& twisting_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    for (const contact::TwistingRule& r : contact::twisting_rules) names.emplace_back(r.name);
    return names;
  }();
  return words;
}
std::vector<std::string_view> twisting_meanings() {
  std::vector<std::string_view> meanings;
  for (const contact::TwistingRule& r : contact::twisting_rules) meanings.push_back(r.about);
  return meanings;
}

/// A number of the law, or the alternative key given instead.
template <class L>
void read_number(SectionReader& in, L& law, const contact::LawField<L>& field) {
  for (const auto& other : L::fields())
    if (other.instead_of == field.key && in.one_of({field.key, other.key}) == other.key) {
      law.*other.value = in.value(NumberSpec(other));
      return;
    }
  if (field.default_text.empty() || in.gives(field.key))
    law.*field.value = in.value(NumberSpec(field));
  else
    in.record_default(field.key, std::string(field.default_text), field.source);
}

/// Reads a key of the chosen law. A given key of another law is a fault.
template <class L>
void read_key(SectionReader& in, L& law, std::string_view key) {
  for (const auto& one : contact::switches_of<L>())
    if (one.key == key) return describe_switch(in, law, one);
  for (const auto& field : L::fields())
    if (field.key == key) {
      if (field.instead_of.empty()) read_number(in, law, field);
      return;
    }
  refuse_meaningless(in, key, "law", L::name);
}

/// The keys of the contact law; without switches, except for a reader. `model` is null if unknown.
void describe_law(KeyVisitor& v, ContactModel* model) {
  SectionReader* in = v.reader();
  const auto numbers = [&]<class L>(L& law) {
    std::optional<double> left_out;
    for (const auto& f : L::fields()) {
      const NumberSpec spec = NumberSpec(f)
                                  .with_default_text(f.default_text)
                                  .in_place_of(f.instead_of)
                                  .read_by(soft_and_lammps);
      if (contact::is_given(law, f))
        v.number(spec, law.*f.value);
      else
        v.optional_number(spec, left_out);
    }
  };
  if (in == nullptr) {
    if (model != nullptr) std::visit(numbers, *model->law);
    return;
  }
  for (const std::string_view key : law_keys()) {
    if (model != nullptr)
      std::visit([&](auto& law) { read_key(*in, law, key); }, *model->law);
    else
      in->find(key);
  }
}

void describe_switches(KeyVisitor& v, ContactModel& model) {
  const auto each = [&]<class L>(L& law) {
    for (const auto& one : contact::switches_of<L>()) describe_switch(v, law, one);
  };
  if (v.reader() == nullptr) std::visit(each, *model.law);  // a reader: see describe_law()
}

}  // namespace

bool has_use(KeyVisitor& v, std::string_view key, const ContactModel* model) {
  SectionReader* in = v.reader();
  if (in == nullptr)
    return model != nullptr &&
           ((v.visits_all() && !v.tries_all_words()) || has_meaning(key, *model));
  in->find(key);                       // marks the key as known under any law
  if (model == nullptr) return false;  // the fault of the law is already reported
  if (has_meaning(key, *model)) return true;
  if (key.starts_with("rolling"))
    refuse_meaningless(*in, key, "rolling", contact::rule_of(model->rolling).name);
  else
    refuse_meaningless(*in, key, "law", contact::name_of(*model->law));
  return false;
}

bool describe(KeyVisitor& v, ContactModel& model) {
  const bool law = v.model({.key = "law",
                            .words = {},
                            .standard = contact_laws().front(),
                            .source = "elastic spheres that stick and slip, the usual law of mills",
                            .about = "contact law of the soft engine",
                            .presentation = {.label = "contact law"},
                            .engines = soft_and_lammps},
                           *model.law);
  const bool rolling = v.word(Choice{"rolling", rolling_words(), "cdt",
                                     "a constant torque against the rolling, as in Mhadhbi 2021",
                                     "rolling resistance of the soft engine", rolling_meanings()}
                                  .read_by(soft_and_lammps),
                              model.rolling);
  ContactModel* known = law && rolling ? &model : nullptr;
  describe_switches(v, model);
  if (has_use(v, rolling_damping.key, known))
    v.number(NumberSpec(rolling_damping).read_by(soft_only), model.rolling_damping);
  describe_law(v, known);
  v.flag({"curved_walls", false, "walls count as flat under a ball",
          "whether the effective radius of a contact with a wall includes the wall's curvature",
          soft_and_lammps},
         model.curved_walls);
  v.flag({"rescaled_unloading", false, "the tangential spring is not rescaled while unloading",
          "whether the tangential spring is rescaled while the normal force decreases (dem.21)",
          soft_only},
         model.rescaled_unloading);
  v.flag({"partial_slip", false, "a tangential spring of full stiffness, as in Mhadhbi 2021",
          "whether the tangential stiffness falls as slip spreads over the contact area (dem.40)",
          soft_and_lammps},
         model.partial_slip);
  if (v.reader() != nullptr && model.partial_slip && model.rescaled_unloading)
    refuse_meaningless(*v.reader(), "rescaled_unloading", "partial_slip", "true");
  v.word({"twisting", twisting_words(), "none", "small against rolling resistance",
          "friction against rotation about the normal", twisting_meanings()},
         model.twisting);
  return known != nullptr;
}

}  // namespace mahlwerk::cases

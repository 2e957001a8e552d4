// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The contact model of the soft engine: what [contact] says about it, and each of
// [[contact.pairs]].
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"
#include "mahlwerk/cases/register.hpp"

namespace mahlwerk::cases {
namespace {

using contact::ContactModel;

/// Where the word stands in the list; nothing for one that had a fault.
std::optional<std::size_t> place_in(const std::vector<std::string>& words,
                                    const std::string& word) {
  const auto at = std::ranges::find(words, word);
  if (at == words.end()) return std::nullopt;
  return static_cast<std::size_t>(at - words.begin());
}

void without_meaning(Section& in, std::string_view key, std::string_view kind,
                     std::string_view chosen) {
  in.refuse({key}, fmt::format("under {} = \"{}\"", kind, chosen),
            fmt::format("remove it, or choose another {}", kind));
}

/// Reports a key that says nothing under the chosen law or rolling; false where there is nothing to
/// read.
bool meant(Section& in, std::string_view key, const std::optional<ContactModel>& model) {
  in.find(key);              // it is known, whatever is chosen
  if (!model) return false;  // the law itself is at fault
  if (has_meaning(key, *model)) return true;
  if (key.starts_with("rolling"))
    without_meaning(in, key, "rolling", contact::rule_of(model->rolling).name);
  else
    without_meaning(in, key, "law", contact::name_of(model->law));
  return false;
}

/// The law and the rolling resistance by their words; nothing after a fault.
std::optional<ContactModel> read_words(Section& in) {
  const std::string law =
      in.choice({"law", contact_laws(), contact_laws().front(),
                 "elastic spheres that stick and slip, the usual law of mills"});
  const auto rolling = place_in(
      rolling_words(), in.choice({"rolling", rolling_words(), "cdt",
                                  "a constant torque against the rolling, as in paper B"}));
  ContactModel model;
  if (!choose_model(model.law, law) || !rolling) return std::nullopt;
  model.rolling = static_cast<contact::Rolling>(*rolling);
  return model;
}

template <class L>
void read_switch(Section& in, L& law, const contact::LawSwitch<L>& one) {
  const std::string first(one.words[0]), second(one.words[1]);
  law.*one.second = in.choice({one.key, {first, second}, first, one.source}) == second;
}

/// A number of the law, or the one that takes its place.
template <class L>
void read_number(Section& in, L& law, const contact::LawField<L>& field) {
  for (const auto& other : L::fields())
    if (other.instead_of == field.key && in.one_of({field.key, other.key}) == other.key) {
      law.*other.value = in.value(Wanted(other));
      return;
    }
  if (field.unless_given.empty() || in.gives(field.key))
    law.*field.value = in.value(Wanted(field));
  else
    in.note_default(field.key, std::string(field.unless_given), field.source);
}

/// A key of the chosen law, or of another, which is a fault.
template <class L>
void read_key(Section& in, L& law, std::string_view key) {
  for (const auto& one : contact::switches_of<L>())
    if (one.key == key) return read_switch(in, law, one);
  for (const auto& field : L::fields())
    if (field.key == key) {
      if (field.instead_of.empty()) read_number(in, law, field);
      return;
    }
  without_meaning(in, key, "law", L::name);
}

}  // namespace

std::optional<ContactModel> read_contact_model(Section& in) {
  auto model = read_words(in);
  if (meant(in, rolling_damping.key, model))
    model->rolling_damping = in.value(Wanted(rolling_damping));
  for (const std::string_view key : law_keys()) {
    if (model)
      std::visit([&](auto& law) { read_key(in, law, key); }, model->law);
    else
      in.find(key);
  }
  const bool curved = in.flag("curved_walls", false, "walls count as flat under a ball");
  const bool rescaled =
      in.flag("rescaled_unloading", false, "the tangential spring stays as it is while unloading");
  if (!model) return std::nullopt;
  model->curved_walls = curved;
  model->rescaled_unloading = rescaled;
  return model;
}

template <class Owner>
void read_touch(Section& in, Owner& owner, const std::optional<ContactModel>& model,
                const Contact* all) {
  const auto general = touch_fields<Contact>();
  std::size_t i = 0;
  for (const auto& field : touch_fields<Owner>()) {
    const auto of_all = general[i++].value;
    owner.*field.value = 0;
    if (!meant(in, field.key, model)) continue;
    Wanted wanted(field);
    wanted.unit = unit_of(field.key, field.unit, *model);
    if (wanted.unit != field.unit) wanted.standard.reset();  // none is known in that unit
    if (all != nullptr) {
      wanted.standard = all->*of_all;
      wanted.source = "as [contact] says";
    }
    owner.*field.value = in.value(wanted);
  }
}
template void read_touch(Section&, Contact&, const std::optional<ContactModel>&, const Contact*);
template void read_touch(Section&, PairRule&, const std::optional<ContactModel>&, const Contact*);

}  // namespace mahlwerk::cases

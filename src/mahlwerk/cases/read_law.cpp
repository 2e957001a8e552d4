// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The contact law of the soft engine: what [contact] says about it, and each of [[contact.pairs]].
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

using contact::LawChoice;

/// Where the word stands in the list; nothing for one that had a fault.
std::optional<std::size_t> place_in(const std::vector<std::string>& words,
                                    const std::string& word) {
  const auto at = std::ranges::find(words, word);
  if (at == words.end()) return std::nullopt;
  return static_cast<std::size_t>(at - words.begin());
}

/// Reports a key that says nothing under the chosen law; false where there is nothing to read.
bool meant(Section& in, std::string_view key, const std::optional<LawChoice>& choice) {
  const Node* at = in.find(key);
  if (!choice) return false;  // the law itself is at fault
  if (has_meaning(key, *choice)) return true;
  const bool rolls = key.starts_with("rolling");
  const std::string_view chosen =
      rolls ? contact::rolling_words[static_cast<std::size_t>(choice->rolling)]
            : contact::law_words[static_cast<std::size_t>(choice->law)];
  if (at != nullptr)
    in.fault(
        *at,
        fmt::format("{} has no meaning under {} = \"{}\"", key, rolls ? "rolling" : "law", chosen),
        fmt::format("remove it, or choose another {}", rolls ? "rolling" : "law"), "too-much");
  return false;
}

/// The law and the rolling resistance by their words; nothing after a fault.
std::optional<LawChoice> read_words(Section& in) {
  const auto law = place_in(
      contact_laws(), in.choice({"law", contact_laws(), "hertz-mindlin",
                                 "elastic spheres that stick and slip, the usual law of mills"}));
  const auto rolling = place_in(
      rolling_words(), in.choice({"rolling", rolling_words(), "cdt",
                                  "a constant torque against the rolling, as in paper B"}));
  if (!law || !rolling) return std::nullopt;
  LawChoice choice;
  choice.law = static_cast<contact::LawName>(*law);
  choice.rolling = static_cast<contact::Rolling>(*rolling);
  return choice;
}

/// The spring of the two linear laws: its stiffness, or the speed that makes it as stiff as
/// Hertz's.
void read_stiffness(Section& in, LawChoice& made, const Wanted& speed, const Wanted& stiffness) {
  if (in.one_of({"stiffness_speed", "stiffness"}) == "stiffness")
    made.stiffness = in.value(stiffness);
  else
    made.stiffness_speed = in.value(speed);
}

void read_damping(Section& in, LawChoice& made, const Wanted& depth) {
  const std::string word =
      in.choice({"damping", damping_words(), "exact", "gives the restitution that is asked for"});
  made.published_damping = word == "published";
  if (in.gives("damping_depth"))
    made.damping_depth = in.value(depth);
  else
    in.note_default("damping_depth", "a hundredth of the largest overlap",
                    "deeper ones switch the damper off");
}

}  // namespace

std::optional<LawChoice> read_law_choice(Section& in) {
  const auto choice = read_words(in);
  LawChoice made = choice.value_or(LawChoice());
  const auto fields = law_fields();
  const Wanted rolling(fields[0]), speed(fields[1]), stiffness(fields[2]), depth(fields[3]);
  if (meant(in, rolling.key, choice)) made.rolling_damping = in.value(rolling);
  const bool by_speed = meant(in, speed.key, choice), by_itself = meant(in, stiffness.key, choice);
  if (by_speed && by_itself) read_stiffness(in, made, speed, stiffness);
  const bool damped = meant(in, "damping", choice), deep = meant(in, depth.key, choice);
  if (damped && deep) read_damping(in, made, depth);
  made.curved_walls = in.flag("curved_walls", false, "walls count as flat under a ball");
  made.rescaled_unloading =
      in.flag("rescaled_unloading", false, "the tangential spring stays as it is while unloading");
  return choice ? std::optional(made) : std::nullopt;
}

template <class Owner>
void read_touch(Section& in, Owner& owner, const std::optional<LawChoice>& choice,
                const Contact* all) {
  const auto general = touch_fields<Contact>();
  std::size_t i = 0;
  for (const auto& field : touch_fields<Owner>()) {
    const auto of_all = general[i++].value;
    owner.*field.value = 0;
    if (!meant(in, field.key, choice)) continue;
    Wanted wanted(field);
    wanted.unit = unit_of(field.key, field.unit, *choice);
    if (wanted.unit != field.unit) wanted.standard.reset();  // none is known in that unit
    if (all != nullptr) {
      wanted.standard = all->*of_all;
      wanted.source = "as [contact] says";
    }
    owner.*field.value = in.value(wanted);
  }
}
template void read_touch(Section&, Contact&, const std::optional<LawChoice>&, const Contact*);
template void read_touch(Section&, PairRule&, const std::optional<LawChoice>&, const Contact*);

}  // namespace mahlwerk::cases

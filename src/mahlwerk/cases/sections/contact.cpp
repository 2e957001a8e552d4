// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [contact] and [[contact.pairs]]: rules and parameters of contacts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/kinematics/strongest_field.hpp"

namespace mahlwerk::cases {
namespace {

/// [m/s2] Strongest effective gravity in the frame of the jar's centre.
double field_of(const Case& c) {
  const kinematics::AnyMotion& motion = *c.mill.motion;
  return kinematics::strongest_field(c.gravity_vector(), kinematics::bounds(motion).acceleration,
                                     kinematics::period(motion),
                                     [&](double t) { return kinematics::frame_motion(motion, t); });
}

/// The default t_c scales like all time scales of the mill, with one over the square root of its
/// strongest field (man.4).
void describe_contact_time(KeyVisitor& v, Contact& contact, const Case& c) {
  /// Contacts of real balls last less than a millisecond; a longer t_c would make collisions
  /// elastic.
  constexpr Range times{.least = 0, .most = 1e-3, .without_least = true};
  constexpr double one_g = 9.80665, usual = 1e-4;  // [m/s2], [s]
  const double strength = v.reader() != nullptr ? field_of(c) / one_g : 1;
  const std::string stronger = fmt::format(
      "a few times a steel ball's contact time at 1 g; this mill's field of {:.3g} g "
      "shortens time scales by its square root",
      strength);
  NumberSpec time("contact_time", "s", times,
                  "bounces that follow within this time are elastic under lasting = \"tc\"", usual,
                  "a few times a steel ball's contact time, at 1 g or less");
  if (v.tries_all_words())
    time = time.with_default_text(
        "0.1 ms at 1 g or less; in stronger fields shorter by their square root (man.4)");
  if (strength > 1) time = time.with_default(usual / std::sqrt(strength), stronger);
  v.number(time.read_by(event_only), contact.contact_time);
}

/// The numbers of the event engine, and `softening` of the soft engine.
void describe_numbers(KeyVisitor& v, Contact& contact, const Case& c) {
  NumberSpec friction(
      "lasting_friction", "", not_negative, "Coulomb's friction coefficient of sustained contacts",
      0.3, "uncalibrated, 0.1-0.6; sustained contacts need a limit where bounces have none");
  if (v.tries_all_words())
    friction = friction.with_default_text("the friction of bounces; 0.3 if they have none");
  else if (std::isfinite(contact.rule.friction))
    friction = friction.with_default(contact.rule.friction, "the friction of bounces");
  v.number(friction.read_by(event_only), contact.lasting_friction);
  v.number(NumberSpec("lasting_speed", "m/s", not_negative,
                      "a ball pressed to the wall that rebounds slower stays in sustained contact",
                      1e-4, "far below the speeds of interest")
               .read_by(event_only),
           contact.lasting_speed);
  describe_contact_time(v, contact, c);
  constexpr Range factors{.least = 0, .most = 1, .without_least = true};
  v.number(
      NumberSpec("softening", "", factors,
                 "factor on every Young's modulus: below 1, time steps and overlaps are larger",
                 1.0, "moduli as they are")
          .read_by(soft_and_lammps),
      contact.softening);
}

/// The parameters of [contact] besides the bounce rule, or those of a pair with `all` as defaults.
/// Ignored if the model is unknown.
template <class Owner>
void describe_touch(KeyVisitor& v, Owner& owner, const ContactModel* model, const Contact* all) {
  const auto general = touch_fields<Contact>();
  std::size_t i = 0;
  for (const auto& field : touch_fields<Owner>()) {
    const auto of_all = general[i++].value;
    if (!has_use(v, field.key, model)) {
      if (v.reader() != nullptr) owner.*field.value = 0;
      continue;
    }
    NumberSpec spec(field);
    spec.unit = unit_of(field.key, field.unit, *model);
    if (field.key == "rolling_friction") spec = spec.with_assumed_range(plausible_rolling_friction);
    if (field.key == "rolling_friction" && spec.unit.empty()) spec = spec.plausible_within("", "1");
    if (spec.unit != field.unit) spec.standard.reset();  // no default in that unit
    if (all != nullptr) spec = spec.with_default(all->*of_all, of_contact);
    v.number(spec, owner.*field.value);
  }
}

std::string between_text(const PairRule& pair) {
  return fmt::format("[{}, {}]", in_quotes(pair.between[0]), in_quotes(pair.between[1]));
}

/// A partner of a pair; a material may be called as people write it.
std::string partner(SectionReader& in, const std::string& word) {
  const auto entries = in.catalogue().entries_called("materials", word);
  return entries.size() == 1 ? entries.front() : word;
}

void describe_between(KeyVisitor& v, PairRule& pair) {
  constexpr CustomKey between{
      .key = "between",
      .about = "the two partners of the rule: ball sets, faces of the jar or materials",
      .required = true};
  v.custom(between, [&] { return between_text(pair); });
  SectionReader* in = v.reader();
  if (in == nullptr) return;
  constexpr std::string_view form = "write for instance between = [\"balls.1\", \"jar\"]";
  const auto is_text = [](const Node& n) { return n.kind == Node::Kind::text; };
  const Node* at = in->find(between.key);
  if (at == nullptr) {
    in->missing(between.key, between.about, std::string(form));
  } else if (at->items.size() != 2 || !std::ranges::all_of(at->items, is_text)) {
    in->fault(*at, "`between` must name two partners", std::string(form), "wrong-type");
  } else {
    pair.between = {partner(*in, at->items[0].text), partner(*in, at->items[1].text)};
    in->record_origin(between.key, between_text(pair), at);
  }
}

std::vector<PairRule> read_pairs(const Node* list, const Contact& all, const ContactModel* model,
                                 Findings& findings) {
  std::vector<PairRule> pairs;
  if (list == nullptr) return pairs;
  const auto is_table = [](const Node& n) { return n.kind == Node::Kind::table; };
  if (list->kind != Node::Kind::list || !std::ranges::all_of(list->items, is_table)) {
    findings.faults.push_back({list->where, "`contact.pairs` must be a list of sections",
                               "write [[contact.pairs]] and its values below", "wrong-type"});
    return pairs;
  }
  for (const Node& item : list->items) {
    SectionReader in(&item, fmt::format("contact.pairs.{}", pairs.size() + 1), findings);
    describe(in, pairs.emplace_back(), all, model);
    in.report_unknown_keys();
  }
  return pairs;
}

}  // namespace

void describe(KeyVisitor& v, PairRule& pair, const Contact& all, const ContactModel* model) {
  describe_between(v, pair);
  describe(v, pair.rule, &all.rule);
  describe_touch(v, pair, model, &all);
}

const ContactModel* describe(KeyVisitor& v, Contact& contact, const Case& c) {
  const bool known = describe(v, contact.model);
  const ContactModel* model = known ? &contact.model : nullptr;
  describe(v, contact.rule, nullptr);
  if (v.reader() == nullptr) describe_touch(v, contact, model, nullptr);
  describe_numbers(v, contact, c);
  if (v.reader() != nullptr) describe_touch(v, contact, model, nullptr);
  const bool several = balls_count(c.balls) > 1;
  const bool lists = v.tries_all_words();
  v.word(Choice{"lasting",
                {"roll", "tc", "none"},
                lists     ? ""
                : several ? "tc"
                          : "roll",
                lists     ? "\"tc\" for several balls, \"roll\" for one"
                : several ? "with several balls, sustained contacts follow the TC rule"
                          : "a ball may stay in contact, and roll or slide",
                "how the event engine treats a ball that bounces ever faster",
                {"it stays in contact and rolls or slides; for one ball",
                 "a bounce within contact_time of the last one is elastic", "no treatment"}}
             .read_by(event_only),
         contact.lasting);
  return model;
}

Contact read_contact(const Node* table, const Case& c, Findings& findings) {
  Contact contact;
  SectionReader in(table, "contact", findings);
  const ContactModel* model = describe(in, contact, c);
  const Node* pairs = in.find("pairs");
  in.report_unknown_keys();
  contact.pairs = read_pairs(pairs, contact, model, findings);
  return contact;
}

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

Wanted with_default(Wanted wanted, double standard, std::string_view source) {
  wanted.standard = standard;
  wanted.source = source;
  return wanted;
}

contact::BounceRule read_rule(Section& in) {
  contact::BounceRule rule;
  rule.restitution = in.value(with_default(
      {"restitution", "", restitution_range, "normal speed after over before a bounce"}, 0.8,
      "clean metal, uncalibrated, range 0.3-0.9 (literature disagrees)"));
  const Node* friction = in.find("friction");
  const bool smooth_wall = in.gives("tangential_restitution") && friction == nullptr;
  const std::string bounce = in.choice(
      {"bounce",
       {"constant", "walton"},
       smooth_wall ? "constant" : "walton",
       smooth_wall ? "tangential_restitution without friction is paper A's rule, no Coulomb limit"
                   : "sticking below the Coulomb limit, sliding above it"});
  rule.tangential_restitution = in.value(with_default(
      {"tangential_restitution", "", tangential_range,
       "slip after over before a bounce: 1 smooth, 0 no slip, -1 perfectly rough"},
      0, bounce == "constant" ? "no slip after a bounce" : "no slip below the Coulomb limit"));
  if (bounce == "constant") {
    if (friction != nullptr)
      in.fault(*friction, "friction has no meaning under bounce = \"constant\"",
               "remove friction, or write bounce = \"walton\"", "too-much");
    return rule;
  }
  rule.friction =
      in.value(with_default({"friction", "", not_negative, "Coulomb's friction coefficient mu"},
                            0.3, "uncalibrated, 0.1-0.6"));
  return rule;
}

}  // namespace

Contact read_contact(const Node* table, Findings& findings) {
  Contact contact;
  Section in(table, "contact", findings);
  contact.law = in.choice({"law", contact_laws(), "hertz-mindlin", "of the soft engine"});
  contact.rule = read_rule(in);
  for (const auto& field : contact_fields()) {
    Wanted wanted(field);
    if (field.value == &Contact::lasting_friction && std::isfinite(contact.rule.friction))
      wanted = with_default(wanted, contact.rule.friction, "the friction of bounces");
    contact.*field.value = in.value(wanted);
  }
  const std::string lasting =
      in.choice({"lasting", lasting_words(), "roll", "a ball may come to stay, and roll or slide"});
  const auto at = std::ranges::find(lasting_words(), lasting);
  if (at != lasting_words().end())
    contact.lasting = static_cast<Lasting>(at - lasting_words().begin());
  in.close();
  return contact;
}

Run read_run(const Node* table, Findings& findings) {
  Run run;
  Section in(table, "run", findings);
  run.engine = in.choice({"engine", engines(), "auto", "chosen by what the case needs"});
  for (const auto& field : run_fields()) run.*field.value = in.value(Wanted(field));
  if (const auto replicates = in.whole("replicates", most_replicates)) {
    run.replicates = *replicates;
  } else {
    run.replicates = 5;
    in.note_default("replicates", "5", "as in paper A");
  }
  in.close();
  return run;
}

Observe read_observe(const Node* table, Findings& findings) {
  Observe observe;
  Section in(table, "observe", findings);
  for (const auto& field : observe_fields()) observe.*field.value = in.value(Wanted(field));
  observe.collisions = in.flag("collisions", false, "no record of every collision is kept");
  in.close();
  return observe;
}

}  // namespace mahlwerk::cases

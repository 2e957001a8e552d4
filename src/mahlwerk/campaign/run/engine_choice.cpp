// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/engine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/pilot.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/lammps/notices.hpp"

namespace mahlwerk::campaign {
namespace {

std::int64_t balls(const cases::Case& mill_case) {
  std::int64_t count = 0;
  for (const cases::BallSet& set : mill_case.balls) count += set.count;
  return count;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Shares of contact in a run, over all its replicates.
struct Contacts {
  double share = 0;        ///< [1] of the balls' time in contact
  double withheld = 0;     ///< [1] power that the TC rule withheld, over the dissipated power
  double hits_within = 0;  ///< [1] share of the hits that begin within t_c of another
  std::int64_t collisions = 0;
};

Contacts contacts_of(const results::Outcome& outcome) {
  double time = 0, contact = 0, lost = 0, withheld = 0;
  std::int64_t collisions = 0, hits = 0, within = 0;
  for (const results::Replicate& r : outcome.replicates) {
    time += r.time() * static_cast<double>(balls(outcome.mill_case));
    contact += r.energy_balance.contact_time - r.at_settled.contact_time;
    lost += r.energy_balance.lost() - r.at_settled.lost();
    withheld += r.energy_balance.withheld - r.at_settled.withheld;
    collisions += r.energy_balance.collisions;
    hits += r.tally.above.count;
    within += r.energy_balance.hits_within - r.at_settled.hits_within;
  }
  return {time > 0 ? contact / time : 0, lost > 0 ? withheld / lost : 0,
          hits > 0 ? static_cast<double>(within) / static_cast<double>(hits) : 0, collisions};
}

std::string percent(const ContactTimeEffect::Change& change) {
  if (!std::isfinite(change.share) || !std::isfinite(change.ci95)) return "an unknown amount";
  return fmt::format("{:+.2g} % (± {:.2g} %)", 100 * change.share, 100 * change.ci95);
}

/// "With a contact.contact_time of 25 us instead of 100 us the power of a pilot run changes by
/// ...".
std::string in_words(const ContactTimeEffect& effect, const cases::Case& mill_case) {
  return fmt::format(
      "With a contact.contact_time of {:.3g} us instead of {:.3g} us the power of a pilot run "
      "changes by {}, the number of its hits above the threshold by {}.",
      1e6 * mill_case.contact.contact_time * ContactTimeEffect::shorter,
      1e6 * mill_case.contact.contact_time, percent(effect.power), percent(effect.hits));
}

/// The name of the contact law if it is adhesive.
std::optional<std::string_view> sticking(const cases::Case& mill_case) {
  const contact::PairTable pairs = cases::pair_table(mill_case);
  const auto any = [&](const contact::AdhesionParameter& adhesion) {
    return std::ranges::any_of(pairs.all(),
                               [&](const auto& pair) { return pair.*adhesion.value > 0; });
  };
  const contact::AnyLaw& law = *mill_case.contact.model.law;
  if (!std::ranges::any_of(contact::adhesion(law), any)) return std::nullopt;
  return contact::name_of(law);
}

/// Why "auto" does not choose the soft engine, as the end of a sentence; empty if it may.
std::string against_soft(const cases::Case& mill_case) {
  cases::Case soft = mill_case;
  soft.run.engine = cases::EngineName::soft;
  const std::vector<Fault> wrong = run_faults(soft);
  if (!wrong.empty()) return wrong.front().what;
  const double time =
      (mill_case.run.time + mill_case.run.settle) * static_cast<double>(mill_case.run.replicates);
  const double work =
      static_cast<double>(balls(mill_case)) * time / soft_settings(soft).rules.time_step;
  if (work <= max_soft_work) return "";
  return fmt::format(
      "it would take about {:.0f} hours of one core; engine = \"soft\" selects it nevertheless, "
      "and contact.softening shortens it",
      std::max(2.0, work / max_soft_work));
}

std::string pilot_in_words(const Pilot& p) {
  return fmt::format(
      "In a pilot run of {:.3g} s with the event engine, balls were in contact {} of the time.",
      p.time, percent(p.contact_share));
}

/// Why the event engine is not recommended after a pilot run; empty if it is.
std::string against_event(const Pilot& p) {
  if (p.stopped) return "The pilot run stopped early: balls are wedged.";
  if (p.contact_share > contact_share_limit)
    return fmt::format("Above {}, the soft engine is recommended, which resolves contacts in time.",
                       percent(contact_share_limit));
  return "";
}

}  // namespace

EngineChoice choose_engine(const cases::Case& mill_case, const std::atomic<bool>* stop) {
  if (mill_case.run.engine != cases::EngineName::automatic) return {mill_case.run.engine, {}};
  if (!geometry::exact_touches(*mill_case.jar.shape))
    return {cases::EngineName::soft,
            {fmt::format("Engine: soft, chosen by auto. The event engine does not support a jar of "
                         "kind \"{}\".",
                         geometry::name_of(*mill_case.jar.shape))}};
  if (cases::fits_exactly(mill_case))
    return {cases::EngineName::soft,
            {"Engine: soft, chosen by auto. Two balls fit exactly across the jar, where hard "
             "spheres have no room to bounce."}};
  if (cases::liquid_needs_soft(mill_case))
    return {cases::EngineName::soft,
            {"Engine: soft, chosen by auto. The event engine has no liquid around the balls."}};
  if (const auto law = sticking(mill_case); law && against_soft(mill_case).empty())
    return {cases::EngineName::soft,
            {fmt::format("Engine: soft, chosen by auto. law = \"{}\" is adhesive, and the event "
                         "engine does not model adhesion.",
                         *law)}};
  if (balls(mill_case) == 1)
    return {cases::EngineName::event,
            {"Engine: event, chosen by auto. The motion of a single ball is computed exactly."}};
  cases::Case event = mill_case;
  event.run.engine = cases::EngineName::event;
  const Pilot p = pilot(event, stop);
  const std::string seen = pilot_in_words(p);
  std::string against = against_event(p);
  if (against.empty() && p.withheld_share > withheld_share_limit)
    if (const ContactTimeEffect effect = contact_time_effect(event, stop); effect.matters())
      against = in_words(effect, event);
  if (against.empty())
    return {cases::EngineName::event,
            {fmt::format("Engine: event, chosen by auto. {} Up to {} this engine is recommended.",
                         seen, percent(contact_share_limit))}};
  if (const std::string why = against_soft(mill_case); !why.empty())
    return {
        cases::EngineName::event,
        {fmt::format(
            "Engine: event, chosen by auto. {} {} The soft engine would be recommended, but {}.",
            seen, against, why)}};
  return {cases::EngineName::soft,
          {fmt::format("Engine: soft, chosen by auto. {} {}", seen, against)}};
}

namespace {

/// Effect of hits of bodies that touch others on a run of the event engine.
Notices hit_notices(const Contacts& contacts) {
  if (contacts.hits_within <= hits_within_limit) return {};
  return {warning(
      "simultaneous-hits",
      fmt::format("{} of the hits above the threshold begin within contact.contact_time of another "
                  "hit of the same body. Bodies that touch several others at the same time share "
                  "an impact; the event engine resolves it into impacts of two. Above {} the rate "
                  "of hits and their mean energy differ from those of engine = \"soft\" by up to "
                  "30 %; the power does not.",
                  percent(contacts.hits_within), percent(hits_within_limit)))};
}

/// Effect of sustained contacts on a run of the event engine, from its shares of contact and two
/// pilot runs.
Notices contact_notices(const results::Outcome& outcome, const std::atomic<bool>* stop) {
  const Contacts contacts = contacts_of(outcome);
  Notices notes = hit_notices(contacts);
  if (contacts.share > contact_share_limit)
    notes.push_back(warning(
        "long-contacts",
        fmt::format(
            "Balls were in contact {} of the time. The event engine resolves such "
            "contacts into many small bounces: the total number of collisions and the "
            "forces inside the bed are not those of sustained contacts. Above {} the rate "
            "of hits differs from that of engine = \"soft\" by up to 15 %, their mean energy "
            "by up to 30 %, and the power by up to 10 %.",
            percent(contacts.share), percent(contact_share_limit))));
  if (contacts.share <= contact_share_limit && contacts.withheld <= withheld_share_limit &&
      contacts.hits_within <= hits_within_limit)
    return notes;
  if (stop != nullptr && *stop) return notes;
  // A twentieth of the run's own collisions, but enough for an estimate.
  const std::int64_t work =
      std::clamp<std::int64_t>(contacts.collisions / 20, 20'000, pilot_collisions);
  const ContactTimeEffect effect = contact_time_effect(outcome.mill_case, stop, work);
  const std::string words = in_words(effect, outcome.mill_case);
  if (effect.matters())
    notes.push_back(invalid(
        "contact-time",
        fmt::format("The result depends on contact.contact_time, which cannot be measured. {} "
                    "Shorten contact_time until this message disappears, or use "
                    "engine = \"soft\".",
                    words)));
  else if (effect.known())
    notes.push_back(note("contact-time", words));
  else
    notes.push_back(
        {"contact-time",
         contacts.share > contact_share_limit ? Severity::invalid : Severity::warning,
         fmt::format("It is uncertain whether the result depends on contact.contact_time. {}",
                     words)});
  return notes;
}

}  // namespace

Notices engine_notices(const results::Outcome& outcome, const EngineChoice& choice,
                       const std::atomic<bool>* stop) {
  Notices notes;
  for (const std::string& reason : choice.reason) notes.push_back(note("engine-chosen", reason));
  if (std::string grains = cases::grains_note(outcome.mill_case); !grains.empty())
    notes.push_back(note("powder-as-grains", std::move(grains)));
  if (choice.engine == cases::EngineName::lammps) append(notes, lammps::notices(outcome.mill_case));
  if (cases::in_time_steps(choice.engine)) {
    append(notes, soft_notices(outcome.mill_case));
    return notes;
  }
  if (const auto law = sticking(outcome.mill_case))
    notes.push_back(invalid(
        "sticking-law-ignored",
        fmt::format("law = \"{}\" is adhesive. The event engine does not model adhesion: its balls "
                    "separate without a pull-off force. engine = \"soft\" models it.",
                    *law)));
  if (balls(outcome.mill_case) > 1) append(notes, contact_notices(outcome, stop));
  return notes;
}

}  // namespace mahlwerk::campaign

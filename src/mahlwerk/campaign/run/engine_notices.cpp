// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/engine_notices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/pilot.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/run/step_check.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/lammps/notices.hpp"

namespace mahlwerk::campaign {
namespace {

std::string in_percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Above one of these shares, two pilot runs measure the effect of the contact time (man.8): of
/// hits that begin within it, and of power withheld by the TC rule.
constexpr double many_hits_within = 0.3, withheld_share_limit = 0.02;

/// Shares of contact in a run, over all its replicates.
struct Contacts {
  double share = 0;        ///< [1] of the balls' time in contact
  double withheld = 0;     ///< [1] power that the TC rule withheld, over the dissipated power
  double hits_within = 0;  ///< [1] share of the hits that begin within t_c of another
  std::int64_t hits = 0;   ///< above the threshold
  std::int64_t collisions = 0;
};

Contacts contacts_of(const results::Outcome& outcome) {
  const auto balls = static_cast<double>(cases::balls_count(outcome.mill_case.balls));
  double time = 0, contact = 0, lost = 0, withheld = 0;
  std::int64_t collisions = 0, hits = 0, within = 0;
  for (const results::Replicate& r : outcome.replicates) {
    time += r.time() * balls;
    contact += r.energy_balance.contact_time - r.at_settled.contact_time;
    lost += r.energy_balance.lost() - r.at_settled.lost();
    withheld += r.energy_balance.withheld - r.at_settled.withheld;
    collisions += r.energy_balance.collisions;
    hits += r.tally.above.count;
    within += r.energy_balance.hits_within - r.at_settled.hits_within;
  }
  return {time > 0 ? contact / time : 0, lost > 0 ? withheld / lost : 0,
          hits > 0 ? static_cast<double>(within) / static_cast<double>(hits) : 0, hits, collisions};
}

/// [1] Share of the hits above the threshold that several balls keep at a softening, at least:
/// softer contacts last longer, so that more hits join into one (eng.1).
double hits_kept(double softening) {
  return 1 / (1 + 0.07 * (math::pow(softening, -0.4) - 1));
}

/// Effect of hits of bodies that touch others on a run of the event engine.
Notices hit_notices(const Contacts& contacts) {
  constexpr std::int64_t few = 100;  // results::settling_warnings() warns of fewer
  if (contacts.hits_within <= hits_within_limit || contacts.hits < few) return {};
  const bool much = contacts.hits_within > many_hits_within;
  return {warning(
      "simultaneous-hits",
      fmt::format("{} of the hits above the threshold begin within contact.contact_time of another "
                  "hit of the same body. Bodies that touch several others at the same time share "
                  "an impact; the event engine resolves it into impacts of two. Above {} the rate "
                  "of hits and their mean energy differ from those of engine = \"soft\" by up to "
                  "{}; the power does not.",
                  in_percent(contacts.hits_within),
                  in_percent(much ? many_hits_within : hits_within_limit),
                  much ? "40 %" : "20 %"))};
}

/// Effect of sustained contacts on a run of the event engine, from its shares of contact and two
/// pilot runs.
Notices contact_notices(const results::Outcome& outcome, const std::atomic<bool>* stop) {
  constexpr double mostly_in_contact = 0.25;  // an effect that is not known is then likely
  const Contacts contacts = contacts_of(outcome);
  Notices notes = hit_notices(contacts);
  if (contacts.share > contact_share_limit)
    notes.push_back(warning(
        "long-contacts",
        fmt::format(
            "Balls were in contact {} of the time. The event engine resolves such "
            "contacts into many small bounces: the total number of collisions and the "
            "forces inside the bed are not those of sustained contacts. Above {} the rate "
            "of hits differs from that of engine = \"soft\" by up to 40 %, their mean energy "
            "by up to 30 %, and the power by up to 10 %.",
            in_percent(contacts.share), in_percent(contact_share_limit))));
  if (contacts.share <= contact_share_limit && contacts.withheld <= withheld_share_limit &&
      contacts.hits_within <= many_hits_within)
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
        {"contact-time", contacts.share > mostly_in_contact ? Severity::invalid : Severity::warning,
         fmt::format("It is uncertain whether the result depends on contact.contact_time. {}",
                     words)});
  return notes;
}

/// Says how many hits softened contacts join.
Notices softening_notices(const cases::Case& mill_case) {
  constexpr double few = 0.1;
  const double joined = 1 - hits_kept(std::min(1.0, mill_case.contact.softening));
  if (cases::balls_count(mill_case.balls) == 1 || !(joined > few)) return {};
  return {warning(
      "softened-hits",
      fmt::format(
          "Contacts are softened (contact.softening = {:.2g}) and last longer, so that hits "
          "of several balls join: the rate of hits is up to {} % too low and their mean "
          "energy up to {} % too high. Weak hits join more often: the number of all collisions, "
          "and means over them, change more. Power and the sum of the energies change by some "
          "per cent at most.",
          mill_case.contact.softening, two_digits(100 * joined),
          two_digits(100 * joined / (1 - joined))))};
}

}  // namespace

Notices engine_notices(const results::Outcome& outcome, const EngineChoice& choice,
                       const std::atomic<bool>* stop) {
  Notices notes;
  for (const std::string& reason : choice.reason) notes.push_back(note("engine-chosen", reason));
  if (std::string grains = cases::grains_note(outcome.mill_case); !grains.empty())
    notes.push_back(note("powder-as-grains", std::move(grains)));
  if (choice.engine == cases::EngineName::lammps) {
    append(notes, lammps::notices(outcome.mill_case));
    int most = 0;
    for (const results::Replicate& r : outcome.replicates) most = std::max(most, r.restarts);
    append(notes, lammps::restart_notices(most));
  }
  if (cases::in_time_steps(choice.engine)) {
    append(notes, soft_notices(outcome.mill_case));
    append(notes, speed_notices(outcome.mill_case, largest_collision_speed(outcome)));
    append(notes, softening_notices(outcome.mill_case));
    return notes;
  }
  if (const auto law = adhesive_law(outcome.mill_case))
    notes.push_back(invalid(
        "sticking-law-ignored",
        fmt::format("law = \"{}\" is adhesive. The event engine does not model adhesion: its balls "
                    "separate without a pull-off force. engine = \"soft\" models it.",
                    *law)));
  if (cases::balls_count(outcome.mill_case.balls) > 1)
    append(notes, contact_notices(outcome, stop));
  return notes;
}

}  // namespace mahlwerk::campaign

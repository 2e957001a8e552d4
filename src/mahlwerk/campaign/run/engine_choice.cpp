// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/engine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/pilot.hpp"
#include "mahlwerk/campaign/run/settled_state.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/run/step_check.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/lammps/notices.hpp"

namespace mahlwerk::campaign {
namespace {

/// [1] Overlap over the radius of balls that collide at the highest expected speed, up to which
/// "auto" softens contacts (docs/theory/engine-choice.md).
constexpr double softened_overlap = 0.1;

/// [1] Share of the hits above the threshold that several balls keep at a softening, at least:
/// softer contacts last longer, so that more hits join into one (eng.1).
double hits_kept(double softening) {
  return 1 / (1 + 0.07 * (math::pow(softening, -0.4) - 1));
}

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

/// Balls times steps of the soft engine, of all replicates.
double work_of(const cases::Case& mill_case) {
  return soft_work(mill_case) * static_cast<double>(mill_case.run.replicates);
}

/// "20 seconds", "40 minutes" or "15 hours" of one core, for so many balls times steps.
std::string core_time(double work) {
  const double seconds = work * ball_step_cost;
  if (seconds < 100) return fmt::format("{} seconds", two_digits(seconds));
  if (seconds < 6000) return fmt::format("{} minutes", two_digits(seconds / 60));
  return fmt::format("{} hours", two_digits(seconds / 3600));
}

cases::Case with_softening(cases::Case mill_case, double softening) {
  mill_case.contact.softening = softening;
  return mill_case;
}

/// Whether "auto" may soften contacts: the case gives no softening and no time step, and its law
/// has nothing but stiffness that a softer contact would change.
bool may_soften(const cases::Case& soft) {
  const auto given = std::ranges::find(soft.origins, "contact.softening", &cases::Origin::key);
  const bool own = given != soft.origins.end() && !given->assumed;
  return !own && !soft.run.time_step && contact::adhesion(*soft.contact.model.law).empty() &&
         contact::name_of(*soft.contact.model.law) != "thornton-ning" && !soft.liquid;
}

/// The largest softening with which the case takes no more than comfortable_work, or the least
/// that keeps the overlap of balls at the highest expected speed below softened_overlap. None if
/// the case as it is satisfies this, or if softening changes nothing.
std::optional<double> softening_of(const cases::Case& soft) {
  const double work = work_of(soft);
  if (work <= comfortable_work || !may_soften(soft)) return std::nullopt;
  // The step grows with the inverse root of the stiffness, the overlap with its power -2/5.
  const double overlap = soft_settings(soft).steps.overlap;
  double softening = math::pow(comfortable_work / work, 2);
  softening = std::max(softening, math::pow(overlap / softened_overlap, 2.5));
  softening = std::max(least_softening, softening);
  const double digit = math::pow(10, std::floor(math::log10(softening)) - 1);
  softening = std::ceil(softening / digit) * digit;
  if (!(softening < 1) || work_of(with_softening(soft, softening)) > 0.9 * work)
    return std::nullopt;
  return softening;
}

std::string softening_in_words(const cases::Case& soft, double softening) {
  const cases::Case softer = with_softening(soft, softening);
  return fmt::format(
      "Contacts are softened (contact.softening = {:.2g}), because stiff ones would take about {} "
      "of one core instead of {}: balls that collide at {} overlap by {} % of their radius. "
      "contact.softening = 1 computes stiff contacts.",
      softening, core_time(work_of(soft)), core_time(work_of(softer)),
      show_rounded(soft_settings(softer).speed, "m/s", 2),
      two_digits(100 * soft_settings(softer).steps.overlap));
}

/// Why a pilot run of the settled mill says that the event engine is not valid, in words; empty if
/// it is.
std::string against_event(const cases::Case& soft, const std::atomic<bool>* stop) {
  cases::Case event = soft;
  event.run.engine = cases::EngineName::event;
  if (!run_faults(event).empty()) return run_faults(event).front().what;
  constexpr double most_work = 1e9;  // about half a minute
  const auto settled = settled_state(event, most_work, stop);
  if (!settled) return "The mill takes too long to settle for a pilot run.";
  event = settled->mill_case;
  const Pilot p = pilot(event, stop);
  if (p.stopped) return "A pilot run with the event engine stopped early: balls are wedged.";
  if (p.contact_share > contact_share_limit)
    return fmt::format(
        "In a settled pilot run of {:.3g} s with the event engine, balls were in contact {} of the "
        "time, more than {}.",
        p.time, percent(p.contact_share), percent(contact_share_limit));
  if (p.hits_within > hits_within_limit)
    return fmt::format(
        "In a settled pilot run of {:.3g} s with the event engine, {} of the hits followed another "
        "within contact.contact_time, more than {}.",
        p.time, percent(p.hits_within), percent(hits_within_limit));
  const ContactTimeEffect effect = contact_time_effect(event, stop);
  return effect.matters() || !effect.known() ? in_words(effect, event) : "";
}

/// The only engine that can run the case; none if both can.
std::optional<EngineChoice> only_engine(const cases::Case& mill_case) {
  const auto choose = [](cases::EngineName engine, std::string why) {
    return EngineChoice{engine, {std::move(why)}};
  };
  if (!geometry::exact_touches(*mill_case.jar.shape))
    return choose(cases::EngineName::soft,
                  fmt::format("Engine: soft, chosen by auto. The event engine does not support a "
                              "jar of kind \"{}\".",
                              geometry::name_of(*mill_case.jar.shape)));
  if (cases::fits_exactly(mill_case))
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. Two balls fit exactly across the jar, where hard "
                  "spheres have no room to bounce.");
  if (cases::liquid_needs_soft(mill_case))
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. The event engine has no liquid around the balls.");
  cases::Case soft = mill_case;
  soft.run.engine = cases::EngineName::soft;
  const std::vector<Fault> wrong = run_faults(soft);
  if (!wrong.empty())
    return choose(
        cases::EngineName::event,
        fmt::format("Engine: event, chosen by auto. The soft engine cannot run the case: {}.",
                    wrong.front().what));
  if (const auto law = sticking(mill_case))
    return choose(cases::EngineName::soft,
                  fmt::format("Engine: soft, chosen by auto. law = \"{}\" is adhesive, and the "
                              "event engine does not model adhesion.",
                              *law));
  if (balls(mill_case) == 1)
    return choose(
        cases::EngineName::event,
        "Engine: event, chosen by auto. The motion of a single ball is computed exactly.");
  return std::nullopt;
}

/// Adds softening to a choice of the soft engine, if the run would take long.
EngineChoice softened(EngineChoice choice, const cases::Case& soft) {
  choice.softening = softening_of(soft);
  if (choice.softening) choice.reason.push_back(softening_in_words(soft, *choice.softening));
  return choice;
}

void set_origin(cases::Case& mill_case, std::string_view key, std::string value,
                std::string source) {
  const auto origin = std::ranges::find(mill_case.origins, key, &cases::Origin::key);
  if (origin == mill_case.origins.end()) return;
  origin->value = std::move(value);
  origin->source = std::move(source);
}

}  // namespace

EngineChoice choose_engine(const cases::Case& mill_case, const std::atomic<bool>* stop) {
  using cases::EngineName;
  if (mill_case.run.engine != EngineName::automatic) return {mill_case.run.engine};
  cases::Case soft = mill_case;
  soft.run.engine = EngineName::soft;
  soft.run.time = cases::counted_time(mill_case);
  if (const auto only = only_engine(mill_case))
    return only->engine == EngineName::soft ? softened(*only, soft) : *only;
  EngineChoice choice = softened(
      {EngineName::soft, {"Engine: soft, chosen by auto. It resolves contacts in time."}}, soft);
  const double work = work_of(with_softening(soft, choice.softening.value_or(1)));
  if (work <= max_soft_work) return choice;
  const std::string against = against_event(soft, stop);
  if (against.empty())
    return {
        EngineName::event,
        {fmt::format("Engine: event, chosen by auto. The soft engine would take about {} of one "
                     "core, and a settled pilot run shows that the event engine is valid.",
                     core_time(work))}};
  choice.reason.push_back(
      fmt::format("The run takes about {} of one core: less time, fewer replicates or a smaller "
                  "contact.softening shorten it. The event engine is not valid here. {}",
                  core_time(work), against));
  return choice;
}

cases::Case decided_case(const cases::Case& mill_case, const EngineChoice& choice) {
  cases::Case decided = mill_case;
  decided.run.engine = choice.engine;
  if (choice.softening) {
    decided.contact.softening = *choice.softening;
    set_origin(decided, "contact.softening", fmt::format("{}", *choice.softening),
               "chosen by engine = \"auto\", for a shorter run");
  }
  const double counted = cases::counted_time(mill_case);
  cases::Case longer = decided;
  longer.run.time = counted;
  const bool too_long = counted > 2 * mill_case.run.time && cases::in_time_steps(choice.engine) &&
                        run_faults(decided).empty() && work_of(longer) > max_soft_work;
  if (counted != mill_case.run.time && !too_long) {
    decided.run.time = counted;
    set_origin(decided, "run.time", fmt::format("\"{}\"", show(counted, "s")),
               fmt::format("whole periods of the mill for {}", show(mill_case.run.time, "s")));
  }
  if (choice.engine == cases::EngineName::lammps && !decided.run.settle)
    decided.run.settle = cases::least_settling(mill_case);
  return decided;
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
        {"contact-time", contacts.share > mostly_in_contact ? Severity::invalid : Severity::warning,
         fmt::format("It is uncertain whether the result depends on contact.contact_time. {}",
                     words)});
  return notes;
}

/// Says how many hits softened contacts join.
Notices softening_notices(const cases::Case& mill_case) {
  constexpr double few = 0.1;
  const double joined = 1 - hits_kept(std::min(1.0, mill_case.contact.softening));
  if (balls(mill_case) == 1 || !(joined > few)) return {};
  return {warning(
      "softened-hits",
      fmt::format(
          "Contacts are softened (contact.softening = {:.2g}) and last longer, so that hits "
          "of several balls join: the rate of hits is up to {} % too low and their mean "
          "energy up to {} % too high. Power and the sum of the energies change by some "
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
  if (choice.engine == cases::EngineName::lammps) append(notes, lammps::notices(outcome.mill_case));
  if (cases::in_time_steps(choice.engine)) {
    append(notes, soft_notices(outcome.mill_case));
    append(notes, speed_notices(outcome.mill_case, largest_collision_speed(outcome)));
    append(notes, softening_notices(outcome.mill_case));
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

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
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/powder_feedback.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/wall_faces.hpp"

namespace mahlwerk::campaign {
namespace {

/// [1] Overlap over the radius of balls that collide at the highest expected speed, up to which
/// "auto" softens contacts (docs/theory/engine-choice.md).
constexpr double softened_overlap = 0.1;

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
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
  if (const std::string wall = cases::soft_only_wall(mill_case); !wall.empty())
    return choose(
        cases::EngineName::soft,
        fmt::format("Engine: soft, chosen by auto. The event engine does not support {}.", wall));
  if (cases::fits_exactly(mill_case))
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. Two balls fit exactly across the jar, where hard "
                  "spheres have no room to bounce.");
  if (cases::liquid_needs_soft(mill_case))
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. The event engine has no liquid around the balls.");
  if (mill_case.bed_breakage)
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. In the event engine no grains break.");
  if (mill_case.flow)
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. In the event engine no ball leaves the jar or "
                  "enters it.");
  if (cases::has_bodies(mill_case))
    return choose(cases::EngineName::soft,
                  "Engine: soft, chosen by auto. The event engine computes spheres only.");
  const auto law = adhesive_law(mill_case);
  if (cases::balls_count(mill_case.balls) == 1 && !law)
    return choose(
        cases::EngineName::event,
        "Engine: event, chosen by auto. The motion of a single ball is computed exactly.");
  cases::Case soft = mill_case;
  soft.run.engine = cases::EngineName::soft;
  const std::vector<Fault> wrong = run_faults(soft);
  if (!is_of_values(wrong))
    return choose(
        cases::EngineName::event,
        fmt::format("Engine: event, chosen by auto. The soft engine cannot run the case: {}.",
                    wrong.front().what));
  if (law)
    return choose(cases::EngineName::soft,
                  fmt::format("Engine: soft, chosen by auto. law = \"{}\" is adhesive, and the "
                              "event engine does not model adhesion.",
                              *law));
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

std::optional<std::string_view> adhesive_law(const cases::Case& mill_case) {
  const contact::PairTable pairs = cases::pair_table(mill_case);
  const auto any = [&](const contact::AdhesionParameter& adhesion) {
    return std::ranges::any_of(pairs.all(),
                               [&](const auto& pair) { return pair.*adhesion.value > 0; });
  };
  const contact::AnyLaw& law = *mill_case.contact.model.law;
  if (!std::ranges::any_of(contact::adhesion(law), any)) return std::nullopt;
  return contact::name_of(law);
}

EngineChoice choose_engine(const cases::Case& mill_case, const std::atomic<bool>* stop) {
  using cases::EngineName;
  if (mill_case.run.engine != EngineName::automatic) return {mill_case.run.engine};
  cases::Case soft = mill_case;
  soft.run.engine = EngineName::soft;
  soft.run.time = cases::expected_time(mill_case);
  if (soft.run.time > 2 * mill_case.run.time && run_faults(soft).empty() &&
      work_of(with_softening(soft, softening_of(soft).value_or(1))) > max_soft_work)
    soft.run.time = mill_case.run.time;  // as decided_case() does
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
  choice.reason.push_back(fmt::format(
      "The run takes about {} of one core: less time, fewer replicates or a smaller "
      "contact.softening shorten it{}. The event engine is not valid here. {}",
      core_time(work),
      mill_case.run.settle ? "" : ", and run.settle = \"0 s\" counts from the start", against));
  return choice;
}

EngineChoice choose_engine_and_bounce(const cases::Case& mill_case, const std::atomic<bool>* stop) {
  EngineChoice choice = choose_engine(mill_case, stop);
  const auto* feedback = mill_case.parts.find<cases::PowderFeedback>();
  if (feedback == nullptr) return choice;
  choice.powder = powder_effect(decided_case(mill_case, choice), stop);
  if (choice.powder) choice.reason.push_back(in_words(*choice.powder, feedback->accuracy));
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
  if (choice.powder) return with_powder(std::move(decided), *choice.powder);
  return decided;
}

}  // namespace mahlwerk::campaign

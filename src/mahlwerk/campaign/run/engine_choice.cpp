// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/engine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"

namespace mahlwerk::campaign {
namespace {

struct Nobody final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

std::int64_t balls(const cases::Case& what) {
  std::int64_t count = 0;
  for (const cases::BallSet& set : what.balls) count += set.count;
  return count;
}

/// What the share of time in contact of a short run by the event engine says.
struct Pilot {
  double time = 0;   ///< [s] simulated
  double share = 0;  ///< of the balls' time in contact, in the second half
};

Pilot pilot(const cases::Case& what, const std::atomic<bool>* stop) {
  constexpr int parts = 100;
  constexpr std::int64_t enough = 400'000;  // collisions: half a second or so of work
  const double whole = std::min(1.0, what.run.settle + what.run.time);
  const auto trial = engine(what, 0, 1, stop);
  Nobody nobody;
  std::vector<scene::Account> seen{trial->account()};
  try {
    for (int i = 1; i <= parts && seen.back().collisions < enough; ++i) {
      if (stop != nullptr && *stop) break;
      trial->advance(whole * i / parts, nobody);
      seen.push_back(trial->account());
    }
  } catch (const RunError&) {  // what it saw until then has to do
  }
  const scene::Account &middle = seen[seen.size() / 2], &end = seen.back();
  const double time = (end.time - middle.time) * static_cast<double>(balls(what));
  return {end.time, time > 0 ? (end.contact_time - middle.contact_time) / time : 0};
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Of the balls' time, over all replicates.
double contact_share(const results::Outcome& outcome) {
  double time = 0, contact = 0;
  for (const results::Replicate& r : outcome.replicates) {
    time += r.time() * static_cast<double>(balls(outcome.what));
    contact += r.account.contact_time - r.at_settled.contact_time;
  }
  return time > 0 ? contact / time : 0;
}

/// The name of the contact law, if bodies stick together by it.
const char* sticking(const cases::Case& what) {
  const contact::PairTable pairs = cases::pair_table(what);
  const auto any = [&](double contact::Pair::*property) {
    return std::ranges::any_of(pairs.all(), [&](const auto& pair) { return pair.*property > 0; });
  };
  const contact::LawName law = what.contact.law_choice.law;
  if (law == contact::LawName::jkr && any(&contact::Pair::surface_energy)) return "jkr";
  if (law == contact::LawName::sjkr && any(&contact::Pair::cohesion)) return "sjkr";
  return nullptr;
}

/// What keeps "auto" from the soft engine, as the end of a sentence; empty if nothing does.
std::string against_soft(const cases::Case& what) {
  cases::Case soft = what;
  soft.run.engine = "soft";
  const std::vector<Fault> wrong = run_faults(soft);
  if (!wrong.empty()) return wrong.front().what;
  const double time = (what.run.time + what.run.settle) * static_cast<double>(what.run.replicates);
  const double work = static_cast<double>(balls(what)) * time / soft_settings(soft).rules.time_step;
  if (work <= most_soft_work) return "";
  return fmt::format(
      "it would take some {:.0f} hours of a core; engine = \"soft\" asks for it, and softening "
      "makes it fewer",
      std::max(2.0, work / most_soft_work));
}

}  // namespace

Choice choose(const cases::Case& what, const std::atomic<bool>* stop) {
  if (what.run.engine != "auto") return {what.run.engine, {}};
  if (!geometry::exact_touches(what.jar.shape))
    return {"soft",
            {fmt::format("Engine: soft, chosen by auto. The event engine does not take a jar of "
                         "kind \"{}\".",
                         geometry::name_of(what.jar.shape))}};
  if (const char* law = sticking(what); law != nullptr && against_soft(what).empty())
    return {"soft",
            {fmt::format("Engine: soft, chosen by auto. law = \"{}\" holds balls together, which "
                         "the event engine does not know.",
                         law)}};
  if (balls(what) == 1)
    return {"event",
            {"Engine: event, chosen by auto. One ball flies, bounces, rolls and slides exactly."}};
  cases::Case event = what;
  event.run.engine = "event";
  const Pilot p = pilot(event, stop);
  const std::string seen = fmt::format(
      "In a pilot run of {:.3g} s by the event engine the balls were in contact {} of the time.",
      p.time, percent(p.share));
  if (p.share <= most_contact)
    return {"event",
            {fmt::format("Engine: event, chosen by auto. {} Up to {} it is advised.", seen,
                         percent(most_contact))}};
  if (const std::string why = against_soft(what); !why.empty())
    return {
        "event",
        {fmt::format("Engine: event, chosen by auto. {} The soft engine would be advised, but {}.",
                     seen, why)}};
  return {"soft",
          {fmt::format("Engine: soft, chosen by auto. {} Above {} contacts are better "
                       "followed than counted as bounces.",
                       seen, percent(most_contact))}};
}

Notices notes_on(const results::Outcome& outcome, const Choice& choice) {
  Notices notes;
  for (const std::string& reason : choice.reason) notes.push_back(note("engine-chosen", reason));
  if (std::string grains = cases::grains_note(outcome.what); !grains.empty())
    notes.push_back(note("powder-as-grains", std::move(grains)));
  if (choice.engine == "soft") {
    append(notes, soft_notes(outcome.what));
    return notes;
  }
  if (const char* law = sticking(outcome.what))
    notes.push_back(invalid(
        "sticking-law-ignored",
        fmt::format("law = \"{}\" holds balls together. The event engine does not know that: its "
                    "balls part without a pull (engine = \"soft\" follows it).",
                    law)));
  const double share = contact_share(outcome);
  if (balls(outcome.what) > 1 && share > most_contact)
    notes.push_back(invalid(
        "long-contacts",
        fmt::format(
            "The balls were in contact {} of the time. For such a charge the soft engine is "
            "advised "
            "(engine = \"soft\"). Power and dose are sound; the number of hits, and forces inside "
            "the bed, depend on contact.contact_time.",
            percent(share))));
  return notes;
}

}  // namespace mahlwerk::campaign

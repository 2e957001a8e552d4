// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/rolling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double most_of_the_time = 0.5;

struct ThresholdCounter final : scene::Observer {
  explicit ThresholdCounter(double at_least) : threshold(at_least) {}
  void collisions(std::span<const scene::Collision> finished) override {
    for (const scene::Collision& c : finished) above += c.approach >= threshold ? 1 : 0;
  }
  double threshold;
  double above = 0;
};

/// Rates that are compared between the two rules.
struct Rates {
  double time = 0;   ///< [s]
  double power = 0;  ///< [W]
  double hits = 0;   ///< [1/s] above the threshold
};

bool assumed(const cases::Case& mill_case, const char* key) {
  const auto origin = std::ranges::find(mill_case.origins, key, &cases::Origin::key);
  return origin != mill_case.origins.end() && origin->assumed;
}

double contact_share(const std::vector<const results::Replicate*>& chosen) {
  double time = 0, contact = 0;
  for (const results::Replicate* r : chosen) {
    time += r->time();
    contact += r->energy_balance.contact_time - r->at_settled.contact_time;
  }
  return time > 0 ? contact / time : 0;
}

/// Rates of the first replicate in the outcome, over the first `time` [s].
Rates recorded_rates(const results::Replicate& r, double time) {
  Rates found;
  for (const results::Window& w : r.windows) {
    if (w.time > time * (1 + 1e-9)) break;
    found.time += w.length;
    found.power += w.lost;
    found.hits += w.above;
  }
  found.power /= found.time;
  found.hits /= found.time;
  return found;
}

/// Rates of the first replicate with the TC rule, over 1 s or 20 000 collisions, after 5 s of
/// settling at most; the mill runs from the start. The same on any machine.
Rates tc_rates(cases::Case mill_case, double settle) {
  constexpr double long_enough = 1, settled = 5;  // [s]
  constexpr std::int64_t enough = 20'000;
  constexpr int parts = 50;
  mill_case.contact.lasting = cases::SustainedContactModel::tc;
  mill_case.run.engine = cases::EngineName::event;
  if (settle > settled) cases::settle_at_speed(mill_case.run, settle = settled);
  const auto trial = engine(mill_case, 0);
  ThresholdCounter ignored(mill_case.observe.threshold), hits(mill_case.observe.threshold);
  Rates found;
  try {
    trial->advance(settle, ignored);
    const scene::EnergyBalance before = trial->energy_balance();
    const double whole = std::min(mill_case.run.time, long_enough);
    for (int i = 1; i <= parts && trial->energy_balance().collisions - before.collisions < enough;
         ++i) {
      trial->advance(settle + whole * i / parts, hits);
      found.time = trial->energy_balance().time - before.time;
      found.power = (trial->energy_balance().lost() - before.lost()) / found.time;
      found.hits = hits.above / found.time;
    }
  } catch (const RunError&) {  // the rates so far are used
  }
  return found;
}

}  // namespace

Notices rolling_notices(const results::Outcome& outcome) {
  const cases::Case& mill_case = outcome.mill_case;
  const bool guessed =
      assumed(mill_case, "contact.lasting") || assumed(mill_case, "contact.lasting_friction");
  if (outcome.engine != cases::EngineName::event || results::count_of_balls(mill_case) != 1 ||
      !guessed || mill_case.contact.lasting != cases::SustainedContactModel::roll ||
      outcome.interrupted)
    return {};
  const auto chosen = results::averaged_replicates(outcome);
  const double rolled = contact_share(chosen);
  if (!(rolled > most_of_the_time)) return {};
  const Rates tc = tc_rates(mill_case, outcome.replicates.front().at_settled.time),
              roll = recorded_rates(outcome.replicates.front(), tc.time);
  const std::string other =
      tc.time > 0 && roll.time > 0
          ? fmt::format(
                "Its first {} s with the TC rule (contact.lasting = \"tc\") dissipate {} instead "
                "of {}, with {:.3g} instead of {:.3g} hits above the threshold per second.",
                two_digits(tc.time), show_rounded(tc.power, "W"), show_rounded(roll.power, "W"),
                tc.hits, roll.hits)
          : "Compare with contact.lasting = \"tc\".";
  return {warning("mostly-rolling",
                  fmt::format("The ball rolled or slid on the wall {:.0f} % of the time, by a rule "
                              "or a friction that the case does not specify (contact.lasting, "
                              "contact.lasting_friction). {}",
                              100 * rolled, other))};
}

}  // namespace mahlwerk::campaign

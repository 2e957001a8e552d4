// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/powder_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/powder_feedback.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int most_runs = 6;

/// A run of one replicate.
results::Outcome trial_of(const cases::Case& mill_case, const std::atomic<bool>* stop) {
  ReplicateRun trial(mill_case, 0, nullptr, nullptr, 1, stop);
  while (!trial.done()) {
    if (stop != nullptr && *stop) throw Interrupted();
    trial.run_slice();
  }
  results::Outcome outcome{.mill_case = mill_case, .replicates = {trial.result()}};
  outcome.engine = mill_case.run.engine;
  outcome.summary = results::summarise(outcome);
  return outcome;
}

/// Sums over the hits of balls with each other, and with walls: energy, and what powder absorbs.
struct Hits {
  double power = 0, absorbed = 0;  // [W]

  double restitution(double clean) const {  // (fbk.1)
    return power > 0 ? std::sqrt(std::max(0.0, clean * clean - absorbed / power)) : clean;
  }
};
struct AllHits {
  Hits balls, wall;
};
AllHits hits_of(const results::Outcome& outcome, double size, double most, double clean) {
  const results::Replicate& run = outcome.replicates.front();
  const powder::Process process = cases::process(outcome.mill_case);
  const powder::StressSpectrum all = results::stress_spectrum(outcome.mill_case, {&run});
  const powder::Grain grain = process.grain(size);
  AllHits sums;
  for (const powder::Stress& s : all.stresses) {
    const powder::Nip& nip = all.nips[static_cast<std::size_t>(s.nip)];
    if (!(nip.radius > 0)) continue;
    const double mass = process.capture_per_hit(nip, s.energy, size).mean_mass(grain);
    Hits& of = run.tally.by_pair.kinds_of(s.nip).with_jar() ? sums.wall : sums.balls;
    of.power += s.rate * s.energy;
    of.absorbed += s.rate * std::min(most * mass, clean * clean * s.energy);
  }
  return sums;
}

}  // namespace

std::optional<PowderEffect> powder_effect(const cases::Case& decided,
                                          const std::atomic<bool>* stop) try {
  const auto* feedback = decided.parts.find<cases::PowderFeedback>();
  if (feedback == nullptr || feedback->found) return std::nullopt;
  cases::Case clean = decided;
  clean.run.replicates = 1;
  clean.run.until.reset();
  clean.observe = {.threshold = decided.observe.threshold};
  PowderEffect effect;
  effect.clean = effect.balls = effect.wall = decided.contact.rule.restitution.value();
  for (; effect.runs < most_runs;) {
    const results::Outcome outcome = trial_of(with_powder(clean, effect), stop);
    const results::Replicate& run = outcome.replicates.front();
    ++effect.runs;
    effect.power_found = results::value_of(outcome, run, "dissipated_power");
    if (effect.runs == 1) effect.power_clean = effect.power_found;
    double size = decided.powder->size.value_or(0);
    if (decided.grinding) {
      const double ground = results::value_of(outcome, run, "d50");
      if (std::isfinite(ground)) effect.size = size = ground;
    }
    const AllHits hits = hits_of(outcome, size, feedback->absorbed_energy, effect.clean);
    const double balls = hits.balls.restitution(effect.clean),
                 wall = hits.wall.restitution(effect.clean);
    effect.last_change = std::max(std::abs(balls - effect.balls), std::abs(wall - effect.wall));
    if (effect.last_change <= feedback->accuracy) break;
    // Half of the way: more powder damps less hard hits, which absorb less.
    const double way = effect.runs == 1 ? 1 : 0.5;
    effect.balls += way * (balls - effect.balls);
    effect.wall += way * (wall - effect.wall);
  }
  return effect;
} catch (const Interrupted&) {
  return std::nullopt;
} catch (const RunError&) {  // the run itself says so
  return std::nullopt;
}

cases::Case with_powder(cases::Case mill_case, const PowderEffect& effect) {
  const cases::Contact& contact = mill_case.contact;
  const auto rule = [&](std::string other, double restitution) {
    cases::PairRule made{.between = {"balls", std::move(other)},
                         .rule = contact.rule,
                         .rolling_friction = contact.rolling_friction,
                         .surface_energy = contact.surface_energy,
                         .cohesion = contact.cohesion,
                         .surface_tension = contact.surface_tension};
    made.rule.restitution = restitution;
    return made;
  };
  std::vector<cases::PairRule> pairs{rule("balls", effect.balls), rule("jar", effect.wall)};
  if (!mill_case.machine_parts.empty()) pairs.push_back(rule("parts", effect.wall));
  pairs.insert(pairs.end(), contact.pairs.begin(), contact.pairs.end());
  mill_case.contact.pairs = std::move(pairs);
  if (const auto* feedback = mill_case.parts.find<cases::PowderFeedback>()) {
    cases::PowderFeedback found = *feedback;
    found.found = true;
    mill_case.parts.set(found);
  }
  return mill_case;
}

std::string in_words(const PowderEffect& effect, double accuracy) {
  const double change = 100 * (effect.power_found / effect.power_clean - 1);
  return fmt::format(
      "Powder between the bodies ([powder_feedback]): restitution {:.2f} between balls and {:.2f} "
      "at the jar instead of {:.2f}, after {} runs of one replicate, the last of which changed it "
      "by {:.2g}{}. The dissipated power changes by {:+.1f} %.{}",
      effect.balls, effect.wall, effect.clean, effect.runs, effect.last_change,
      effect.last_change > accuracy ? ", more than `accuracy`: it is not consistent" : "", change,
      effect.size ? fmt::format(" The powder is that after the milling time, of {}.",
                                show_rounded(*effect.size, "m", 2))
                  : "");
}

}  // namespace mahlwerk::campaign

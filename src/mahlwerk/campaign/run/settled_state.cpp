// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/settled_state.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/run/start.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"

namespace mahlwerk::campaign {
namespace {

/// The state of the balls as that of each of the replicates that run together, without the overlaps
/// of soft contacts, which would throw stiff balls apart.
cases::StartStates start_states(const cases::Case& mill_case, const ReplicateRun& run,
                                const std::atomic<bool>* stop) {
  std::vector<cases::BallState> states;
  std::vector<scene::Ball> balls =
      seen_from_carrier(mill_case, run.balls(), run.energy_balance().time);
  balls.resize(static_cast<std::size_t>(cases::balls_count(mill_case.balls)));  // no spare grains
  cases::remove_overlaps(mill_case, balls, stop);
  for (const scene::Ball& b : balls)
    states.push_back({b.radius, b.kind, b.position, b.velocity, b.spin, b.orientation});
  std::vector<std::vector<cases::BallState>> all(replicates_together(mill_case), states);
  return {
      .file = "",
      .folder = true,
      .states = std::make_shared<const std::vector<std::vector<cases::BallState>>>(std::move(all))};
}

}  // namespace

std::optional<SettledState> settled_state(const cases::Case& mill_case, double most_work,
                                          const std::atomic<bool>* stop) try {
  if (cases::has_bodies(mill_case)) return std::nullopt;  // remove_overlaps() parts spheres only
  cases::Case softer = mill_case;
  softer.run.engine = cases::EngineName::soft;
  softer.contact.softening = std::min(softer.contact.softening, least_softening);
  softer.run.settle.reset();
  softer.run.replicates = 1;
  softer.run.until.reset();
  if (softer.milling) softer.milling->reverse = false;
  softer.observe = {.threshold = mill_case.observe.threshold};
  if (!cases::settles(softer) || !run_faults(softer).empty() || soft_work(softer) > most_work)
    return std::nullopt;
  ReplicateRun trial(softer, 0, nullptr, nullptr, 1, stop);
  while (!trial.counting_begins() && !trial.done()) {
    if (stop != nullptr && *stop) return std::nullopt;
    trial.run_slice();
  }
  if (!trial.counting_begins()) return std::nullopt;
  SettledState state{mill_case, *trial.counting_begins()};
  state.mill_case.run.start_from = start_states(softer, trial, stop);
  cases::settle_at_speed(state.mill_case.run, 0);
  state.mill_case.run.settle_at_rest = 0;
  return state;
} catch (const Interrupted&) {  // while balls were placed
  return std::nullopt;
} catch (const RunError&) {  // physics stopped it
  return std::nullopt;
} catch (const InputError&) {  // balls that cannot be parted
  return std::nullopt;
}

}  // namespace mahlwerk::campaign

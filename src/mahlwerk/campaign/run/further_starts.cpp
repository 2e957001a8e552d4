// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/further_starts.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/further_runs.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/states.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::int64_t starts = 16;  // replicates and further ones

/// Whether 16 runs cost next to nothing. In a longer run the start matters less, too.
bool is_short(const cases::Case& c) {
  constexpr double most_periods = 200;
  return cases::simulated_time(c) <= most_periods * cases::mill_period(c);
}

/// The case of the further starts, which record nothing but energy.
cases::Case further_case(const results::Outcome& outcome) {
  cases::Case further = without_records(outcome.mill_case);
  further.run.engine = outcome.engine;
  further.run.replicates = starts;
  return further;
}

/// [W] Dissipated by the ball from a start; no value if it was stopped.
std::optional<double> power_from(const cases::Case& further, int start,
                                 const std::atomic<bool>* stop) try {
  ReplicateRun run(further, start, nullptr, nullptr, 1, stop);
  while (!run.done()) {
    if (stop != nullptr && *stop) return std::nullopt;
    run.run_slice();
  }
  const results::Replicate result = run.result();
  return result.complete ? std::optional(results::dissipated_power(result)) : std::nullopt;
} catch (const RunError&) {
  return std::nullopt;
} catch (const Interrupted&) {  // while the ball was placed
  return std::nullopt;
}

std::string group_in_words(const std::vector<double>& powers, bool high, double between) {
  double sum = 0;
  int count = 0;
  for (const double power : powers)
    if ((power > between) == high) sum += power, ++count;
  return fmt::format("{} dissipate {}", count, show_rounded(sum / count, "W"));
}

}  // namespace

Notices further_start_notices(const results::Outcome& outcome, const std::atomic<bool>* stop) {
  const cases::Case& c = outcome.mill_case;
  if (c.run.engine != cases::EngineName::automatic || outcome.engine != cases::EngineName::event ||
      cases::balls_count(c.balls) != 1 || c.run.start_from.states || outcome.summary.two_states ||
      c.run.replicates >= starts || !results::complete(outcome) || c.run.until || !is_short(c))
    return {};
  std::vector<double> powers;
  for (const results::Replicate& r : outcome.replicates)
    powers.push_back(results::dissipated_power(r));
  const cases::Case further = further_case(outcome);
  for (std::int64_t start = c.run.replicates; start < starts; ++start) {
    const auto power = power_from(further, static_cast<int>(start), stop);
    if (!power) return {};
    powers.push_back(*power);
  }
  const auto groups = results::power_groups(powers, 0);
  if (!groups) return {};
  return {warning(
      "state-of-start",
      fmt::format("The start decides what the ball does: of {} starts, the replicates of this run "
                  "and further ones, {} and {}. The result holds for the states of its "
                  "replicates; run.replicates = {} shows both.",
                  starts, group_in_words(powers, false, groups->between),
                  group_in_words(powers, true, groups->between), starts))};
}

}  // namespace mahlwerk::campaign

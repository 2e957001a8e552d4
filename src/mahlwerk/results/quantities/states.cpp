// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/observe/groups.hpp"
#include "mahlwerk/results/quantities/means.hpp"

namespace mahlwerk::results {
namespace {

constexpr const char* power_name = "dissipated_power";

/// [W] Powers below this are rounding errors of the kinetic energy over the counted time.
double rounding_power(const std::vector<const Replicate*>& chosen) {
  constexpr double rounding = 1e-9;
  double most = 0;
  for (const Replicate* r : chosen)
    for (const Window& w : r->windows) most = std::max(most, rounding * w.kinetic / r->time());
  return most;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// "3 of 16 replicates (19 %) dissipate 4.21 W +- 0.3 W".
std::string words(const TwoStates& found, std::size_t which) {
  const State& state = found.states[which];
  const Quantity& q = named(state.quantities, power_name);
  const std::size_t all = found.states[0].replicates.size() + found.states[1].replicates.size();
  std::string text = fmt::format("{} of {} replicates ({}) dissipate {}", state.replicates.size(),
                                 all, percent(found.share(state)), show_rounded(q.value, q.unit));
  if (std::isfinite(q.ci95)) text += " +- " + show_rounded(q.ci95, q.unit, 2);
  return text;
}

}  // namespace

std::optional<observe::TwoGroups> power_groups(const std::vector<double>& powers, double rounding) {
  constexpr double much = 0.2;  // of the larger power
  if (!std::ranges::all_of(powers, [](double p) { return std::isfinite(p); })) return std::nullopt;
  const auto groups = observe::two_groups(powers);
  if (!groups) return std::nullopt;
  double sum[2] = {0, 0}, count[2] = {0, 0};
  for (const double power : powers) {
    sum[power > groups->between] += power;
    ++count[power > groups->between];
  }
  const double low = sum[0] / count[0], high = sum[1] / count[1];
  const double larger = std::max(std::abs(low), std::abs(high));
  if (!(high - low > much * larger) || !(larger > rounding)) return std::nullopt;
  return groups;
}

double TwoStates::share(const State& state) const {
  return static_cast<double>(state.replicates.size()) /
         static_cast<double>(states[0].replicates.size() + states[1].replicates.size());
}

std::optional<TwoStates> two_states(const Outcome& outcome, const std::vector<Measure>& measures,
                                    const std::vector<std::vector<double>>& each) {
  std::vector<double> powers;
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  for (const Replicate* r : chosen) powers.push_back(dissipated_power(*r));
  const auto groups = power_groups(powers, rounding_power(chosen));
  if (!groups) return std::nullopt;
  TwoStates found{.states = {}, .p_value = groups->p_value};
  for (std::size_t i = 0; i < chosen.size(); ++i)
    found.states[powers[i] > groups->between ? 1 : 0].replicates.push_back(
        number_of(outcome, *chosen[i]));
  for (State& state : found.states)
    state.quantities = means(measures, each, state.replicates, Interval::of_mean);
  return found;
}

Notices state_notices(const Summary& summary) {
  const auto& found = summary.two_states;
  if (!found) return {};
  return {warning(
      "two-states",
      fmt::format("The replicates fall into two states: {}, {}. One normal distribution splits as "
                  "sharply with a probability of {:.2g} %. A mean over both states, with its "
                  "interval, describes neither.",
                  words(*found, 0), words(*found, 1), 100 * found->p_value))};
}

}  // namespace mahlwerk::results

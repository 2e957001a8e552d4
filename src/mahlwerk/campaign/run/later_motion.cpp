// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/later_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/further_runs.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int later_replicates = 3;
constexpr double times_later = 4, times_longer = 2;  // of the run; of its counted time

/// Whether the balls are few enough to move in step, and a run that simulates `whole` [s] so short
/// that this matters.
bool may_change(const cases::Case& c, double whole) {
  constexpr std::int64_t few = 6;
  constexpr double short_run = 40;  // periods of the mill
  return cases::settles(c) && c.run.engine == cases::EngineName::automatic && !c.run.until &&
         !c.run.start_from.states && !c.uncertainty && c.run.replicates >= later_replicates &&
         cases::balls_count(c.balls) <= few && whole <= short_run * cases::mill_period(c);
}

/// The case of the later part, which records nothing but hits.
cases::Case later_case(const results::Outcome& outcome) {
  cases::Case later = without_records(outcome.mill_case);
  const results::Replicate& first = outcome.replicates.front();
  later.run.engine = outcome.engine;
  later.run.settle = times_later * first.energy_balance.time;
  later.run.time = times_longer * first.time();
  later.run.replicates = later_replicates;
  return later;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// "dissipated power 139 uW instead of 294 uW" if the later values are all below or all above those
/// of the run, and their mean differs by more than a fifth; else empty.
std::string change(const results::Quantity& q, const std::vector<double>& counted,
                   const std::vector<double>& later) {
  constexpr double much = 0.2;
  const auto [low, high] = std::ranges::minmax(counted);
  const auto [least, most] = std::ranges::minmax(later);
  const double before = mean_of(counted), after = mean_of(later);
  if (!std::isfinite(before) || !std::isfinite(after) || !(most < low || least > high) ||
      !(std::abs(after - before) > much * std::max(std::abs(before), std::abs(after))))
    return "";
  return fmt::format("{} {} instead of {}", results::label_of(q.name),
                     show_rounded(after, q.unit, 3), show_rounded(before, q.unit, 3));
}

}  // namespace

double later_motion_cost(const cases::Case& mill_case, double settling) {
  const double whole = settling + mill_case.run.time;
  if (!may_change(mill_case, whole)) return 0;
  const double each = times_later * whole + times_longer * mill_case.run.time;
  return later_replicates * each / (static_cast<double>(mill_case.run.replicates) * whole);
}

Notices later_motion_notices(const results::Outcome& outcome, const RunOptions& options) {
  if (!results::complete(outcome) ||
      !may_change(outcome.mill_case, outcome.replicates.front().energy_balance.time))
    return {};
  const results::Outcome later = run(later_case(outcome), without_files(options));
  if (!results::complete(later)) return {};
  std::string changes;
  for (const std::string_view name : first_answers) {
    const results::Quantity& q = results::named(outcome.summary.quantities, name);
    std::vector<double> counted, after;
    for (const results::Replicate& r : outcome.replicates)
      counted.push_back(results::value_of(outcome, r, q.name));
    for (const results::Replicate& r : later.replicates)
      after.push_back(results::value_of(later, r, q.name));
    if (const std::string one = change(q, counted, after); !one.empty())
      changes += (changes.empty() ? "" : ", ") + one;
  }
  if (changes.empty()) return {};
  return {warning(
      "changes-later",
      fmt::format("{} s after the start the balls move otherwise: {}, in {} replicates that went "
                  "on. Write run.settle = \"{} s\" for the motion that lasts.",
                  two_digits(*later.mill_case.run.settle), changes, later_replicates,
                  two_digits(*later.mill_case.run.settle)))};
}

}  // namespace mahlwerk::campaign

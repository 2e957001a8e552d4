// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/other_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/further_runs.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double soft_is_longer = 4;  // so that the scatter is that of the result alone

/// Whether the engine was chosen for one ball, and the soft engine takes next to no time.
bool is_cheap(const results::Outcome& outcome) {
  constexpr double most = 20;  // [s] simulated by the soft engine; a second or two of computing
  const cases::Case& c = outcome.mill_case;
  return c.run.engine == cases::EngineName::automatic &&
         outcome.engine == cases::EngineName::event && cases::balls_count(c.balls) == 1 &&
         !c.run.until && !c.run.start_from.states && !c.uncertainty && c.run.replicates >= 2 &&
         results::complete(outcome) &&
         soft_is_longer * static_cast<double>(c.run.replicates) * cases::simulated_time(c) <= most;
}

/// "hits above the threshold 80 /s instead of 66 /s" if the quantities differ by more than a tenth
/// and by 1.2 times their joint half-width; else empty.
std::string difference(const results::Quantity& event, const results::Quantity& soft) {
  constexpr double much = 0.1, certain = 1.2;
  const double apart = std::abs(event.value - soft.value);
  if (!(apart > much * std::max(std::abs(event.value), std::abs(soft.value))) ||
      !(apart > certain * math::hypot(event.ci95, soft.ci95)))
    return "";
  return fmt::format("{} {} instead of {}", results::label_of(event.name),
                     show_rounded(soft.value, soft.unit, 3),
                     show_rounded(event.value, event.unit, 3));
}

}  // namespace

Notices other_engine_notices(const results::Outcome& outcome, const RunOptions& options) {
  if (!is_cheap(outcome)) return {};
  cases::Case soft_case = without_records(outcome.mill_case);
  soft_case.run.engine = cases::EngineName::soft;
  soft_case.run.time *= soft_is_longer;
  if (!run_faults(soft_case).empty()) return {};
  const results::Outcome soft = run(soft_case, without_files(options));
  if (!results::complete(soft)) return {};
  std::string differences;
  for (const std::string_view name : first_answers)
    if (const std::string one = difference(results::named(outcome.summary.quantities, name),
                                           results::named(soft.summary.quantities, name));
        !one.empty())
      differences += (differences.empty() ? "" : ", ") + one;
  if (differences.empty()) return {};
  return {warning(
      "engines-differ",
      fmt::format(
          "The soft engine gives {}. The event engine, which is the faster for one ball, "
          "lets surfaces stick or slide at a bounce by a rule, the soft engine computes the "
          "forces of the contact (contact.tangential_restitution, contact.law). Write "
          "run.engine = \"soft\" for its result.",
          differences))};
}

}  // namespace mahlwerk::campaign

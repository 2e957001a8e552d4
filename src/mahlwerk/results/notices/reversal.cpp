// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a drive whose sense of rotation changes means for the result (docs/theory/kinematics.md).
#include "mahlwerk/cases/reversal.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "mahlwerk/results/notices/warnings.hpp"

namespace mahlwerk::results {
namespace {

/// [W] Mean dissipated power of the averaged replicates in each sense; that of the case first.
std::array<double, 2> power_by_sense(const Outcome& outcome) {
  std::array<double, 2> lost{}, time{};
  for (const Replicate* r : averaged_replicates(outcome)) {
    const std::size_t sense = (number_of(outcome, *r) - 1) % 2;
    lost[sense] += r->energy_balance.lost() - r->at_settled.lost();
    time[sense] += r->time();
  }
  return {lost[0] / time[0], lost[1] / time[1]};
}

}  // namespace

Notices reversal_notices(const Outcome& outcome) {
  const cases::Case& c = outcome.mill_case;
  if (!c.milling || !c.milling->reverse) return {};
  if (!cases::needs_both_senses(c))
    return {note("reversed-drive",
                 "The sense of rotation changes after each cycle. Jar and gravity are their own "
                 "mirror image, so that the means are the same in both senses: every replicate "
                 "turns as the case says.")};
  const auto power = power_by_sense(outcome);
  if (!std::isfinite(power[0] + power[1]))
    return {warning("reversed-drive",
                    "The sense of rotation changes after each cycle, but the replicates that ended "
                    "all turn in one sense: means are those of this sense alone.")};
  return {note(
      "reversed-drive",
      fmt::format("The sense of rotation changes after each cycle. Replicates 2, 4, ... turn the "
                  "other way, and means are those of both senses. Dissipated power: {:.3g} W in "
                  "the sense of the case, {:.3g} W in the other.",
                  power[0], power[1]))};
}

}  // namespace mahlwerk::results

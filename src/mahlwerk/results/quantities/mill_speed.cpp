// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/mill_speed.hpp"

#include <cmath>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

double mill_rate(const cases::Case& c, const scene::EnergyBalance& from,
                 const scene::EnergyBalance& to) {
  const kinematics::SpeedProgram& program = c.mill.speed_over_time;
  if (!program.empty())
    return share(program.travel(to.time) - program.travel(from.time), to.time - from.time);
  if (!c.drive) return 1;
  return share(to.mill_angle - from.mill_angle,
               (to.time - from.time) * std::abs(cases::speed_without_load(c)));
}

double mill_rate(const cases::Case& c, const Replicate& r) {
  return mill_rate(c, r.at_settled, r.energy_balance);
}

double mill_rate(const Outcome& outcome) {
  const auto chosen = averaged_replicates(outcome);
  if (chosen.empty()) return 1;
  return mean_over(chosen, [&](const Replicate& r) { return mill_rate(outcome.mill_case, r); });
}

double mill_speed(const cases::Case& c, const Replicate& r) {
  return cases::shaft_speed(c).value_or(0) * mill_rate(c, r);
}

}  // namespace mahlwerk::results

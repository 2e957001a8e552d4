// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::event {

/// Returns the error of the Zeno guard (inelastic collapse): at `time` [s] since the start of the
/// run `events` events took place within `within` [s]. The remedy in the text depends on
/// `sustained_mode`, the treatment of sustained contacts in force.
RunError zeno_error(double time, double within, std::int64_t events,
                    SustainedContactMode sustained_mode);

/// Throws RunError if a collision gained energy. No rule of the engine does that, so it is an error
/// of the program. `mass` [kg] is the effective mass, `approach` and `slip` [m/s] are those of the
/// collision, `time` [s] counts from the start of the run.
void reject_energy_gain(const contact::Loss& loss, double mass, double approach, double slip,
                        double time);

/// Updates EnergyBalance::worst_collision with a collision in which the bodies gained the kinetic
/// energy `gained`, the wall did the work `work` and the energy `lost` was lost; `before` is the
/// kinetic energy before it. All in J.
inline void check_balance(scene::EnergyBalance& balance, double gained, double work, double lost,
                          double before) {
  const double residual =
      std::abs(gained - work + lost) / (before + std::abs(work) + std::abs(lost) + 1e-300);
  if (!(residual <= balance.worst_collision)) balance.worst_collision = residual;  // NaN counts
}

}  // namespace mahlwerk::event

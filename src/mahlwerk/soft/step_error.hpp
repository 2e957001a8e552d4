// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"

namespace mahlwerk::soft {

/// Upper bounds of the error that the time step gives a collision, at any angle. The first three
/// are means over the time of touch within a step: errors of rates, powers and mean speeds.
struct StepError {
  double rebound = 0;  ///< [1] of the normal rebound speed, or a tenth of the impact speed if more
  double tangential = 0;  ///< [1] error of the tangential speed, over its initial value
  double spin = 0;        ///< [1] error of the spin, over that of rolling or gross slip
  double single = 0;      ///< [1] largest of these errors in a single collision
  double largest_mean() const;
};

/// Error bounds from the law's table at 25 steps per collision (contact::StepErrors), interpolated
/// in the restitution. In longer steps the error grows with the square of the step; in shorter
/// ones it falls in proportion to the step.
StepError step_error(const contact::AnyLaw& law, double restitution, double steps_per_collision);

/// Fewest steps per collision for which largest_mean() is at most `error` [1], > 0. At least 16:
/// below, friction makes single collisions err by more than about 5 %.
double steps_per_collision(const contact::AnyLaw& law, double restitution, double error);

}  // namespace mahlwerk::soft

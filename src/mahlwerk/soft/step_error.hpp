// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"

namespace mahlwerk::soft {

/// Upper bounds of the time discretisation error of a collision at any angle.
struct StepError {
  double rebound = 0;     ///< [1] relative error of the normal rebound speed
  double tangential = 0;  ///< [1] error of the tangential speed, over its initial value
  double spin = 0;        ///< [1] error of the spin, over that of rolling or gross slip
};

/// Error bounds from the law's table at fifty steps per collision (contact::StepErrors),
/// interpolated in the restitution. Beyond 1/50 of a collision per step the error grows with the
/// square of the step; below, it falls in proportion to the step.
StepError step_error(const contact::AnyLaw& law, double restitution, double steps_per_collision);

}  // namespace mahlwerk::soft

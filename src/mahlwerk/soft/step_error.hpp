// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"

namespace mahlwerk::soft {

/// What a time step leaves a collision off by at most, whatever its angle.
struct StepError {
  double rebound = 0;     ///< [1] of the speed along the normal, relative
  double tangential = 0;  ///< [1] of the speed across it, of what it was
  double spin = 0;        ///< [1] of the spin, of that which rolling or gross slip would give
};

/// By law and restitution, from the law's table at fifty steps a collision (contact::StepErrors),
/// that grows with the square of longer steps and falls with shorter ones.
StepError step_error(const contact::AnyLaw& law, double restitution, double steps_per_collision);

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// How far the charge spreads and how fast it moves, and what collisions do along the wall.
namespace mahlwerk::results {

/// Occupied share of the jar's cross-section, of tumbling and planetary mills, and the balls'
/// speeds (obs.9).
std::vector<Measure> motion_measures(const cases::Case& what);

/// Energy of the motion across the normal, in a collision and in a second, and the share of grazing
/// impacts.
const std::vector<Measure>& tangential_measures();

}  // namespace mahlwerk::results

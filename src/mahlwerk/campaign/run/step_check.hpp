// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// [m/s] Largest collision speed of the counted time: the mean of the highest occupied bin of its
/// histogram, at most 19 % below the largest; 0 without collisions.
double largest_collision_speed(const results::Outcome& outcome);

/// After a run in time steps: says if bodies collided so much faster than expected before the run
/// that the stated errors of the time step do not hold; a warning where one exceeds 2 %. `speed`
/// [m/s] is the largest seen.
Notices speed_notices(const cases::Case& mill_case, double speed);

}  // namespace mahlwerk::campaign

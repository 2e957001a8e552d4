// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "mahlwerk/event/ball_states.hpp"

namespace mahlwerk::event {

/// The earliest collision found; partner < 0: none.
struct PredictedCollision {
  double time = never;  ///< [s] on the engine's clock
  std::int32_t partner = -1;
};

/// A ball at an instant, to be tested for collisions with others.
struct CollisionQuery {
  Vec3 position, velocity;
  double time, radius;
  std::int32_t self;  ///< its own index
};

/// Returns the earliest collision of the ball `query` with one of `others` (indices of
/// `trajectories`), or `best` if none is earlier (man.2). `radii` [m] by species; `periods` [m] of
/// a periodic box, infinite for any other jar.
using CollisionSearch = PredictedCollision(const CollisionQuery& query,
                                           std::span<const Trajectory> trajectories,
                                           std::span<const std::int32_t> others,
                                           std::span<const double> radii, const Vec3& periods,
                                           const PredictedCollision& best);
/// The search for the instruction set isa(). All instruction sets give the same bits.
CollisionSearch* collision_search();

/// Minimum image convention (geo.8): the difference `a` [m] of two positions at most 1.5 periods
/// apart, each component taken to within half a period.
inline Vec3 nearest_image(Vec3 a, const Vec3& periods) {
  const auto fold = [](double x, double period) {
    if (x > 0.5 * period) return x - period;
    if (x < -0.5 * period) return x + period;
    return x;
  };
  return {fold(a.x, periods.x), fold(a.y, periods.y), fold(a.z, periods.z)};
}

}  // namespace mahlwerk::event

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "mahlwerk/event/ball_states.hpp"

namespace mahlwerk::event {

struct PredictedCollision {
  double time = never;
  std::int32_t partner = -1;
};

/// A ball at an instant, about to be held against others.
struct CollisionQuery {
  Vec3 position, velocity;
  double time, radius;
  std::int32_t self;  ///< its own index
};

/// The earliest meeting of `query` with one of `others` (indices of `trajectories`) before `best`
/// (man.2). `radii` by species; `periods` [m] where the box repeats itself, infinite where it does
/// not.
PredictedCollision earliest_collision(const CollisionQuery& query,
                                      std::span<const Trajectory> trajectories,
                                      std::span<const std::int32_t> others,
                                      std::span<const double> radii, const Vec3& periods,
                                      const PredictedCollision& best);

/// `a` as seen from the nearest image.
inline Vec3 nearest_image(Vec3 a, const Vec3& periods) {
  const auto fold = [](double x, double period) {
    if (x > 0.5 * period) return x - period;
    if (x < -0.5 * period) return x + period;
    return x;
  };
  return {fold(a.x, periods.x), fold(a.y, periods.y), fold(a.z, periods.z)};
}

}  // namespace mahlwerk::event

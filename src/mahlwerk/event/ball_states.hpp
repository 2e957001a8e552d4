// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

// Ball data of the event engine for many balls. The data that a collision prediction reads of a
// ball fills one cache line.
namespace mahlwerk::event {

constexpr double never = std::numeric_limits<double>::infinity();

/// Trajectory of a ball between two collisions: a straight line in the falling frame (man.1).
struct alignas(64) Trajectory {
  Vec3 position;               ///< [m] at `since`
  double since = 0;            ///< [s] on the engine's clock
  Vec3 velocity;               ///< [m/s]
  std::uint32_t revision = 0;  ///< predictions for an older one are void (lazy invalidation)
  std::uint32_t species = 0;

  Vec3 at(double t) const { return position + (t - since) * velocity; }
};
static_assert(sizeof(Trajectory) == 64);

/// The next event of a ball.
struct Prediction {
  double collision_time = never;  ///< [s] of the earliest one predicted for it, with `partner`
  std::int32_t partner = -1;
  std::uint32_t partner_revision = 0;  ///< of the partner's trajectory, at the prediction
  /// [s] If face >= 0: predicted touch of that face. Otherwise: next safe-time query; until then
  /// the ball touches no wall and stays in its cell.
  double wall_check_time = 0;
  std::int32_t face = -1;
  std::int32_t cell = 0;

  double next() const {
    return collision_time < wall_check_time ? collision_time : wall_check_time;
  }
};

/// Ball data that only collisions need.
struct CollisionData {
  Vec3 spin;                       ///< [rad/s]
  double last_collision = -never;  ///< [s] of its last collision
  double stored_energy = 0;        ///< [J] of earlier losses (man.6)
  std::int32_t id = 0;             ///< the user's ball number; the storage index changes
};

/// Properties of balls of one size, density, kind and inertia ratio [m, kg, kg m2, kg/m3].
struct Species {
  double radius = 0, mass = 0, inertia = 0, density = 0;
  std::int32_t kind = 0;
  double inertia_ratio = 0;  ///< [1] inertia / (mass radius^2)
};

}  // namespace mahlwerk::event

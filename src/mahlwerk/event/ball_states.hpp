// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

// Many balls as the event engine keeps them: what a prediction of meetings reads fills one cache
// line.
namespace mahlwerk::event {

constexpr double never = std::numeric_limits<double>::infinity();

/// A ball between two of its collisions: a straight line in the falling frame (man.1).
struct alignas(64) Trajectory {
  Vec3 position;               ///< [m] at `since`
  double since = 0;            ///< [s] on the engine's clock
  Vec3 velocity;               ///< [m/s]
  std::uint32_t revision = 0;  ///< how often it has changed: an appointment made before is void
  std::uint32_t species = 0;

  Vec3 at(double t) const { return position + (t - since) * velocity; }
};
static_assert(sizeof(Trajectory) == 64);

/// What a ball is up to next.
struct Prediction {
  double collision_time = never;  ///< [s] with `partner`, the earliest of its own
  std::int32_t partner = -1;
  std::uint32_t partner_revision = 0;  ///< when that was predicted
  double safe_until = 0;   ///< [s] until then it certainly touches no wall and has not left
  std::int32_t face = -1;  ///< that it touches then; < 0: it must be looked at
  std::int32_t cell = 0;

  double next() const { return collision_time < safe_until ? collision_time : safe_until; }
};

/// What only collisions need.
struct CollisionData {
  Vec3 spin;                       ///< [rad/s]
  double last_collision = -never;  ///< [s] of its last collision
  double stored_energy = 0;        ///< [J] of earlier losses (man.6)
  std::int32_t id = 0;             ///< the user's number of it; where it is stored changes
};

/// Balls of one size, density and set.
struct Species {
  double radius = 0, mass = 0, inertia = 0, density = 0;
  std::int32_t kind = 0;
};

}  // namespace mahlwerk::event

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"

// Bodies of FewBodySolver, eight by eight (array of structures of arrays): the numbers of a body
// are at constant distances from each other, so one offset addresses them all.
namespace mahlwerk::soft {

inline Vec3 get_lane(const Vec<Lanes>& a, std::size_t lane) {
  return {a.x[lane], a.y[lane], a.z[lane]};
}
inline void set_lane(Vec<Lanes>& a, std::size_t lane, const Vec3& b) {
  a.x[lane] = b.x, a.y[lane] = b.y, a.z[lane] = b.z;
}

/// What contacts read of eight bodies: balls, or wall contact points (structure of arrays).
struct BodyBlock {
  Vec<Lanes> position{};          ///< [m] in the jar frame
  Vec<Lanes> velocity{};          ///< [m/s] predicted (dem.26)
  Vec<Lanes> angular_velocity{};  ///< [rad/s] predicted
};

/// The other numbers of eight balls.
struct BallBlock {
  Vec<Lanes> velocity{}, spin{};  ///< [m/s], [rad/s] at the end of the step
  Vec<Lanes> force{}, torque{};   ///< [N], [N m] of the contacts
  Vec<Lanes> list_position{};     ///< [m] when the neighbour list was built
  Lanes displacement_squared{};   ///< [m2] since then
  Lanes half_kick_factor{};       ///< [s/kg] half a step over mass
  Lanes half_spin_kick_factor{};  ///< [s/(kg m2)] half a step over inertia
  LaneMask used{};                ///< lanes of balls; the other lanes of the last block fall freely
};

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/collision_columns.hpp"

#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::results {
namespace {

using scene::Collision;

constexpr CollisionColumn record_columns[] = {
    {"time", "s", "time of first contact, since the start of the run", offsetof(Collision, time)},
    {"duration", "s",
     "duration of the contact; in the event engine from its first to its last bounce",
     offsetof(Collision, duration)},
    {"ball", "1", "number of the ball, from 0", offsetof(Collision, ball), true},
    {"other", "1", "number of the other ball; below 0: face -1 - other of the jar",
     offsetof(Collision, other), true},
    {"where_x", "m", "x of the contact point, in the jar's own rotating axes",
     offsetof(Collision, where) + offsetof(Vec3, x)},
    {"where_y", "m", "y of the contact point, likewise",
     offsetof(Collision, where) + offsetof(Vec3, y)},
    {"where_z", "m", "z of the contact point, likewise",
     offsetof(Collision, where) + offsetof(Vec3, z)},
    {"normal_x", "1", "x of the unit normal from the ball's centre to the contact, same axes",
     offsetof(Collision, normal) + offsetof(Vec3, x)},
    {"normal_y", "1", "y of the unit normal, likewise",
     offsetof(Collision, normal) + offsetof(Vec3, y)},
    {"normal_z", "1", "z of the unit normal, likewise",
     offsetof(Collision, normal) + offsetof(Vec3, z)},
    {"mass", "kg", "effective mass", offsetof(Collision, mass)},
    {"approach", "m/s", "normal speed u_n at first contact", offsetof(Collision, approach)},
    {"slip", "m/s", "tangential speed |u_t| of the contact points, spin included",
     offsetof(Collision, slip)},
    {"glide", "m/s", "tangential speed of the centres, without spin", offsetof(Collision, glide)},
    {"impulse", "N s", "impulse along the normal", offsetof(Collision, impulse)},
    {"lost_normal", "J", "energy dissipated along the normal", offsetof(Collision, lost_normal)},
    {"lost_tangential", "J", "energy dissipated across the normal",
     offsetof(Collision, lost_tangential)},
    {"feature", "1",
     "where the ball was hit, if it is no sphere: 1 face, 2 edge, 3 corner, 4 side, 5 cap; else 0",
     offsetof(Collision, feature), true},
    {"other_feature", "1", "where the other ball was hit, likewise",
     offsetof(Collision, other_feature), true},
};

}  // namespace

std::span<const CollisionColumn> collision_columns() {
  return record_columns;
}

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/device/arrays.hpp"
#include "mahlwerk/soft/device/atomics.hpp"

// Kernels of the balls: a call moves one ball, or sums over every 16384th (docs/theory/soft.md).
namespace mahlwerk::soft {

/// Force and torque on a ball.
struct BallLoad {
  Vec<double> force{}, torque{};
  bool touches = false;  ///< something, in this step
};

/// Sums the forces on a ball in the order of its pairs: those of which it is the first ball, those
/// of which it is the second, and those with faces.
inline BallLoad load_on(const DeviceArrays& a, std::int32_t k) {
  const ContactList& list = a.list;
  BallLoad load;
  const auto add_first = [&](std::int32_t p) {
    const Touch touch = list.touch[p];
    if (touch == Touch::apart) return;
    load.touches = load.touches || touch == Touch::touching;
    load.force = load.force + a.forces[p].force;
    load.torque = load.torque + a.forces[p].torque_i;
  };
  for (std::int32_t p = list.pair_first[k]; p < list.pair_first[k + 1]; ++p) add_first(p);
  for (std::int32_t n = a.incoming_first[k]; n < a.incoming_first[k + 1]; ++n) {
    const std::int32_t p = a.incoming[n];
    const Touch touch = list.touch[p];
    if (touch == Touch::apart) continue;
    load.touches = load.touches || touch == Touch::touching;
    load.force = load.force - a.forces[p].force;
    load.torque = load.torque + a.forces[p].torque_j;
  }
  for (std::int32_t n = list.wall_first[k]; n < list.wall_first[k + 1]; ++n)
    add_first(list.pairs + n);
  return load;
}

/// Velocity Verlet (dem.26): advances a ball to the next step. Halts the run there if the ball has
/// moved by half the skin since the lists were built, or is nowhere.
inline void move_ball(const DeviceArrays& a, std::int64_t index) {
  if (a.halted()) return;
  const auto k = static_cast<std::int32_t>(index);
  const BallLoad load = load_on(a, k);
  if (load.touches) atomic_add(&a.balls_in_contact[k % a.contact_counters], 1);
  const VectorPair& factor = a.half_kicks[a.now.species[k]];
  const StepInput* input = &a.input();
  const double dt = a.constants.dt;
  const Vec3 before = dt * input[0].drive.body_acceleration,
             after = 0.5 * dt * input[1].drive.body_acceleration;
  VectorPair& half = a.now.half_step[k];
  BallRecord& row = a.now.rows[k];
  SpinRecord& spin = a.now.spins[k];
  const auto kick = [](double& velocity, double half_kick, double body_before, double body_after) {
    velocity = velocity + 2.0 * half_kick + body_before;
    return velocity + half_kick + body_after;
  };
  row.u = kick(half.x, factor.x * load.force.x, before.x, after.x);
  row.v = kick(half.y, factor.y * load.force.y, before.y, after.y);
  row.w = kick(half.z, factor.z * load.force.z, before.z, after.z);
  spin.x = kick(half.a, factor.a * load.torque.x, 0, 0);
  spin.y = kick(half.b, factor.b * load.torque.y, 0, 0);
  spin.z = kick(half.c, factor.c * load.torque.z, 0, 0);
  row.x = row.x + dt * half.x;
  row.y = row.y + dt * half.y;
  row.z = row.z + dt * half.z;
  const double moved = squared(row.position() - a.reference[k]);
  if (moved < 0.25 * a.skin * a.skin) return;
  if (!(moved < 1e300)) atomic_lower(&a.control->bad_ball, a.now.id[k]);
  set_shared(a.control->halt_at, a.control->step + 1);
  set_shared(a.control->moved, 1);
}

/// Ends a step that was computed; by one thread.
inline void end_step(const DeviceArrays& a, std::int64_t) {
  if (!a.halted()) ++a.control->step;
}

/// Energy of the balls at the present step. Rows are one step ahead.
struct BallTotals {
  double kinetic = 0, potential = 0;
};
inline void sum_balls(const DeviceArrays& a, std::int64_t index) {
  BallTotals sum;
  const StateSums& at = a.state_sums;
  for (auto k = static_cast<std::int32_t>(index); k < a.balls; k += a.partials) {
    const BallRecord& row = a.now.rows[k];
    const SpinRecord& spin = a.now.spins[k];
    const VectorPair& half = a.now.half_step[k];
    const Vec3 v{half.x, half.y, half.z}, w{half.a, half.b, half.c};
    const Vec3 velocity = 2.0 * v - Vec3{row.u, row.v, row.w} + at.kick_change + at.frame_velocity;
    const Vec3 turning = 2.0 * w - Vec3{spin.x, spin.y, spin.z};
    const std::int32_t s = a.now.species[k];
    sum.kinetic += 0.5 * (a.mass[s] * squared(velocity) + a.inertia[s] * squared(turning));
    sum.potential -=
        a.mass[s] * dot(at.gravity, row.position() - a.constants.dt * v + at.frame_centre);
  }
  reinterpret_cast<BallTotals*>(a.partial)[index] = sum;
}

/// Sums of the listed pairs. `collected`: taken away from them.
template <bool collected>
inline void sum_work(const DeviceArrays& a, std::int64_t index) {
  ContactSums sum;
  for (auto p = static_cast<std::int32_t>(index); p < a.list.size(); p += a.partials) {
    sum.add(a.sums[p]);
    if constexpr (collected) a.sums[p] = {};
  }
  reinterpret_cast<ContactSums*>(a.partial)[index] = sum;
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mahlwerk/soft/many/solver.hpp"

// The liquid: forces on balls and on pairs that do not touch.
namespace mahlwerk::soft {

/// Pairs that do not touch are those of the Verlet lists. A pair with a ball of another chunk is in
/// the lists of both chunks; each adds the force on its own ball and half the work.
void ManyBodySolver::add_liquid_forces(const ChunkStep& step, Chunk& chunk, BallForces& forces) {
  LiquidWork& work = chunk.sums.liquid;
  const auto record = [&](std::int32_t ball) -> const BallRecord& {
    return rows_[static_cast<std::size_t>(ball)];
  };
  const auto velocity_of = [](const BallRecord& r) { return Vec3{r.u, r.v, r.w}; };
  const auto add = [&](std::int32_t ball, const Vec3& f, const Vec3& torque) {
    VectorPair& sum = forces[static_cast<std::size_t>(ball - chunk.first)];
    sum.x += f.x, sum.y += f.y, sum.z += f.z;
    sum.a += torque.x, sum.b += torque.y, sum.c += torque.z;
  };
  const auto balls = [&](const NeighbourPair& pair) {
    const BallRecord &a = record(pair.ball), &b = record(pair.other);
    const bool own = pair.other >= chunk.first && pair.other < chunk.last;
    const Vec3 force = liquid_->between_balls(
        pairs_[pairs_.ball_pair_index(species_[static_cast<std::size_t>(pair.ball)],
                                      species_[static_cast<std::size_t>(pair.other)])],
        a.radius + b.radius, nearest(b.position() - a.position()), velocity_of(a) - velocity_of(b),
        own ? 1 : 0.5, work);
    add(pair.ball, force, {});
    if (own) add(pair.other, -force, {});
  };
  const auto wall = [&](const NeighbourPair& pair) {
    const int face = ~pair.other;
    const BallRecord& a = record(pair.ball);
    const Vec3& turning = face < jar_->first_rotor_face() ? step.drive.spin : step.drive.rotor_spin;
    const std::int32_t mine = species_[static_cast<std::size_t>(pair.ball)];
    add(pair.ball,
        liquid_->at_wall(pairs_[pairs_.wall_pair_index(mine, face)], a.radius,
                         jar_->gap(face, a.position(), wall_axes_, a.radius + pull_off_distance_),
                         a.position(), velocity_of(a), turning, step.drive.velocity, work),
        {});
  };
  const auto each = [&](const VerletList& list, double decrease, const auto& f) {
    const std::size_t due = list.due(decrease + pull_off_distance_, step.bin);
    std::for_each_n(list.pairs.begin(), due, f);
    std::for_each(list.separated.begin(), list.separated.end(), f);
  };
  each(chunk.ball_pairs, chunk.max_gap_decrease, balls);
  each(chunk.wall_pairs, chunk.max_wall_gap_decrease, wall);
  if (!liquid_->acts_on_balls()) return;
  const LiquidMotion motion = liquid_->motion(*jar_, step.drive, step.time);
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const SpinRecord& w = spins_[static_cast<std::size_t>(i)];
    const LiquidLoad load =
        liquid_->on_ball(motion, pairs_.species(species_[static_cast<std::size_t>(i)]),
                         record(i).position(), velocity_of(record(i)), {w.x, w.y, w.z}, work);
    add(i, load.force, load.torque);
  }
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/solver.hpp"

// The liquid: forces on balls and on pairs that do not touch.
namespace mahlwerk::soft {

/// The forces on the balls at the start, for the first half kick. Contacts have none yet.
void FewBodySolver::start_in_liquid() {
  if (!liquid_->acts_on_balls()) return;
  DriveSample drive;
  jar_->sample_drive(start_, settings_.time_step, 0, {&drive, 1});
  const LiquidMotion motion = liquid_->motion(*jar_, drive, start_);
  LiquidWork ignored;
  for (std::size_t b = 0; b < particles_.count; ++b) {
    const LiquidLoad load = liquid_->on_ball(motion, pairs_.species_of(b), particles_.position(b),
                                             particles_.velocity(b), particles_.spin(b), ignored);
    set_lane(particles_.balls[b / lanes].force, b % lanes, load.force);
    set_lane(particles_.balls[b / lanes].torque, b % lanes, load.torque);
  }
}

/// Adds the forces of the liquid at the present step, and the second half kick by them.
void FewBodySolver::add_liquid(const DriveSample& drive) {
  ParticleData& w = particles_;
  LiquidWork work;
  const auto add = [&](std::size_t ball, const Vec3& force, const Vec3& torque) {
    BallBlock& block = w.balls[ball / lanes];
    const std::size_t l = ball % lanes;
    set_lane(block.force, l, get_lane(block.force, l) + force);
    set_lane(block.torque, l, get_lane(block.torque, l) + torque);
    set_lane(block.velocity, l, get_lane(block.velocity, l) + block.half_kick_factor[l] * force);
    set_lane(block.spin, l, get_lane(block.spin, l) + block.half_spin_kick_factor[l] * torque);
  };
  const auto predicted = [&](std::size_t ball) {
    return get_lane(w.bodies[ball / lanes].velocity, ball % lanes);
  };
  const double t = mill_time(w.step);
  for (const NearPair& c : listed_pairs_) {
    const auto i = static_cast<std::size_t>(c.i);
    const double radius = initial_balls_[i].radius;
    const std::int32_t mine = pairs_.species_index(i);
    if (c.face >= 0) {
      const Vec3 x = w.position(i);
      const Vec3& turning = c.face < jar_->first_rotor_face() ? drive.spin : drive.rotor_spin;
      add(i,
          liquid_->at_wall(pairs_[pairs_.wall_pair_index(mine, c.face)], radius,
                           jar_->gap(c.face, x, t, radius + pull_off_distance_), x, predicted(i),
                           turning, drive.velocity, work),
          {});
      continue;
    }
    const auto j = static_cast<std::size_t>(c.j);
    const Vec3 force = liquid_->between_balls(
        pairs_[pairs_.ball_pair_index(mine, pairs_.species_index(j))],
        radius + initial_balls_[j].radius, nearest(w.position(j) - w.position(i)),
        predicted(i) - predicted(j), 1, work);
    add(i, force, {});
    add(j, -force, {});
  }
  if (liquid_->acts_on_balls()) {
    const LiquidMotion motion = liquid_->motion(*jar_, drive, t);
    for (std::size_t b = 0; b < w.count; ++b) {
      const Vec3 spin = get_lane(w.bodies[b / lanes].angular_velocity, b % lanes);
      const LiquidLoad load =
          liquid_->on_ball(motion, pairs_.species_of(b), w.position(b), predicted(b), spin, work);
      add(b, load.force, load.torque);
    }
  }
  energy_balance_.lost_liquid += work.lost;
  energy_balance_.wall_work += work.wall;
}

/// Whether a ball is so near a wall that the liquid acts between them.
bool FewBodySolver::liquid_at_wall() const {
  const double t = mill_time(particles_.step), reach = liquid_->gap_reach(pairs_.all());
  for (std::size_t b = 0; b < particles_.count; ++b) {
    const double within = initial_balls_[b].radius + reach;
    for (int face = 0; face < jar_->faces(); ++face)
      if (jar_->distance(face, particles_.position(b), t, within) < within) return true;
  }
  return false;
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

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

/// Finds the bodies and the parameters of the listed pairs, in their order.
void FewBodySolver::build_liquid_neighbours() {
  const ParticleData& w = particles_;
  LiquidNeighbours& to = liquid_neighbours_;
  to.pairs.assign((listed_pairs_.size() + lanes - 1) / lanes, {});
  to.acting.resize(to.pairs.size());
  for (LiquidPairs& p : to.pairs) p.body_i.fill(body_address(0)), p.body_j.fill(body_address(0));
  const contact::Liquid& liquid = liquid_->liquid();
  for (const PairPacket& packet : w.packets)
    for (std::size_t from = 0; from < lanes; ++from) {
      if (!packet.used[from]) continue;
      const NearPair pair = pair_of(packet, from);
      const auto at = std::ranges::lower_bound(listed_pairs_, pair);
      if (at == listed_pairs_.end() || *at != pair) throw Archive::broken();
      const auto n = static_cast<std::size_t>(at - listed_pairs_.begin()), l = n % lanes;
      const double radius = pairs_[packet.species_pair[from]].effective.radius;  // of the pair
      LiquidPairs& p = to.pairs[n / lanes];
      p.body_i[l] = body_address(packet.i[from]), p.body_j[l] = body_address(packet.j[from]);
      p.ball_i[l] = at->i, p.ball_j[l] = at->j;
      p.radii[l] = packet.radius_i[from] + packet.radius_j[from];
      p.resistance[l] = liquid.resistance(radius), p.reach[l] = liquid.gap_reach(radius);
      p.touch_squared[l] = p.radii[l] * p.radii[l];
      p.reach_squared[l] = (p.radii[l] + p.reach[l]) * (p.radii[l] + p.reach[l]);
    }
  to.balls.assign(w.balls.size(), {});
  for (std::size_t b = 0; b < w.count; ++b) {
    to.balls[b / lanes].radius[b % lanes] = pairs_.species_of(b).radius;
    to.balls[b / lanes].displaced_mass[b % lanes] = liquid_->displaced_mass(pairs_.species_of(b));
  }
}

/// Adds the forces of the liquid at the present step, and the second half kick by them.
void FewBodySolver::add_liquid(const DriveSample& drive) {
  static const auto loop = Multiversioned<LiquidLoop, void (*)(LiquidStep&)>::best();
  ParticleData& w = particles_;
  LiquidStep step{.forces = *liquid_,
                  .motion = liquid_->motion(*jar_, drive, mill_time(w.step)),
                  .periodic = periodic_,
                  .periods = jar_->periods(),
                  .neighbours = liquid_neighbours_,
                  .count = w.count,
                  .bodies = w.bodies.data(),
                  .balls = w.balls.data(),
                  .work = {}};
  loop(step);
  energy_balance_.lost_liquid += step.work.lost;
  energy_balance_.wall_work += step.work.wall;
}

/// Whether a ball is so near a wall that the liquid acts between them.
bool FewBodySolver::liquid_at_wall() const {
  const WallAxes axes = jar_->axes(mill_time(particles_.step));
  const double reach = liquid_->gap_reach(pairs_.all());
  for (std::size_t b = 0; b < particles_.count; ++b) {
    const double within = initial_balls_[b].radius + reach;
    for (int face = 0; face < jar_->faces(); ++face)
      if (jar_->distance(face, particles_.position(b), axes, within) < within) return true;
  }
  return false;
}

}  // namespace mahlwerk::soft

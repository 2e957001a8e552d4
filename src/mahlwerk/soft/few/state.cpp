// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mahlwerk/kinematics/drive.hpp"
#include "mahlwerk/soft/few/solver.hpp"
#include "mahlwerk/soft/solver_state.hpp"

// State of the balls, forces and checkpoints.
namespace mahlwerk::soft {

std::vector<scene::Ball> FewBodySolver::balls() const {
  std::vector<scene::Ball> all = initial_balls_;
  const FreeFlight way = free_flight(now_ - particles_.step);
  for (std::size_t b = 0; b < all.size(); ++b) {
    const Vec3 v = particles_.velocity(b);
    all[b].position = jar_->within_period(particles_.position(b) + way.time * v + way.shift);
    all[b].velocity = v + way.gain;
    all[b].spin = particles_.spin(b);
  }
  return all;
}

/// Contact forces of the last step; 0 in a skip.
std::vector<Vec3> FewBodySolver::forces() const {
  std::vector<Vec3> all(initial_balls_.size());
  for (std::size_t b = 0; b < all.size(); ++b)
    all[b] = get_lane(particles_.balls[b / lanes].force, b % lanes);
  return all;
}

void FewBodySolver::serialize(Archive& archive) {
  if (archive.reading() && archive.begins_with(SolverState::mark))
    throw RunError(SolverState::of_few_balls);
  ParticleData& w = particles_;
  archive(w.step)(w.wall_points_due)(w.list_step)(w.touched);
  archive(now_)(skip_end_)(next_skip_)(skipped_steps_);
  const std::size_t blocks = w.balls.size();
  archive(w.bodies)(w.balls);
  archive(w.packets)(w.wall_neighbours)(contacts_of_)(listed_pairs_);
  archive(energy_balance_)(balls_in_contact_)(contact_count_step_)(watch_)(target_time_);
  rest_.serialize(archive);
  if (!loads_.empty()) archive(loads_);
  if (kinematics::Drive* drive = jar_->drive()) drive->serialize(archive);
  if (w.bodies.size() <= blocks || w.balls.size() != blocks) throw Archive::broken();
  if (!archive.reading()) return;
  w.contacts = 0;
  for (const PairPacket& p : w.packets) w.contacts += std::ranges::count(p.touching.values, -1);
  build_gather_maps();
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/solver.hpp"

// Balls, forces, checkpoints.
namespace mahlwerk::soft {

std::vector<scene::Ball> FewBodySolver::balls() const {
  std::vector<scene::Ball> all = made_of_;
  const Flown way = flown(now_ - particles_.step);
  for (std::size_t b = 0; b < all.size(); ++b) {
    const Vec3 v = particles_.velocity.one(b);
    all[b].position = particles_.position.one(b) + way.time * v + way.shift;
    all[b].velocity = v + way.gain;
    all[b].spin = particles_.spin.one(b);
  }
  return all;
}

/// Those of the last step; in a skip there are none.
std::vector<Vec3> FewBodySolver::forces() const {
  std::vector<Vec3> all(made_of_.size());
  for (std::size_t b = 0; b < all.size(); ++b) all[b] = particles_.force.one(b);
  return all;
}

void FewBodySolver::carry(Archive& archive) {
  ParticleData& w = particles_;
  archive(w.step)(w.wall_points_due)(now_)(skip_end_)(next_skip_)(list_step_)(touched_);
  for (Columns* c : {&w.position, &w.velocity_predicted, &w.spin_predicted, &w.velocity, &w.spin,
                     &w.force, &w.torque, &w.list_positions})
    archive(c->x)(c->y)(c->z);
  archive(w.packets)(w.near)(contacts_of_)(listed_);
  archive(account_)(in_touch_)(in_touch_since_)(watch_)(asked_);
  if (w.position.x.size() < w.blocks || w.velocity.x.size() != w.blocks) throw Archive::broken();
  if (archive.reading()) find_owners();
}

}  // namespace mahlwerk::soft

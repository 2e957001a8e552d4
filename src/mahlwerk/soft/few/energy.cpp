// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <tuple>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/few/solver.hpp"
#include "mahlwerk/soft/mill_drive.hpp"

namespace mahlwerk::soft {

StoredEnergy FewBodySolver::elastic_energy(const PairPacket& p, std::size_t l) const {
  if (p.touching[l] == 0) return {};
  const double law_history[contact::law_history_size] = {p.law_history[0][l], p.law_history[1][l]};
  const Vec3 separation = nearest(particles_.position(static_cast<std::size_t>(p.j[l])) -
                                  particles_.position(static_cast<std::size_t>(p.i[l])));
  const double overlap = p.radius_i[l] + p.radius_j[l] - norm(separation);
  if (has_left_face(p, l, overlap)) return {};
  return stored_energy(p, l, overlap, law_history, get_lane(p.spring, l), p.twist[l],
                       settings_.model);
}

StoredEnergy FewBodySolver::elastic_energy() const {
  StoredEnergy energy;
  for (const PairPacket& p : particles_.packets)
    for (std::size_t l = 0; l < lanes; ++l) energy.add(elastic_energy(p, l), 1);
  return energy;
}

/// What open contacts have dissipated goes to the balance. What they store remains in their sums.
void FewBodySolver::begin_counting() {
  for (PairPacket& p : particles_.packets)
    for (std::size_t l = 0; l < lanes; ++l) {
      if (p.touching[l] == 0) continue;
      const StoredEnergy stored = elastic_energy(p, l);
      const auto move = [&](Lanes& sum, double kept, double& lost) {
        lost += sum[l] - kept;
        sum[l] = kept;
      };
      move(p.work.normal, 0, energy_balance_.lost_normal);
      move(p.work.tangential, stored.tangential, energy_balance_.lost_tangential);
      move(p.work.rolling, stored.twisting, energy_balance_.lost_rolling);
    }
}

scene::EnergyBalance FewBodySolver::energy_balance() const {
  scene::EnergyBalance a = energy_balance_;
  a.time = time_of(now_);
  a.time_steps = particles_.step - skipped_steps_;
  if (a.time < target_time_ && target_time_ - a.time < 1e-5 * settings_.time_step)
    a.time = target_time_;  // rounding
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(particles_.step));
  const FreeFlight way = free_flight(now_ - particles_.step);
  const kinematics::FrameMotion there = way.time > 0 ? jar_->frame_motion(mill_time(now_)) : frame;
  a.kinetic = a.potential = 0;
  for (std::size_t b = 0; b < particles_.count; ++b) {
    const Species& of = pairs_.species_of(b);
    const Vec3 v0 = particles_.velocity(b);
    const Vec3 v = v0 + way.gain + there.velocity;
    const Vec3 x = particles_.position(b) + way.time * v0 + way.shift + there.centre;
    a.kinetic += 0.5 * (of.mass * squared(v) + of.inertia * squared(particles_.spin(b)));
    a.potential -= of.mass * dot(jar_->gravity(), x);
  }
  const StoredEnergy kept = elastic_energy();
  // Contacts begin in the first step; those of the starting positions are pressed before it.
  a.elastic = particles_.step == 0 ? energy_at_start() : kept.total();
  for (const PairPacket& p : particles_.packets)
    for (std::size_t l = 0; l < lanes; ++l) {
      if (!p.used[l]) continue;
      add_work(a, p.work, l);
      a.lost_open += p.work.normal[l] + p.work.tangential[l] + p.work.rolling[l];
      a.deepest_overlap = std::max(a.deepest_overlap, p.work.max_overlap[l] / min_radius(p, l));
    }
  a.lost_tangential -= kept.tangential;  // stored, not dissipated
  a.lost_rolling -= kept.twisting;
  a.lost_open -= kept.tangential + kept.twisting;
  a.contact_time += static_cast<double>(balls_in_contact_) * time_of(now_ - contact_count_step_);
  if (const kinematics::Drive* drive = jar_->drive()) add_drive(a, *drive, mill_time(now_));
  return a;
}

void FewBodySolver::check_energy() {
  const scene::EnergyBalance a = energy_balance();
  const double t = mill_time(particles_.step);
  const double wall = jar_->max_lab_wall_speed(t);
  const Species& first = pairs_.species(0);
  const double least = first.mass * norm(jar_->gravity()) * first.radius;
  if (!watch_.update_and_test(a, 0.5 * mass_ * wall * wall, least)) return;
  std::size_t fastest = 0;
  for (std::size_t b = 1; b < particles_.count; ++b)
    if (!(squared(particles_.velocity(b)) <= squared(particles_.velocity(fastest)))) fastest = b;
  stop(fastest, energy_jump_message);
}

/// A charge at rest is in a skip without end, in which nothing moves.
void FewBodySolver::check_rest() {
  const auto ball = [&](std::size_t b) {
    return std::tuple(pairs_.species_of(b), particles_.velocity(b), particles_.spin(b));
  };
  rest_.update(time_of(particles_.step), settings_, *jar_, particles_.count, ball);
  if (rest_.at_rest) skip_end_ = std::numeric_limits<std::int64_t>::max();
}

}  // namespace mahlwerk::soft

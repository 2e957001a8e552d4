// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/few/solver.hpp"

// Contacts that begin and end, and their collision records.
namespace mahlwerk::soft {

void FewBodySolver::begin(const PacketLanes& begun) {
  each_lane(begun, [&](std::size_t lane) { begin_lane(particles_.packets[begun.packet], lane); });
}
void FewBodySolver::record_onset(const PacketLanes& begun, const OnsetSpeeds& speeds) {
  each_lane(begun, [&](std::size_t lane) {
    record_onset(particles_.packets[begun.packet], lane, speeds);
  });
}
void FewBodySolver::end(const PacketLanes& ended) {
  ended_.push_back(ended);
}
void FewBodySolver::forces_done() {
  for (const PacketLanes& ended : ended_)
    each_lane(ended, [&](std::size_t lane) { end_lane(particles_.packets[ended.packet], lane); });
  ended_.clear();
}

void FewBodySolver::record_onset(PairPacket& p, std::size_t lane, const OnsetSpeeds& speeds) {
  p.onset[lane] = contact_onset(particles_.step, speeds, lane);
  begin_law_history(p.law_history, p, lane, p.onset[lane].approach, *settings_.model.law);
}

void FewBodySolver::change_contact_count(std::int64_t body, int more) {
  std::int32_t& count = contacts_of_[static_cast<std::size_t>(body)];
  const int was = count > 0;
  count += more;
  if ((count > 0) == was) return;
  energy_balance_.contact_time +=
      static_cast<double>(balls_in_contact_) * time_of(particles_.step - contact_count_step_);
  contact_count_step_ = particles_.step;
  balls_in_contact_ += count > 0 ? 1 : -1;
}

void FewBodySolver::begin_lane(PairPacket& p, std::size_t lane) {
  ++particles_.contacts;
  change_contact_count(p.i[lane], 1);
  if (p.wall[lane] == 0) change_contact_count(p.j[lane], 1);
  if (p.wall[lane] != 0 && settings_.model.curved_walls)
    apply_wall_curvature(p, lane, *jar_, p.face[lane],
                         particles_.position(static_cast<std::size_t>(p.i[lane])),
                         mill_time(particles_.step), pairs_[p.species_pair[lane]], settings_.model);
  set_lane(p.spring, lane, {});
  set_lane(p.rolling_spring_torque, lane, {});
  clear_friction_history(p, lane);
  p.stiffness[lane] = 0;
  p.tensile[lane] = 0;
  p.touching[lane] = -1;
}

void FewBodySolver::end_lane(PairPacket& p, std::size_t lane) {
  --particles_.contacts;
  change_contact_count(p.i[lane], -1);
  const bool wall = p.wall[lane] != 0;
  if (!wall) change_contact_count(p.j[lane], -1);
  const ContactOnset& onset = p.onset[lane];
  const SpeciesPair& pair = pairs_[p.species_pair[lane]];
  const auto ball = static_cast<std::size_t>(p.i[lane]);
  const double t = mill_time(particles_.step);
  const int face = wall ? p.face[lane] : -1;
  const Vec3 x = particles_.position(ball);
  const Vec3 separation =
      wall ? get_lane(p.normal, lane)
           : nearest(particles_.position(static_cast<std::size_t>(p.j[lane])) - x);
  const Vec3 n = (1 / norm(separation)) * separation;
  const Vec3 where = jar_->within_period(x) + p.radius_i[lane] * n;
  p.work.normal[lane] += separation_energy(p, lane, *settings_.model.law);
  const ContactWork& d = p.work;
  const double duration = time_of(particles_.step - onset.step);
  finished_.push_back({.time = time_of(onset.step),
                       .duration = duration,
                       .ball = static_cast<std::int32_t>(p.i[lane]),
                       .other = wall ? ~p.face[lane] : static_cast<std::int32_t>(p.j[lane]),
                       .where = jar_->to_face_point(where, t, face),
                       .normal = jar_->to_face_axes(n, t, face),
                       .mass = pair.effective.mass,
                       .approach = onset.approach,
                       .slip = onset.slip,
                       .glide = onset.glide,
                       .impulse = d.impulse[lane],
                       .lost_normal = d.normal[lane],
                       .lost_tangential = d.tangential[lane] + d.rolling[lane]});
  ++energy_balance_.collisions;
  if (is_sustained(duration, onset, pair, *settings_.model.law)) ++energy_balance_.lasting_contacts;
  p.touching[lane] = 0;
  flush_work(p, lane);
}

void FewBodySolver::add_wall_load(const DriveSample& drive, const MovingWall::WallForce& force) {
  jar_->add_load(loads_, force, jar_->axes(mill_time(particles_.step)), drive, settings_.time_step);
}

void FewBodySolver::flush_work(PairPacket& p, std::size_t lane) {
  ContactWork& d = p.work;
  add_work(energy_balance_, d, lane);
  const double radius = min_radius(p, lane);
  if (radius > 0)
    energy_balance_.deepest_overlap =
        std::max(energy_balance_.deepest_overlap, d.max_overlap[lane] / radius);
  for (Lanes* sum :
       {&d.impulse, &d.normal, &d.tangential, &d.rolling, &d.sliding, &d.wall, &d.max_overlap})
    (*sum)[lane] = 0;
  set_lane(p.spring, lane, {});
  set_lane(p.rolling_spring_torque, lane, {});
  clear_friction_history(p, lane);
  p.stiffness[lane] = 0;
}

}  // namespace mahlwerk::soft

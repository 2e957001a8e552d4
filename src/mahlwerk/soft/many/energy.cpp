// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/many/solver.hpp"
#include "mahlwerk/soft/mill_drive.hpp"

namespace mahlwerk::soft {

StoredEnergy ManyBodySolver::stored_in(const ContactPackets& list, std::size_t n,
                                       std::size_t l) const {
  const ContactPacket& g = list.packets[n];
  const PairParameters& parameters = list.parameters.empty()
                                         ? parameters_[static_cast<std::size_t>(g.species_pair[l])]
                                         : list.parameters[n];
  double law_history[contact::law_history_size] = {};
  if (has_history_)
    for (int a = 0; a < contact::law_history_size; ++a)
      law_history[a] = list.optional_histories[n].law_history[a][l];
  double overlap = touching_spheres(g.i[l], parameters.wall[l] != 0 ? ~g.j[l] : g.j[l]).overlap();
  if (settings_.breakage) overlap = pressed_overlap(overlap, list.stresses[n].rest[l]);
  if (has_left_face(parameters, l, overlap)) return {};
  const double twist = has_friction_history_ ? list.friction_histories[n].twist[l] : 0;
  return stored_energy(parameters, l, overlap, law_history, get_lane(g.spring, l), twist,
                       settings_.model);
}

/// Energies of the open contacts of a chunk. Halo contacts count half, because both chunks
/// have them.
ManyBodySolver::OpenContacts ManyBodySolver::open_contacts(const Chunk& chunk) const {
  OpenContacts open;
  const auto add = [&](const ContactPackets& list, double weight) {
    for (std::size_t n = 0; n < list.packets.size(); ++n)
      for (std::size_t l = 0; l < lanes; ++l) {
        const ContactPacket& g = list.packets[n];
        if (!g.touches(l)) continue;
        open.work_done += weight * (g.lost_normal[l] + g.lost_tangential[l]);
        open.stored.add(stored_in(list, n, l), weight);
      }
  };
  add(chunk.own, 1);
  add(chunk.halo, 0.5);
  add(chunk.wall, 1);
  return open;
}

/// The sums of a contact keep what it stores.
void ManyBodySolver::begin_counting() {
  breakage_.active = 1;
  for (Chunk& chunk : chunks_)
    for (ContactPackets* list : {&chunk.own, &chunk.halo, &chunk.wall})
      for (std::size_t n = 0; n < list->packets.size(); ++n)
        for (std::size_t l = 0; l < lanes; ++l) {
          ContactPacket& g = list->packets[n];
          if (!g.touches(l)) continue;
          const StoredEnergy stored = stored_in(*list, n, l);
          g.lost_normal[l] = 0;
          g.lost_tangential[l] = stored.tangential + stored.twisting;
          if (settings_.breakage) list->stresses[n].energy[l] = 0;
        }
}

/// Energy of a ball in laboratory axes; `frame` is that of the jar at this step.
ManyBodySolver::BallEnergy ManyBodySolver::energy_of(std::size_t row, const Vec3& body_kick_change,
                                                     const kinematics::FrameMotion& frame) const {
  if (is_member(row)) return energy_of_sphere(row, body_kick_change, frame);
  const Species& of = pairs_.species(species_[row]);
  const Vec3 v = velocity(row, body_kick_change) + frame.velocity;
  return {0.5 * (of.mass * squared(v) + of.inertia * squared(spin(row))),
          -(of.mass * dot(jar_->gravity(), rows_[row].position() + frame.centre))};
}

scene::EnergyBalance ManyBodySolver::energy_balance() const {
  scene::EnergyBalance a = energy_balance_;
  for (const Chunk& chunk : chunks_) add_sums(a, chunk);
  a.time = time_of(step_);
  a.time_steps = step_ - rested_steps_;
  if (a.time < target_time_ && target_time_ - a.time < 1e-5 * settings_.time_step)
    a.time = target_time_;  // rounding
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  const Vec3 change = body_kick_change();
  struct Sum {
    double kinetic = 0, potential = 0;
    OpenContacts open;
  };
  std::vector<Sum> sums(chunks_.size());
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    Sum& sum = sums[static_cast<std::size_t>(c)];
    for (std::int32_t row = chunk.first; row < chunk.last; ++row) {
      const auto k = static_cast<std::size_t>(row);
      const BallEnergy energy = energy_of(k, change, frame);
      sum.kinetic += energy.kinetic, sum.potential += energy.potential;
    }
    sum.open = open_contacts(chunk);
  });
  a.kinetic = a.potential = a.elastic = 0;
  for (const Sum& sum : sums) {
    a.kinetic += sum.kinetic;
    a.potential += sum.potential;
    const StoredEnergy& stored = sum.open.stored;
    a.elastic += stored.total();
    a.lost_open += sum.open.work_done - stored.tangential - stored.twisting;
    a.lost_tangential -= stored.tangential;  // stored, not dissipated
    a.lost_rolling -= stored.twisting;
  }
  if (const kinematics::Drive* drive = jar_->drive()) add_drive(a, *drive, mill_time(step_));
  // Contacts begin in the first step; those of the starting positions are pressed before it.
  if (step_ == 0) a.elastic = energy_at_start();
  return a;
}

void ManyBodySolver::check_energy() {
  const scene::EnergyBalance a = energy_balance();
  const double t = mill_time(step_);
  const double wall = jar_->max_lab_wall_speed(t);
  const Species& first = pairs_.species(0);
  const double least = first.mass * norm(jar_->gravity()) * first.radius;
  if (!watch_.update_and_test(a, 0.5 * mass_ * wall * wall, least)) return;
  std::size_t fastest = 0;
  for (std::size_t k = 1; k < rows_.size(); ++k)
    if (!(squared(velocity_of_row(k, {})) <= squared(velocity_of_row(fastest, {})))) fastest = k;
  stop(fastest, energy_jump_message);
}

void ManyBodySolver::check_rest() {
  const auto ball = [&](std::size_t k) {
    return std::tuple(pairs_.species(species_[k]), velocity_of_row(k, {}), spin_of_row(k));
  };
  rest_.update(time_of(step_), settings_, *jar_, rows_.size(), ball);
}

/// Nothing changes but the time of contact.
void ManyBodySolver::pass_rest(std::int64_t until) {
  for (Chunk& chunk : chunks_) chunk.sums.ball_steps += (until - step_) * chunk.balls_in_contact;
  rested_steps_ += until - step_;
  step_ = until;
}

/// Moves the sums of the chunks to the energy balance. Called only at steps that do not depend on
/// how advance() divides a run, because each addition rounds.
void ManyBodySolver::flush_sums() {
  for (Chunk& chunk : chunks_) {
    add_sums(energy_balance_, chunk);
    chunk.sums = {};
    add_loads(loads_, chunk.loads);
    chunk.loads.clear();
  }
}

std::vector<scene::WallLoad> ManyBodySolver::wall_loads() const {
  std::vector<scene::WallLoad> sum = loads_;
  for (const Chunk& chunk : chunks_) add_loads(sum, chunk.loads);
  return sum;
}

void ManyBodySolver::add_wall_load(const ChunkStep& step, Chunk& chunk,
                                   const MovingWall::WallForce& force) {
  chunk.loads.resize(loads_.size());
  jar_->add_load(chunk.loads, force, step.wall_axes, step.drive, settings_.time_step);
}

void ManyBodySolver::add_sums(scene::EnergyBalance& a, const Chunk& chunk) const {
  const ChunkSums& d = chunk.sums;
  for (std::size_t l = 0; l < lanes; ++l) {
    add_work(a, d.work, l);
    a.deepest_overlap = std::max(a.deepest_overlap, d.work.max_overlap[l]);
  }
  a.lost_liquid += d.liquid.lost;
  a.wall_work += d.liquid.wall;
  a.contact_time += time_of(d.ball_steps);
  a.collisions += d.collisions;
  a.lasting_contacts += d.sustained;
  a.search_steps += d.tests;
}

}  // namespace mahlwerk::soft

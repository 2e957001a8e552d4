// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mahlwerk/soft/many/solver.hpp"
#include "mahlwerk/soft/solver_state.hpp"

// The state of a run as another solver takes or gives it.
namespace mahlwerk::soft {

SolverState::Contact ManyBodySolver::contact_of(const ContactPackets& list, std::size_t n,
                                                std::size_t l, bool wall) const {
  const ContactPacket& g = list.packets[n];
  const ContactOnset& onset = list.onsets[n][l];
  const auto in_lane = [&](const Vec<Lanes>& columns) {
    const Vec3 a = get_lane(columns, l);
    return Vec<double>{a.x, a.y, a.z};
  };
  SolverState::Contact c;
  c.i = id_[static_cast<std::size_t>(g.i[l])];
  c.j = wall ? ~g.j[l] : id_[static_cast<std::size_t>(g.j[l])];
  c.state = {.spring = in_lane(g.spring),
             .impulse = g.impulse[l],
             .lost_normal = g.lost_normal[l],
             .lost_tangential = g.lost_tangential[l],
             .onset_step = onset.step,
             .approach = onset.approach,
             .slip = onset.slip,
             .glide = onset.glide,
             .tensile = (g.tensile & bit(l)) != 0};
  if (has_history_) {
    const OptionalHistory& h = list.optional_histories[n];
    for (int k = 0; k < contact::law_history_size; ++k)
      c.optional.law_history[k] = h.law_history[k][l];
    c.optional.rolling_spring_torque = in_lane(h.rolling_spring_torque);
    c.optional.stiffness = h.stiffness[l];
  }
  if (has_friction_history_) {
    const FrictionHistory& h = list.friction_histories[n];
    c.friction = {in_lane(h.turning_force), h.load[l], h.twist[l]};
  }
  if (wall) c.normal = get_lane(list.wall_normals[n].normal, l);
  return c;
}

SolverState ManyBodySolver::state() const {
  SolverState s;
  s.step = step_, s.rested_steps = rested_steps_, s.target_time = target_time_;
  s.rows.resize(id_.size()), s.spins.resize(id_.size()), s.half_step.resize(id_.size());
  for (std::size_t k = 0; k < id_.size(); ++k) {
    const auto ball = static_cast<std::size_t>(id_[k]);
    s.rows[ball] = next_rows_[k], s.spins[ball] = next_spins_[k];
    s.half_step[ball] = half_step_[k];
  }
  s.energy_balance = energy_balance_;
  for (const Chunk& chunk : chunks_) {
    add_sums(s.energy_balance, chunk);
    for (const ContactPackets* list : {&chunk.own, &chunk.halo, &chunk.wall})
      for (std::size_t n = 0; n < list->packets.size(); ++n)
        for (std::size_t l = 0; l < lanes; ++l) {
          const ContactPacket& g = list->packets[n];
          const bool copy = list == &chunk.halo && g.i[l] > g.j[l];  // the other chunk has it, too
          if (g.touches(l) && !copy)
            s.contacts.push_back(contact_of(*list, n, l, list == &chunk.wall));
        }
  }
  s.watch = watch_, s.rest = rest_;
  return s;
}

/// Puts a contact into a free lane of the chunk. `row` has the row of each ball.
void ManyBodySolver::take_contact(Chunk& chunk, const SolverState::Contact& c,
                                  const std::vector<std::int32_t>& row) {
  const bool wall = c.j < 0;
  const std::int32_t i = row[static_cast<std::size_t>(c.i)],
                     j = wall ? ~c.j : row[static_cast<std::size_t>(c.j)],
                     mine = species_[static_cast<std::size_t>(i)];
  const std::int32_t pair =
      wall ? pairs_.wall_pair_index(mine, j)
           : pairs_.ball_pair_index(mine, species_[static_cast<std::size_t>(j)]);
  ContactPackets& list = wall ? chunk.wall : chunk.own;
  const std::int32_t at = free_lane(list, pair, i);
  const auto n = static_cast<std::size_t>(at / lanes), l = static_cast<std::size_t>(at % lanes);
  const auto put = [&](Vec<Lanes>& columns, const Vec<double>& a) {
    set_lane(columns, l, {a.x, a.y, a.z});
  };
  ContactPacket& g = list.packets[n];
  g.i[l] = i, g.j[l] = j;
  g.touching |= bit(l);
  if (c.state.tensile) g.tensile |= bit(l);
  put(g.spring, c.state.spring);
  g.impulse[l] = c.state.impulse;
  g.lost_normal[l] = c.state.lost_normal, g.lost_tangential[l] = c.state.lost_tangential;
  list.onsets[n][l] = {c.state.onset_step, c.state.approach, c.state.slip, c.state.glide};
  if (has_history_) {
    OptionalHistory& h = list.optional_histories[n];
    for (int k = 0; k < contact::law_history_size; ++k)
      h.law_history[k][l] = c.optional.law_history[k];
    put(h.rolling_spring_torque, c.optional.rolling_spring_torque);
    h.stiffness[l] = c.optional.stiffness;
  }
  if (has_friction_history_) {
    FrictionHistory& h = list.friction_histories[n];
    put(h.turning_force, c.friction.turning_force);
    h.load[l] = c.friction.load, h.twist[l] = c.friction.twist;
  }
  if (wall) set_lane(list.wall_normals[n].normal, l, c.normal);
  change_contact_count(chunk, i, 1);
  if (!wall) change_contact_count(chunk, j, 1);
}

/// Takes a state over. All contacts are in one chunk until the lists are built in the next step.
void ManyBodySolver::take(const SolverState& s) {
  if (bodies_.has_members()) throw RunError("bodies that are no spheres have no state for a card");
  if (s.rows.size() != id_.size() || s.spins.size() != id_.size() ||
      s.half_step.size() != id_.size())
    throw Archive::broken();
  step_ = s.step, rested_steps_ = s.rested_steps, target_time_ = s.target_time;
  energy_balance_ = s.energy_balance;
  watch_ = s.watch, rest_ = s.rest;
  std::vector<std::int32_t> row(id_.size());
  for (std::size_t k = 0; k < id_.size(); ++k) {
    const auto ball = static_cast<std::size_t>(id_[k]);
    row[ball] = static_cast<std::int32_t>(k);
    next_rows_[k] = s.rows[ball], next_spins_[k] = s.spins[ball], half_step_[k] = s.half_step[ball];
    const VectorPair& v = half_step_[k];
    const Vec3 now = next_rows_[k].position() - settings_.time_step * Vec3{v.x, v.y, v.z};
    rows_[k].x = now.x, rows_[k].y = now.y, rows_[k].z = now.z;
  }
  wall_axes_ = jar_->axes(mill_time(step_));
  contacts_of_.assign(id_.size(), 0);
  chunks_ = std::vector<Chunk>(1);
  chunks_.front().last = static_cast<std::int32_t>(id_.size());
  for (const SolverState::Contact& c : s.contacts) {
    const auto balls = static_cast<std::int32_t>(id_.size());
    if (c.i < 0 || c.i >= balls || c.j >= balls || (c.j < 0 && ~c.j >= jar_->faces()))
      throw Archive::broken();
    take_contact(chunks_.front(), c, row);
  }
  displacements_.assign(1, {});
  displacements_.front().spread = geometry::never;  // builds the lists in the next step
  predicted_means_.assign(1, {});
  share_work();
}

}  // namespace mahlwerk::soft

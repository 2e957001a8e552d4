// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>

#include "mahlwerk/soft/device/solver.hpp"
#include "mahlwerk/soft/many/solver.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"

// The state of a run as another solver takes or gives it.
namespace mahlwerk::soft {

SolverState DeviceSolver::state() const {
  const HostBalls all = read_balls();
  SolverState s;
  s.step = step_, s.rested_steps = rested_steps_, s.target_time = target_time_;
  s.rows.resize(all.id.size()), s.spins.resize(all.id.size()), s.half_step.resize(all.id.size());
  for (std::size_t row = 0; row < all.id.size(); ++row) {
    const auto ball = static_cast<std::size_t>(all.id[row]);
    s.rows[ball] = all.rows[row], s.spins[ball] = all.spins[row];
    s.half_step[ball] = all.half_step[row];
  }
  const auto size = static_cast<std::size_t>(arrays_.list.size()),
             pairs = static_cast<std::size_t>(arrays_.list.pairs);
  const std::vector<std::int32_t> i = list_->i.read(size), j = list_->j.read(size);
  const std::vector<Touch> touch = list_->touch.read(size);
  const std::vector<ContactState> states = list_->state.read(size);
  const std::vector<OptionalState> optional = list_->optional.read(has_history_ ? size : 0);
  const std::vector<FrictionState> friction =
      list_->friction.read(has_friction_history_ ? size : 0);
  const std::vector<Vec3> normals = list_->normals.read(size - pairs);
  for (std::size_t p = 0; p < size; ++p) {
    if (touch[p] != Touch::touching) continue;
    SolverState::Contact c;
    c.state = states[p];
    c.i = all.id[static_cast<std::size_t>(i[p])];
    c.j = p < pairs ? all.id[static_cast<std::size_t>(j[p])] : ~j[p];
    if (has_history_) c.optional = optional[p];
    if (has_friction_history_) c.friction = friction[p];
    if (p >= pairs) c.normal = normals[p - pairs];
    s.contacts.push_back(c);
  }
  s.energy_balance = energy_balance_;
  add_sums(s.energy_balance, work(common_kernels().sum_work));
  s.energy_balance.contact_time = time_of(contact_steps_ + count_contacts());
  s.energy_balance.search_steps = tests_;
  s.watch = watch_, s.rest = rest_;
  return s;
}

/// The state with the balls that were last asked for, without contacts.
SolverState DeviceSolver::last_known() const {
  SolverState s;
  s.step = step_, s.rested_steps = rested_steps_, s.target_time = target_time_;
  for (const scene::Ball& b : last_balls_) {
    const Vec3 &x = b.position, &v = b.velocity, &w = b.spin;
    s.rows.push_back({x.x, x.y, x.z, b.radius, v.x, v.y, v.z, 0});
    s.spins.push_back({w.x, w.y, w.z, 0});
    s.half_step.push_back({v.x, v.y, v.z, 0, w.x, w.y, w.z, 0});
  }
  s.energy_balance = energy_balance_;
  s.watch = watch_, s.rest = rest_;
  return s;
}

/// Takes a state over. Its contacts are the list until the lists are built in the next step.
void DeviceSolver::take(const SolverState& s) {
  HostBalls all = read_balls();
  const std::size_t balls = all.id.size();
  if (s.rows.size() != balls || s.spins.size() != balls || s.half_step.size() != balls)
    throw Archive::broken();
  std::vector<std::int32_t> row(balls);
  for (std::size_t k = 0; k < balls; ++k) {
    const auto ball = static_cast<std::size_t>(all.id[k]);
    row[ball] = static_cast<std::int32_t>(k);
    all.rows[k] = s.rows[ball], all.spins[k] = s.spins[ball], all.half_step[k] = s.half_step[ball];
  }
  balls_->rows.write(all.rows), balls_->spins.write(all.spins);
  balls_->half_step.write(all.half_step);
  step_ = s.step, rested_steps_ = s.rested_steps, target_time_ = s.target_time;
  energy_balance_ = s.energy_balance;
  tests_ = s.energy_balance.search_steps;
  contact_steps_ = std::llround(s.energy_balance.contact_time / settings_.time_step);
  balls_in_contact_.zeroed(DeviceArrays::contact_counters);
  watch_ = s.watch, rest_ = s.rest;
  take_contacts(s, row);
  lists_due_ = true;
}

/// Makes a list of the contacts alone.
void DeviceSolver::take_contacts(const SolverState& s, const std::vector<std::int32_t>& row) {
  const auto balls = static_cast<std::int32_t>(row.size());
  std::vector<SolverState::Contact> contacts = s.contacts;
  for (SolverState::Contact& c : contacts) {
    if (c.i < 0 || c.i >= balls || c.j >= balls || (c.j < 0 && ~c.j >= arrays_.faces))
      throw Archive::broken();
    c.i = row[static_cast<std::size_t>(c.i)];
    if (c.j < 0) continue;
    c.j = row[static_cast<std::size_t>(c.j)];
    if (c.i > c.j) {
      std::swap(c.i, c.j);
      c.state.spring = -c.state.spring;
      c.optional.rolling_spring_torque = -c.optional.rolling_spring_torque;
      c.friction.turning_force = -c.friction.turning_force;
    }
  }
  std::ranges::sort(contacts, {}, [](const SolverState::Contact& c) {
    return std::tuple(c.j < 0, c.i, c.j < 0 ? ~c.j : c.j);
  });
  std::vector<std::int32_t> i, j, pair_first(row.size() + 1), wall_first(row.size() + 1);
  std::vector<ContactState> states;
  std::vector<OptionalState> optional;
  std::vector<FrictionState> friction;
  std::vector<Vec3> normals, points;
  const HostBalls all = read_balls();
  const Vec3 change = body_kick_change();
  const WallAxes axes = jar_->axes(mill_time(step_));
  for (const SolverState::Contact& c : contacts) {
    const bool wall = c.j < 0;
    ++(wall ? wall_first : pair_first)[static_cast<std::size_t>(c.i) + 1];
    i.push_back(c.i), j.push_back(wall ? ~c.j : c.j);
    states.push_back(c.state), optional.push_back(c.optional), friction.push_back(c.friction);
    if (!wall) continue;
    normals.push_back(c.normal);
    const scene::Ball ball = present(all, static_cast<std::size_t>(c.i), change);
    const Vec3& at = ball.position;
    const geometry::Gap gap =
        jar_->gap(~c.j, at, axes, (1 + past_touch) * ball.radius + arrays_.pull_off_distance);
    points.push_back(at - gap.distance * gap.inward);
  }
  for (std::size_t k = 0; k < row.size(); ++k)
    pair_first[k + 1] += pair_first[k], wall_first[k + 1] += wall_first[k];
  ContactList& list = arrays_.list;
  list.pairs = pair_first.back(), list.walls = wall_first.back();
  reserve_pairs(list.size());
  list.pair_first = list_->pair_first.write(pair_first);
  list.wall_first = list_->wall_first.write(wall_first);
  list_->i.write(i), list_->j.write(j), list_->state.write(states);
  list_->touch.write(std::vector<Touch>(contacts.size(), Touch::touching));
  if (has_history_) list_->optional.write(optional);
  if (has_friction_history_) list_->friction.write(friction);
  list_->normals.write(normals), wall_points_.write(points);
  sums_.zeroed(contacts.size());
}

/// The state in an archive of ManyBodySolver. This solver must be at its start.
SolverState DeviceSolver::state_of_many(Archive& archive) const {
  if (arrays_.balls <= static_cast<std::int32_t>(settings_.few_ball_limit))
    throw RunError(SolverState::of_few_balls);
  Settings settings = settings_;
  settings.device = nullptr;
  ManyBodySolver other(moving_wall(chamber_), balls(), settings, pair_table_, start_);
  other.serialize(archive);
  return other.state();
}

}  // namespace mahlwerk::soft

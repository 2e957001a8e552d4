// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/device/arrays.hpp"
#include "mahlwerk/soft/device/atomics.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/kernel/stored_energy.hpp"

// Kernels of the listed pairs: a call computes one pair, in one lane (docs/theory/soft.md).
namespace mahlwerk::soft {

/// A vector in one lane.
constexpr Vec<double> in_lane(const Vec3& a) {
  return {a.x, a.y, a.z};
}
constexpr Vec3 of_lane(const Vec<double>& a) {
  return {a.x, a.y, a.z};
}

template <class Law>
const Law& law_of(const DeviceArrays& a) {
  static_assert(std::is_trivially_copyable_v<Law> && sizeof(Law) <= sizeof a.law);
  return *reinterpret_cast<const Law*>(a.law);
}

inline std::int32_t species_pair_of(const DeviceArrays& a, std::int32_t p) {
  const std::int32_t j = a.list.j[p];
  const std::int32_t other = p < a.list.pairs ? a.now.species[j] : a.species + j;
  return a.now.species[a.list.i[p]] * a.species_row + other;
}

/// From the centre of the first body to that of the second, or to the wall [m].
inline Vec<double> separation_of(const DeviceArrays& a, std::int32_t p) {
  const Vec3 from = a.now.rows[a.list.i[p]].position();
  if (p >= a.list.pairs) return in_lane(a.wall_points[p - a.list.pairs] - from);
  const Vec<double> separation = in_lane(a.now.rows[a.list.j[p]].position() - from);
  return a.constants.periodic ? folded(separation, a.constants.periods) : separation;
}

inline PairMotion<double> pair_motion(const DeviceArrays& a, std::int32_t p,
                                      const Vec<double>& separation) {
  const std::int32_t i = a.list.i[p], j = a.list.j[p];
  const BallRecord& ball = a.now.rows[i];
  const SpinRecord& spin = a.now.spins[i];
  const Vec<double> velocity{ball.u, ball.v, ball.w};
  PairMotion<double> motion;
  motion.separation = separation;
  motion.wi = {spin.x, spin.y, spin.z};
  if (p < a.list.pairs) {
    const BallRecord& other = a.now.rows[j];
    const SpinRecord& its = a.now.spins[j];
    motion.relative_velocity = velocity - Vec<double>{other.u, other.v, other.w};
    motion.vj = {0, 0, 0};
    motion.wj = {its.x, its.y, its.z};
  } else {
    const DriveSample& drive = a.input().drive;
    motion.wj = in_lane(j < a.first_rotor_face ? drive.spin : drive.rotor_spin);
    motion.vj = cross(motion.wj, in_lane(a.wall_points[p - a.list.pairs]));
    motion.relative_velocity = velocity - motion.vj;
  }
  return motion;
}

inline GroupHistory<double> load_history(const ContactList& list, std::int32_t p) {
  GroupHistory<double> history;
  history.spring = list.state[p].spring;
  history.tensile = list.state[p].tensile;
  if (list.optional != nullptr) {
    const OptionalState& from = list.optional[p];
    for (int n = 0; n < contact::law_history_size; ++n)
      history.law_history[n] = from.law_history[n];
    history.rolling_spring_torque = from.rolling_spring_torque;
    history.stiffness = from.stiffness;
  }
  if (list.friction != nullptr) {
    const FrictionState& from = list.friction[p];
    history.turning_force = from.turning_force;
    history.load = from.load, history.twist = from.twist;
  }
  return history;
}

inline void store_history(const ContactList& list, std::int32_t p,
                          const GroupHistory<double>& history) {
  list.state[p].spring = history.spring;
  list.state[p].tensile = history.tensile;
  if (list.optional != nullptr) {
    OptionalState& to = list.optional[p];
    for (int n = 0; n < contact::law_history_size; ++n) to.law_history[n] = history.law_history[n];
    to.rolling_spring_torque = history.rolling_spring_torque;
    to.stiffness = history.stiffness;
  }
  if (list.friction != nullptr)
    list.friction[p] = {history.turning_force, history.load, history.twist};
}

/// A contact begins: no history but what the law gives it, and the speeds of first touch.
template <class Law>
inline void begin_contact(const DeviceArrays& a, std::int32_t p, const PairParameters& parameters,
                          const PairMotion<double>& motion,
                          const ContactGeometry<double>& geometry) {
  const Vec<double>& u = motion.relative_velocity;
  const Vec<double> glide = u - dot(u, geometry.n) * geometry.n;
  ContactState state;
  state.onset_step = a.control->step;
  state.approach = max(geometry.overlap_rate, 0.0);
  state.slip = sqrt(dot(geometry.slip, geometry.slip));
  state.glide = sqrt(dot(glide, glide));
  a.list.state[p] = state;
  if (a.list.friction != nullptr) a.list.friction[p] = {};
  if (a.list.optional == nullptr) return;
  a.list.optional[p] = {};
  law_of<Law>(a).begin(coefficients_of(parameters, 0), a.list.optional[p].law_history,
                       state.approach);
}

/// Adds the work of a step to the sums of the contact and of the run.
inline void add_work_of_step(const DeviceArrays& a, std::int32_t p,
                             const PairParameters& parameters, const WorkOfStep<double>& work) {
  ContactState& state = a.list.state[p];
  state.impulse += work.impulse;
  state.lost_normal += work.normal;
  state.lost_tangential += work.tangential + work.rolling;
  ContactSums& sums = a.sums[p];
  sums.normal += work.normal;
  sums.tangential += work.tangential;
  sums.rolling += work.rolling;
  sums.sliding += work.sliding;
  sums.wall += work.wall;
  sums.max_overlap = max(sums.max_overlap, work.overlap * parameters.inverse_radius[0]);
}

/// Writes what the collision record of an ended contact needs. The next step is not computed where
/// it might find no room for its own.
inline void end_contact(const DeviceArrays& a, std::int32_t p, std::int32_t species_pair,
                        const Vec<double>& separation) {
  ContactState& state = a.list.state[p];
  const double released = a.separation_energy[species_pair];
  state.lost_normal += released;
  a.sums[p].normal += released;
  const std::int32_t i = a.list.i[p], j = a.list.j[p];
  const bool wall = p >= a.list.pairs;
  const BallRecord& ball = a.now.rows[i];
  const std::int64_t at = atomic_add(&a.control->ended, std::int64_t{1});
  if (at + a.list.size() >= a.most_ended) set_shared(a.control->halt_at, a.control->step + 1);
  a.ended[at] = {.step = a.control->step,
                 .onset_step = state.onset_step,
                 .index = p,
                 .ball = a.now.id[i],
                 .other = wall ? ~j : a.now.id[j],
                 .species_pair = species_pair,
                 .position = ball.position(),
                 .separation = wall ? a.list.normals[p - a.list.pairs] : of_lane(separation),
                 .radius = ball.radius,
                 .approach = state.approach,
                 .slip = state.slip,
                 .glide = state.glide,
                 .impulse = state.impulse,
                 .lost_normal = state.lost_normal,
                 .lost_tangential = state.lost_tangential};
}

/// Computes the force of a listed pair in this step, if it touches or has touched in the last one.
template <class Law>
inline void compute_contact(const DeviceArrays& a, std::int64_t index) {
  if (a.halted()) return;
  const auto p = static_cast<std::int32_t>(index);
  const ContactList& list = a.list;
  const bool touched = list.touch[p] == Touch::touching, wall = p >= list.pairs;
  const Vec<double> separation = separation_of(a, p);
  const double squared = dot(separation, separation);
  double near = a.now.rows[list.i[p]].radius + (wall ? 0.0 : a.now.rows[list.j[p]].radius);
  constexpr LaneGroup<double> group{0};
  if (touched) near += group(a.parameters[species_pair_of(a, p)].pull_off_distance);
  const bool touching = squared < near * near;
  if (!touching && !touched) {  // most pairs: of their balls nothing but the position is read
    list.touch[p] = Touch::apart;
    return;
  }
  const std::int32_t species_pair = species_pair_of(a, p);
  const PairParameters& parameters = a.parameters[species_pair];
  const PairMotion<double> motion = pair_motion(a, p, separation);
  const ContactGeometry<double> geometry =
      contact_geometry<double>(group, parameters, motion, squared);
  if (!touched) begin_contact<Law>(a, p, parameters, motion, geometry);
  GroupHistory<double> history = load_history(list, p);
  const ContactTransitions<double> transitions{!touched, !touching};
  StepConstants constants = a.constants;
  constants.jar_velocity = a.input().drive.velocity;
  WorkOfStep<double> work;
  const ContactForce<double> force =
      contact_force<Law, double>(group, parameters, history, work, constants, motion, geometry,
                                 touching, touched != touching ? &transitions : nullptr, wall);
  store_history(list, p, history);
  a.forces[p] = {force.force, force.torque_i, force.torque_j};
  add_work_of_step(a, p, parameters, work);
  list.touch[p] = touching ? Touch::touching : Touch::ended;
  if (wall && touching) list.normals[p - list.pairs] = of_lane(geometry.n);
  if (!touching) end_contact(a, p, species_pair, separation);
}

/// What a touching pair stores at the present step. Rows are one step ahead.
template <class Law>
inline StoredEnergy stored_in(const DeviceArrays& a, std::int32_t p) {
  const std::int32_t i = a.list.i[p], j = a.list.j[p];
  const auto present = [&](std::int32_t k) {
    const BallRecord& row = a.now.rows[k];
    const VectorPair& half = a.now.half_step[k];
    return row.position() - a.constants.dt * Vec3{half.x, half.y, half.z};
  };
  const bool wall = p >= a.list.pairs;
  Vec<double> separation =
      in_lane((wall ? a.wall_points[p - a.list.pairs] : present(j)) - present(i));
  if (!wall && a.constants.periodic) separation = folded(separation, a.constants.periods);
  const PairParameters& parameters = a.parameters[species_pair_of(a, p)];
  const double overlap =
      parameters.radius_i[0] + parameters.radius_j[0] - sqrt(dot(separation, separation));
  const GroupHistory<double> history = load_history(a.list, p);
  return stored_energy(law_of<Law>(a), parameters, 0, overlap, history.law_history,
                       of_lane(history.spring), history.twist, a.constants.partial_slip);
}

/// Sums of reductions over contacts, of the columns of ContactTotals.
struct ContactTotals {
  double stored_normal = 0, stored_tangential = 0, stored_twisting = 0;
  double work_done = 0;  ///< by open contacts, since their onset

  static constexpr int columns = 4;
};
template <class Law>
inline void sum_contacts(const DeviceArrays& a, std::int64_t index) {
  ContactTotals sum;
  for (auto p = static_cast<std::int32_t>(index); p < a.list.size(); p += a.partials) {
    if (a.list.touch[p] != Touch::touching) continue;
    const StoredEnergy stored = stored_in<Law>(a, p);
    sum.stored_normal += stored.normal;
    sum.stored_tangential += stored.tangential;
    sum.stored_twisting += stored.twisting;
    sum.work_done += a.list.state[p].lost_normal + a.list.state[p].lost_tangential;
  }
  reinterpret_cast<ContactTotals*>(a.partial)[index] = sum;
}

/// The sums of a contact keep what it stores.
template <class Law>
inline void begin_counting(const DeviceArrays& a, std::int64_t index) {
  const auto p = static_cast<std::int32_t>(index);
  if (a.list.touch[p] != Touch::touching) return;
  const StoredEnergy stored = stored_in<Law>(a, p);
  a.list.state[p].lost_normal = 0;
  a.list.state[p].lost_tangential = stored.tangential + stored.twisting;
}

}  // namespace mahlwerk::soft

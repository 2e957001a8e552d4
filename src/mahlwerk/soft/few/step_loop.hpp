// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/particle_data.hpp"
#include "mahlwerk/soft/kernel/isa.hpp"

// The innermost loop of FewBodySolver: a template, compiled for each law and each instruction set.
namespace mahlwerk::soft {

/// Gathers the values of a column at the bodies of eight lanes. With AVX-512 and at most sixteen
/// bodies, two registers hold the column and one permute instruction picks eight.
template <bool avx512>
[[gnu::always_inline]] inline Lanes gather(const std::vector<AlignedLanes>& column,
                                           const LaneMask& at, bool fits_registers) {
#ifdef MAHLWERK_AVX512
  if constexpr (avx512)
    if (fits_registers) return __builtin_shuffle(column[0].value, column[1].value, at);
#endif
  const double* all = column_data(column);
  Lanes found;
  for (int l = 0; l < lanes; ++l) found[l] = all[at[l]];
  return found;
}
template <bool avx512>
[[gnu::always_inline]] inline Vec<Lanes> gather(const VectorColumns& c, const LaneMask& at,
                                                bool fits_registers) {
  return {gather<avx512>(c.x, at, fits_registers), gather<avx512>(c.y, at, fits_registers),
          gather<avx512>(c.z, at, fits_registers)};
}

/// Half a kick, a drift, and the velocities predicted for the contacts of this step (velocity
/// Verlet, dem.26). Returns whether a displacement since the last rebuild exceeds the limit.
[[gnu::always_inline]] inline bool half_kick_and_drift(StepBatch& s, const DriveSample& before,
                                                       const DriveSample& after) {
  ParticleData& w = s.particles;
  const Lanes zero{}, step = zero + s.constants.dt, half = 0.5 * step;
  const Vec<Lanes> acceleration_before{zero + before.body_acceleration.x,
                                       zero + before.body_acceleration.y,
                                       zero + before.body_acceleration.z};
  const Vec<Lanes> acceleration_after{zero + after.body_acceleration.x,
                                      zero + after.body_acceleration.y,
                                      zero + after.body_acceleration.z};
  const double slack = s.max_displacement - s.jar.max_wall_speed() *
                                                static_cast<double>(w.step - s.list_step) *
                                                s.constants.dt;
  const double limit = slack > 0 ? slack * slack : -1;
  LaneMask moved_far{};
  for (std::size_t b = 0; b < w.blocks; ++b) {
    const Vec<Lanes> half_kick = w.half_kick_factor[b].value * w.force.at(b);
    const Vec<Lanes> v = w.velocity.at(b) + half_kick + half * acceleration_before;
    const Vec<Lanes> x = w.position.at(b) + step * v;
    w.position.put(b, x);
    w.velocity_predicted.put(b, v + half_kick + half * acceleration_after);
    w.velocity.put(
        b, v + half * acceleration_after);  // still without the second half kick of the contacts
    const Vec<Lanes> half_spin_kick = w.half_spin_kick_factor[b].value * w.torque.at(b),
                     spin = w.spin.at(b) + half_spin_kick;
    w.spin.put(b, spin);
    w.spin_predicted.put(b, spin + half_spin_kick);
    const Vec<Lanes> displacement = x - w.list_positions.at(b);
    const Lanes moved = dot(displacement, displacement);
    w.displacement_squared[b].value = moved;
    moved_far |= ~less(moved, zero + limit);
  }
  return any(moved_far);
}

/// The second half kick of the contacts.
[[gnu::always_inline]] inline void second_half_kick(ParticleData& w, std::size_t b,
                                                    const Vec<Lanes>& force,
                                                    const Vec<Lanes>& torque) {
  w.force.put(b, force);
  w.torque.put(b, torque);
  w.velocity.put(b, w.velocity.at(b) + w.half_kick_factor[b].value * force);
  w.spin.put(b, w.spin.at(b) + w.half_spin_kick_factor[b].value * torque);
}

/// Adds the forces and torques of a packet to eight balls in registers, in the order of its lanes.
[[gnu::always_inline]] inline void gather_forces(const GatherMap& map, const ContactForce& f,
                                                 Vec<Lanes>& force, Vec<Lanes>& torque) {
#ifdef MAHLWERK_AVX512
  const auto sum = [&](Lanes& all, const Lanes& i, const Lanes& j, int k) {
    const Lanes part = __builtin_shuffle(i, j, map.source[static_cast<std::size_t>(k)]);
    all += select(map.active[static_cast<std::size_t>(k)], part, Lanes{});
  };
  const Vec<Lanes> back = -f.force;
  for (int k = 0; k < map.max_contacts; ++k) {
    sum(force.x, f.force.x, back.x, k);
    sum(force.y, f.force.y, back.y, k);
    sum(force.z, f.force.z, back.z, k);
    sum(torque.x, f.torque_i.x, f.torque_j.x, k);
    sum(torque.y, f.torque_i.y, f.torque_j.y, k);
    sum(torque.z, f.torque_i.z, f.torque_j.z, k);
  }
#endif
}

/// Adds the forces and torques of a packet to the balls in memory, for any number of balls.
[[gnu::always_inline]] inline void scatter(ParticleData& w, const PairPacket& p,
                                           const ContactForce& f) {
  const auto add = [&](std::vector<AlignedLanes>& column, const Lanes& i, const Lanes& j) {
    double* all = column_data(column);
    for (int l = 0; l < lanes; ++l) {
      all[p.i[l]] += i[l];
      if (p.wall[l] == 0) all[p.j[l]] += j[l];
    }
  };
  const Vec<Lanes> back = -f.force;
  add(w.force.x, f.force.x, back.x);
  add(w.force.y, f.force.y, back.y);
  add(w.force.z, f.force.z, back.z);
  add(w.torque.x, f.torque_i.x, f.torque_j.x);
  add(w.torque.y, f.torque_i.y, f.torque_j.y);
  add(w.torque.z, f.torque_i.z, f.torque_j.z);
}

/// Computes the forces of a packet in a step. Returns false if no lane touches and none touched at
/// the last step.
template <class Law, bool avx512>
[[gnu::always_inline]] inline bool apply_packet(StepBatch& s, PairPacket& p, ContactForce& out) {
  const ParticleData& w = s.particles;
  PairMotion motion;
  motion.separation = gather<avx512>(w.position, p.j, w.fits_registers) -
                      gather<avx512>(w.position, p.i, w.fits_registers);
  if (s.constants.periodic) motion.separation = folded(motion.separation, s.constants.periods);
  const Lanes squared = dot(motion.separation, motion.separation),
              near = touch_distance(p, p.touching);
  const LaneMask touching = less(squared, near * near);
  const ContactTransitions transitions{touching & ~p.touching, p.touching & ~touching};
  const bool changes = any(touching ^ p.touching);
  if (!changes && !any(touching)) return false;
  motion.vj = gather<avx512>(w.velocity_predicted, p.j, w.fits_registers);
  motion.relative_velocity =
      gather<avx512>(w.velocity_predicted, p.i, w.fits_registers) - motion.vj;
  motion.wi = gather<avx512>(w.spin_predicted, p.i, w.fits_registers);
  motion.wj = gather<avx512>(w.spin_predicted, p.j, w.fits_registers);
  const ContactGeometry geometry = contact_geometry(p, motion, squared);
  if (changes) s.callbacks.begin(p, transitions.begun, geometry, motion);
  out = contact_force<Law>(p, p, p.work, s.constants, motion, geometry, touching,
                           changes ? &transitions : nullptr, true);
  if (changes) s.callbacks.end(p, transitions.ended);
  p.normal = geometry.n;
  return true;
}

/// The main loop over the steps of a batch.
template <class Law, bool avx512>
[[gnu::always_inline]] inline bool step_batch(StepBatch& s) {
  ParticleData& w = s.particles;
  bool touched = false;
  for (std::size_t k = 0; k + 1 < s.drive.size(); ++k) {
    const DriveSample& drive = s.drive[k + 1];
    const bool moved_far = half_kick_and_drift(s, s.drive[k], drive);
    ++w.step;
    if (moved_far) {
      s.callbacks.rebuild_neighbour_list();
      s.list_step = w.step;
    }
    if (!w.wall_neighbours.empty()) {
      const std::size_t f = w.blocks * lanes;
      s.jar.wall_points(
          w.wall_neighbours, s.start + static_cast<double>(w.step) * s.constants.dt, drive,
          {column_data(w.position.x), column_data(w.position.y), column_data(w.position.z),
           w.wall_points_due ? nullptr : column_data(w.displacement_squared),
           column_data(w.position.x) + f, column_data(w.position.y) + f,
           column_data(w.position.z) + f, column_data(w.velocity_predicted.x) + f,
           column_data(w.velocity_predicted.y) + f, column_data(w.velocity_predicted.z) + f,
           column_data(w.spin_predicted.x) + f, column_data(w.spin_predicted.y) + f,
           column_data(w.spin_predicted.z) + f});
      w.wall_points_due = false;
    }
    const Lanes zero{};
    s.constants.jar_velocity = {zero + drive.velocity.x, zero + drive.velocity.y,
                                zero + drive.velocity.z};
    touched = false;
    const bool in_registers = avx512 && w.fits_registers;
    Vec<Lanes> force{}, torque{};
    for (std::size_t b = 0; b < w.blocks && !in_registers; ++b)
      w.force.put(b, force), w.torque.put(b, torque);
    ContactForce found;
    for (std::size_t n = 0; n < w.packets.size(); ++n) {
      if (!apply_packet<Law, avx512>(s, w.packets[n], found)) continue;
      touched = true;
      if (in_registers)
        gather_forces(w.gather_maps[n], found, force, torque);
      else
        scatter(w, w.packets[n], found);
    }
    if (in_registers) second_half_kick(w, 0, force, torque);
    for (std::size_t b = 0; b < w.blocks && !in_registers; ++b)
      second_half_kick(w, b, w.force.at(b), w.torque.at(b));
    if (!touched && s.stop_when_idle) return false;
  }
  return touched;
}

template <class Law>
struct BatchLoop {
  template <bool avx512>
  [[gnu::always_inline]] static bool run(StepBatch& s) {
    return step_batch<Law, avx512>(s);
  }
};
template <class Law>
BatchStepper batch_stepper() {
  return Multiversioned<BatchLoop<Law>, BatchStepper>::best();
}

}  // namespace mahlwerk::soft

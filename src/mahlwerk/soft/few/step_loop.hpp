// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/particle_data.hpp"

// The innermost loop of FewBodySolver: a template, compiled for each law and each instruction set.
// V is a register; a packet is computed in groups of as many lanes.
namespace mahlwerk::soft {

/// With eight lanes and at most sixteen bodies, two registers hold a column of all bodies, and one
/// permute instruction picks eight.
template <class V>
constexpr bool can_permute = width_of<V> == lanes;

/// Picks for each lane the number `at` of those of two registers.
template <class V>
[[gnu::always_inline]] inline V permute(const V& low, const V& high, const MaskOf<V>& at) {
#if defined(__clang__)
  V picked = (V)at;
  asm("vpermi2pd %2, %1, %0" : "+v"(picked) : "v"(low), "v"(high));
  return picked;
#else
  return __builtin_shuffle(low, high, at);
#endif
}

/// Gathers the values of a column at the bodies `at` of a group.
template <class V>
[[gnu::always_inline]] inline V gather(const std::vector<Lanes>& column, const LaneMask& at,
                                       const LaneGroup<V>& group, bool fits_registers) {
  const double* all = column_data(column);
  if constexpr (can_permute<V>)
    if (fits_registers) return permute<V>(load<V>(all), load<V>(all + lanes), group(at));
  return lanes_from<V>([&](int l) { return all[at.values[group.first + l]]; });
}
template <class V>
[[gnu::always_inline]] inline Vec<V> gather(const VectorColumns& c, const LaneMask& at,
                                            const LaneGroup<V>& group, bool fits_registers) {
  return {gather<V>(c.x, at, group, fits_registers), gather<V>(c.y, at, group, fits_registers),
          gather<V>(c.z, at, group, fits_registers)};
}

/// Half a kick, a drift, and the velocities predicted for the contacts of this step (velocity
/// Verlet, dem.26). Returns whether a displacement since the last rebuild exceeds the limit.
template <class V>
[[gnu::always_inline]] inline bool half_kick_and_drift(StepBatch& s, const DriveSample& before,
                                                       const DriveSample& after) {
  ParticleData& w = s.particles;
  const V zero{}, step = zero + s.constants.dt, half = 0.5 * step;
  const Vec<V> acceleration_before = in_all_lanes<V>(before.body_acceleration),
               acceleration_after = in_all_lanes<V>(after.body_acceleration);
  const double slack = s.max_displacement - s.jar.max_wall_speed() *
                                                static_cast<double>(w.step - s.list_step) *
                                                s.constants.dt;
  const double limit = slack > 0 ? slack * slack : -1;
  MaskOf<V> moved_far{};
  for (std::size_t b = 0; b < w.blocks * lanes; b += width_of<V>) {
    const Vec<V> half_kick = load<V>(column_data(w.half_kick_factor) + b) * w.force.at<V>(b);
    const Vec<V> v = w.velocity.at<V>(b) + half_kick + half * acceleration_before;
    const Vec<V> x = w.position.at<V>(b) + step * v;
    w.position.put<V>(b, x);
    w.velocity_predicted.put<V>(b, v + half_kick + half * acceleration_after);
    w.velocity.put<V>(
        b, v + half * acceleration_after);  // still without the second half kick of the contacts
    const Vec<V> half_spin_kick =
                     load<V>(column_data(w.half_spin_kick_factor) + b) * w.torque.at<V>(b),
                 spin = w.spin.at<V>(b) + half_spin_kick;
    w.spin.put<V>(b, spin);
    w.spin_predicted.put<V>(b, spin + half_spin_kick);
    const Vec<V> displacement = x - w.list_positions.at<V>(b);
    const V moved = dot(displacement, displacement);
    store<V>(column_data(w.displacement_squared) + b, moved);
    moved_far |= ~less(moved, zero + limit);
  }
  return any(moved_far);
}

/// The second half kick of the contacts on the bodies of a register.
template <class V>
[[gnu::always_inline]] inline void second_half_kick(ParticleData& w, std::size_t b,
                                                    const Vec<V>& force, const Vec<V>& torque) {
  w.velocity.put<V>(b, w.velocity.at<V>(b) + load<V>(column_data(w.half_kick_factor) + b) * force);
  w.spin.put<V>(b, w.spin.at<V>(b) + load<V>(column_data(w.half_spin_kick_factor) + b) * torque);
}

/// Adds the forces and torques of a packet to eight balls in registers, in the order of its lanes.
template <class V>
[[gnu::always_inline]] inline void gather_forces(const GatherMap& map, const ContactForce<V>& f,
                                                 Vec<V>& force, Vec<V>& torque) {
  const LaneGroup<V> group;
  const Vec<V> back = -f.force;
  for (std::size_t k = 0; k < static_cast<std::size_t>(map.max_contacts); ++k) {
    const MaskOf<V> source = group(map.source[k]), active = group(map.active[k]);
    const auto add = [&](V& all, const V& i, const V& j) {
      all += where<V>(active, permute<V>(i, j, source));
    };
    add(force.x, f.force.x, back.x);
    add(force.y, f.force.y, back.y);
    add(force.z, f.force.z, back.z);
    add(torque.x, f.torque_i.x, f.torque_j.x);
    add(torque.y, f.torque_i.y, f.torque_j.y);
    add(torque.z, f.torque_i.z, f.torque_j.z);
  }
}

/// Adds the forces and torques of a group to the balls in memory, for any number of balls.
template <class V>
[[gnu::always_inline]] inline void scatter(ParticleData& w, const PairPacket& p,
                                           const LaneGroup<V>& group, const ContactForce<V>& f) {
  const auto add = [&](std::vector<Lanes>& column, const V& i, const V& j) {
    double* all = column_data(column);
    for (int l = 0; l < width_of<V>; ++l) {
      const auto lane = static_cast<std::size_t>(group.first + l);
      all[p.i[lane]] += i[l];
      if (p.wall[lane] == 0) all[p.j[lane]] += j[l];
    }
  };
  const Vec<V> back = -f.force;
  add(w.force.x, f.force.x, back.x);
  add(w.force.y, f.force.y, back.y);
  add(w.force.z, f.force.z, back.z);
  add(w.torque.x, f.torque_i.x, f.torque_j.x);
  add(w.torque.y, f.torque_i.y, f.torque_j.y);
  add(w.torque.z, f.torque_i.z, f.torque_j.z);
}

/// Positions of a group's pairs, and which of them touch.
template <class V>
struct TouchTest {
  Vec<V> separation;  ///< [m] from i to j
  V squared;          ///< [m2]
  MaskOf<V> touching;
};
template <class V>
[[gnu::always_inline]] inline TouchTest<V> test_touch(const StepBatch& s, const PairPacket& p,
                                                      const LaneGroup<V>& group) {
  const ParticleData& w = s.particles;
  TouchTest<V> test;
  test.separation = gather<V>(w.position, p.j, group, w.fits_registers) -
                    gather<V>(w.position, p.i, group, w.fits_registers);
  if (s.constants.periodic) test.separation = folded(test.separation, s.constants.periods);
  test.squared = dot(test.separation, test.separation);
  const V near = touch_distance<V>(group, p, group(p.touching));
  test.touching = less<V>(test.squared, near * near);
  return test;
}

/// Computes the forces of a group in a step. `begun` and `ended` are bits of lanes.
template <class Law, class V>
[[gnu::always_inline]] inline ContactForce<V> apply_group(StepBatch& s, PairPacket& p,
                                                          const LaneGroup<V>& group,
                                                          const TouchTest<V>& test,
                                                          std::uint32_t begun,
                                                          std::uint32_t ended) {
  const ParticleData& w = s.particles;
  PairMotion<V> motion;
  motion.separation = test.separation;
  motion.vj = gather<V>(w.velocity_predicted, p.j, group, w.fits_registers);
  motion.relative_velocity =
      gather<V>(w.velocity_predicted, p.i, group, w.fits_registers) - motion.vj;
  motion.wi = gather<V>(w.spin_predicted, p.i, group, w.fits_registers);
  motion.wj = gather<V>(w.spin_predicted, p.j, group, w.fits_registers);
  const ContactGeometry<V> geometry = contact_geometry<V>(group, p, motion, test.squared);
  if (begun != 0) {
    OnsetSpeeds speeds;
    put_onset_speeds<V>(group, geometry, motion, speeds);
    s.callbacks.record_onset(p, begun, speeds);
  }
  GroupHistory<V> history{{group(p.law_history[0]), group(p.law_history[1])},
                          group(p.spring),
                          group(p.rolling_spring_torque),
                          group(p.stiffness),
                          group(p.tensile)};
  const ContactTransitions<V> transitions{group.mask(begun), group.mask(ended)};
  WorkOfStep<V> work;
  const ContactForce<V> out =
      contact_force<Law, V>(group, p, history, work, s.constants, motion, geometry, test.touching,
                            (begun | ended) != 0 ? &transitions : nullptr, true);
  if constexpr (Law::has_history) {
    group.put(p.law_history[0], history.law_history[0]);
    group.put(p.law_history[1], history.law_history[1]);
  }
  group.put(p.spring, history.spring);
  if (s.constants.rolling == contact::Rolling::epsd)
    group.put(p.rolling_spring_torque, history.rolling_spring_torque);
  group.put(p.stiffness, history.stiffness);
  group.put(p.tensile, history.tensile);
  group.add(p.work.impulse, work.impulse);
  group.add(p.work.normal, work.normal);
  group.add(p.work.tangential, work.tangential);
  group.add(p.work.rolling, work.rolling);
  group.add(p.work.sliding, work.sliding);
  group.add(p.work.wall, work.wall);
  group.put(p.work.max_overlap, max(group(p.work.max_overlap), work.overlap));
  // A contact that ends keeps the normal of its last step: the ball may have left the face.
  group.put(p.normal,
            ended == 0 ? geometry.n : select<V>(transitions.ended, group(p.normal), geometry.n));
  return out;
}

/// Computes the forces of a packet in a step and gives those of each group to `add`. Returns false
/// if no lane touches and none touched at the last step.
template <class Law, class V, class Add>
[[gnu::always_inline]] inline bool apply_packet(StepBatch& s, PairPacket& p, const Add& add) {
  constexpr int groups = lanes / width_of<V>;
  TouchTest<V> tests[groups];
  std::uint32_t touched = 0, touching = 0;
  for (int n = 0; n < groups; ++n) {
    const LaneGroup<V> group{n * width_of<V>};
    tests[n] = test_touch<V>(s, p, group);
    touched |= group.bits(group(p.touching));
    touching |= group.bits(tests[n].touching);
  }
  if ((touched | touching) == 0) return false;
  const std::uint32_t begun = touching & ~touched, ended = touched & ~touching;
  if (begun != 0) s.callbacks.begin(p, begun);
  for (int n = 0; n < groups; ++n) {
    const LaneGroup<V> group{n * width_of<V>};
    const std::uint32_t own = ((1U << width_of<V>)-1) << group.first;
    if (((touched | touching) & own) == 0) continue;
    add(group, apply_group<Law, V>(s, p, group, tests[n], begun & own, ended & own));
  }
  if (ended != 0) s.callbacks.end(p, ended);
  return true;
}

/// Updates the wall contact points.
[[gnu::always_inline]] inline void update_wall_points(StepBatch& s, const DriveSample& drive) {
  ParticleData& w = s.particles;
  const std::size_t f = w.blocks * lanes;
  s.jar.wall_points(
      w.wall_neighbours, s.start + static_cast<double>(w.step) * s.constants.dt, drive,
      {column_data(w.position.x), column_data(w.position.y), column_data(w.position.z),
       w.wall_points_due ? nullptr : column_data(w.displacement_squared),
       column_data(w.position.x) + f, column_data(w.position.y) + f, column_data(w.position.z) + f,
       column_data(w.velocity_predicted.x) + f, column_data(w.velocity_predicted.y) + f,
       column_data(w.velocity_predicted.z) + f, column_data(w.spin_predicted.x) + f,
       column_data(w.spin_predicted.y) + f, column_data(w.spin_predicted.z) + f});
  w.wall_points_due = false;
}

/// Computes all packets and the second half kick. Returns whether any contact touches.
template <class Law, class V>
[[gnu::always_inline]] inline bool apply_contacts(StepBatch& s) {
  ParticleData& w = s.particles;
  const bool in_registers = can_permute<V> && w.fits_registers;
  bool touched = false;
  Vec<V> force{}, torque{};
  for (std::size_t b = 0; b < w.blocks * lanes && !in_registers; b += width_of<V>)
    w.force.put<V>(b, force), w.torque.put<V>(b, torque);
  for (std::size_t n = 0; n < w.packets.size(); ++n)
    touched |= apply_packet<Law, V>(
        s, w.packets[n], [&](const LaneGroup<V>& group, const ContactForce<V>& found) {
          if constexpr (can_permute<V>)
            if (in_registers) return gather_forces<V>(w.gather_maps[n], found, force, torque);
          scatter<V>(w, w.packets[n], group, found);
        });
  if (in_registers) w.force.put<V>(0, force), w.torque.put<V>(0, torque);
  for (std::size_t b = 0; b < w.blocks * lanes; b += width_of<V>)
    second_half_kick<V>(w, b, w.force.at<V>(b), w.torque.at<V>(b));
  return touched;
}

/// The main loop over the steps of a batch.
template <class Law, class V>
[[gnu::always_inline]] inline bool step_batch(StepBatch& s) {
  ParticleData& w = s.particles;
  bool touched = false;
  for (std::size_t k = 0; k + 1 < s.drive.size(); ++k) {
    const DriveSample& drive = s.drive[k + 1];
    const bool moved_far = half_kick_and_drift<V>(s, s.drive[k], drive);
    ++w.step;
    if (moved_far) {
      s.callbacks.rebuild_neighbour_list();
      s.list_step = w.step;
    }
    if (!w.wall_neighbours.empty()) update_wall_points(s, drive);
    s.constants.jar_velocity = drive.velocity;
    touched = apply_contacts<Law, V>(s);
    if (!touched && s.stop_when_idle) return false;
  }
  return touched;
}

template <class Law>
struct BatchLoop {
  template <int width>
  [[gnu::always_inline]] static bool run(StepBatch& s) {
    return step_batch<Law, Register<width>>(s);
  }
};
template <class Law>
BatchStepper batch_stepper() {
  return Multiversioned<BatchLoop<Law>, BatchStepper>::best();
}

}  // namespace mahlwerk::soft

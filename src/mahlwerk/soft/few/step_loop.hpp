// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/particle_data.hpp"
#include "mahlwerk/soft/kernel/force_rows.hpp"

// The innermost loop of FewBodySolver: a template, compiled for each law and each instruction set.
// V is a register; a packet is computed in groups of as many lanes.
namespace mahlwerk::soft {

/// With eight lanes and at most sixteen bodies, two registers hold a column of all bodies, and one
/// permute instruction picks eight. Clang has no such operation for registers of its vector type.
#if defined(__clang__)
template <class V>
constexpr bool can_permute = false;
#else
template <class V>
constexpr bool can_permute = width_of<V> == lanes;

/// Picks for each lane the number `at` of those of two registers.
template <class V>
[[gnu::always_inline]] inline V permute(const V& low, const V& high, const MaskOf<V>& at) {
  return __builtin_shuffle(low, high, at);
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
#endif

/// The bodies of a packet, in memory or in registers.
template <class V>
struct Bodies {
  const BodyBlock* blocks;
  bool in_registers;

  /// Gathers a column of bodies i or j. `at` are their indices, `offsets` their places in memory.
  [[gnu::always_inline]] V gather(Lanes Vec<Lanes>::*axis, Vec<Lanes> BodyBlock::*columns,
                                  const LaneMask& at,
                                  const std::array<std::int64_t, lanes>& offsets,
                                  const LaneGroup<V>& group) const {
    const Lanes& first = blocks[0].*columns.*axis;
    if constexpr (can_permute<V>)
      if (in_registers) return permute<V>(group(first), group(blocks[1].*columns.*axis), group(at));
    const auto* base = reinterpret_cast<const char*>(&first);
    return lanes_from<V>([&](int l) {
      return *reinterpret_cast<const double*>(base + offsets.data()[group.first + l]);
    });
  }
  [[gnu::always_inline]] Vec<V> gather(Vec<Lanes> BodyBlock::*columns, const LaneMask& at,
                                       const std::array<std::int64_t, lanes>& offsets,
                                       const LaneGroup<V>& group) const {
    return {gather(&Vec<Lanes>::x, columns, at, offsets, group),
            gather(&Vec<Lanes>::y, columns, at, offsets, group),
            gather(&Vec<Lanes>::z, columns, at, offsets, group)};
  }
};

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
  BodyBlock* body = w.bodies.data();
  BallBlock *ball = w.balls.data(), *end = ball + w.balls.size();
  MaskOf<V> moved_far{};
  for (; ball != end; ++body, ++ball)
    for (int first = 0; first < lanes; first += width_of<V>) {
      const LaneGroup<V> group{first};
      const Vec<V> half_kick = group(ball->half_kick_factor) * group(ball->force);
      const Vec<V> v = group(ball->velocity) + half_kick + half * acceleration_before;
      const Vec<V> x = group(body->position) + step * v;
      group.put(body->position, x);
      group.put(body->velocity, v + half_kick + half * acceleration_after);
      // Still without the second half kick of the contacts.
      group.put(ball->velocity, v + half * acceleration_after);
      const Vec<V> half_spin_kick = group(ball->half_spin_kick_factor) * group(ball->torque),
                   spin = group(ball->spin) + half_spin_kick;
      group.put(ball->spin, spin);
      group.put(body->angular_velocity, spin + half_spin_kick);
      const Vec<V> displacement = x - group(ball->list_position);
      const V moved = dot(displacement, displacement);
      group.put(ball->displacement_squared, moved);
      moved_far |= ~less(moved, zero + limit);
    }
  return any(moved_far);
}

/// The second half kick of the contacts.
template <class V>
[[gnu::always_inline]] inline void second_half_kick(BallBlock& ball, const LaneGroup<V>& group,
                                                    const Vec<V>& force, const Vec<V>& torque) {
  group.put(ball.force, force), group.put(ball.torque, torque);
  group.put(ball.velocity, group(ball.velocity) + group(ball.half_kick_factor) * force);
  group.put(ball.spin, group(ball.spin) + group(ball.half_spin_kick_factor) * torque);
}

/// Adds the forces and torques of a group to rows in memory, for any number of balls, in the order
/// of the lanes.
template <class V>
[[gnu::always_inline]] inline void scatter(ForceRow* rows, const PairPacket& p,
                                           const GatherMap& map, const LaneGroup<V>& group,
                                           const ContactForce<V>& f) {
  const ForceRows<V> on_i(f.force, f.torque_i), on_j = on_i.opposite(f.force, f.torque_j);
  for (std::size_t l = 0; l < width_of<V>; ++l) {
    const std::size_t lane = static_cast<std::size_t>(group.first) + l;
    on_i.add(l, rows[p.i[lane]].values);
    on_j.add(l, rows[map.row_j[lane]].values);
  }
}

/// Positions of a group's pairs, and which of them touch.
template <class V>
struct TouchTest {
  Vec<V> separation;  ///< [m] from i to j
  V squared;          ///< [m2]
  MaskOf<V> touching;
};
template <class V>
[[gnu::always_inline]] inline TouchTest<V> test_touch(const StepBatch& s, const Bodies<V>& bodies,
                                                      const PairPacket& p, const GatherMap& map,
                                                      const LaneGroup<V>& group) {
  TouchTest<V> test;
  test.separation = bodies.gather(&BodyBlock::position, p.j, map.offset_j, group) -
                    bodies.gather(&BodyBlock::position, p.i, map.offset_i, group);
  if (s.constants.periodic) test.separation = folded(test.separation, s.constants.periods);
  test.squared = dot(test.separation, test.separation);
  const V near = touch_distance<V>(group, p, group(p.touching));
  test.touching = less<V>(test.squared, near * near);
  return test;
}

/// Computes the forces of a group in a step. `begun` and `ended` are bits of lanes.
template <class Law, class V>
[[gnu::always_inline]] inline ContactForce<V> apply_group(
    StepBatch& s, const Bodies<V>& bodies, PairPacket& p, const GatherMap& map,
    const LaneGroup<V>& group, const TouchTest<V>& test, std::uint32_t begun, std::uint32_t ended) {
  PairMotion<V> motion;
  motion.separation = test.separation;
  motion.vj = bodies.gather(&BodyBlock::velocity, p.j, map.offset_j, group);
  motion.relative_velocity =
      bodies.gather(&BodyBlock::velocity, p.i, map.offset_i, group) - motion.vj;
  motion.wi = bodies.gather(&BodyBlock::angular_velocity, p.i, map.offset_i, group);
  motion.wj = bodies.gather(&BodyBlock::angular_velocity, p.j, map.offset_j, group);
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
[[gnu::always_inline]] inline bool apply_packet(StepBatch& s, const Bodies<V>& bodies,
                                                PairPacket& p, const GatherMap& map,
                                                const Add& add) {
  constexpr int groups = lanes / width_of<V>;
  TouchTest<V> tests[groups];
  std::uint32_t touched = 0, touching = 0;
  for (int n = 0; n < groups; ++n) {
    const LaneGroup<V> group{n * width_of<V>};
    tests[n] = test_touch<V>(s, bodies, p, map, group);
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
    add(group, apply_group<Law, V>(s, bodies, p, map, group, tests[n], begun & own, ended & own));
  }
  if (ended != 0) s.callbacks.end(p, ended);
  return true;
}

/// Updates the wall contact points.
[[gnu::always_inline]] inline void update_wall_points(StepBatch& s, const DriveSample& drive) {
  ParticleData& w = s.particles;
  s.jar.wall_points(w.wall_neighbours, s.start + static_cast<double>(w.step) * s.constants.dt,
                    drive, w.bodies.data(), w.balls.data(), w.bodies.data() + w.balls.size(),
                    w.wall_points_due);
  w.wall_points_due = false;
}

/// Computes all packets and the second half kick. Returns whether any contact touches.
template <class Law, class V>
[[gnu::always_inline]] inline bool apply_contacts(StepBatch& s) {
  ParticleData& w = s.particles;
  const Bodies<V> bodies{w.bodies.data(), can_permute<V> && w.fits_registers};
  BallBlock* balls = w.balls.data();
  ForceRow* rows = w.force_rows.data();
  bool touched = false;
  Vec<V> force{}, torque{};
  if (!bodies.in_registers) std::fill_n(rows, w.force_rows.size(), ForceRow{});
  const std::size_t packets = w.packets.size();
  for (std::size_t n = 0; n < packets; ++n) {
    const GatherMap& map = w.gather_maps[n];
    touched |= apply_packet<Law, V>(s, bodies, w.packets[n], map,
                                    [&](const LaneGroup<V>& group, const ContactForce<V>& found) {
                                      if constexpr (can_permute<V>)
                                        if (bodies.in_registers)
                                          return gather_forces<V>(map, found, force, torque);
                                      scatter<V>(rows, w.packets[n], map, group, found);
                                    });
  }
  if constexpr (can_permute<V>)
    if (bodies.in_registers) {
      second_half_kick<V>(balls[0], {0}, force, torque);
      return touched;
    }
  for (std::size_t b = 0; b < w.balls.size(); ++b)
    for (int first = 0; first < lanes; first += width_of<V>) {
      const ForceRow* row = rows + b * lanes + first;
      V f[4], t[4];
      load_columns<V>([&](std::size_t l) -> const ForceRow& { return row[l]; }, 0, f);
      load_columns<V>([&](std::size_t l) -> const ForceRow& { return row[l]; }, 4, t);
      second_half_kick<V>(balls[b], {first}, {f[0], f[1], f[2]}, {t[0], t[1], t[2]});
    }
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

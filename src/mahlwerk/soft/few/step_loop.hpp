// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/step_block.hpp"
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

  /// Gathers a column of bodies i or j. `at` are their indices, `bodies` their addresses.
  template <std::size_t column>
  [[gnu::always_inline]] V gather(const LaneMask& at,
                                  const std::array<const double*, lanes>& bodies,
                                  const LaneGroup<V>& group) const {
    if constexpr (can_permute<V>)
      if (in_registers) {
        const auto columns = [&](std::size_t b) {
          return group(reinterpret_cast<const Lanes*>(blocks + b)[column]);
        };
        return permute<V>(columns(0), columns(1), group(at));
      }
    return lanes_from<V>([&](int l) { return bodies.data()[group.first + l][column * lanes]; });
  }
  /// Gathers three columns, from `column` on.
  template <std::size_t column>
  [[gnu::always_inline]] Vec<V> gather_vector(const LaneMask& at,
                                              const std::array<const double*, lanes>& bodies,
                                              const LaneGroup<V>& group) const {
    return {gather<column>(at, bodies, group), gather<column + 1>(at, bodies, group),
            gather<column + 2>(at, bodies, group)};
  }
  [[gnu::always_inline]] Vec<V> position(const LaneMask& at,
                                         const std::array<const double*, lanes>& bodies,
                                         const LaneGroup<V>& group) const {
    return gather_vector<0>(at, bodies, group);
  }
  [[gnu::always_inline]] Vec<V> velocity(const LaneMask& at,
                                         const std::array<const double*, lanes>& bodies,
                                         const LaneGroup<V>& group) const {
    return gather_vector<3>(at, bodies, group);
  }
  [[gnu::always_inline]] Vec<V> angular_velocity(const LaneMask& at,
                                                 const std::array<const double*, lanes>& bodies,
                                                 const LaneGroup<V>& group) const {
    return gather_vector<6>(at, bodies, group);
  }
};

/// Half a kick, a drift, and the velocities predicted for the contacts of this step (velocity
/// Verlet, dem.26). Returns whether a displacement since the last rebuild exceeds the limit.
template <class V>
[[gnu::always_inline]] inline bool half_kick_and_drift(const StepBlock& s, ParticleData& w,
                                                       const DriveSample& before,
                                                       const DriveSample& after) {
  const V zero{}, step = zero + s.constants.dt, half = 0.5 * step;
  const Vec<V> acceleration_before = in_all_lanes<V>(before.body_acceleration),
               acceleration_after = in_all_lanes<V>(after.body_acceleration);
  const double slack = s.max_displacement - s.jar.max_wall_speed() *
                                                static_cast<double>(w.step - w.list_step) *
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
      moved_far |= ~less(moved, zero + limit) & group(ball->used);
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

/// The bits of a group's lanes among those of a packet.
template <class V>
[[gnu::always_inline]] inline std::uint32_t bits_of(const LaneGroup<V>& group) {
  return ((1U << width_of<V>)-1) << group.first;
}

/// Puts the forces and torques of a group to the rows of its lanes.
template <class V>
[[gnu::always_inline]] inline void put_forces(GatherMap& map, const LaneGroup<V>& group,
                                              const ContactForce<V>& f) {
  const ForceRows<V> on_i(f.force, f.torque_i), on_j = on_i.opposite(f.force, f.torque_j);
  ForceRow *const *row_i = map.row_i.data() + group.first, *const *row_j =
                                                               map.row_j.data() + group.first;
  unrolled<width_of<V>>([&](std::size_t l) __attribute__((always_inline)) {
    on_i.put(l, row_i[l]->values);
    on_j.put(l, row_j[l]->values);
  });
  map.filled |= bits_of(group);
}

/// Clears the rows of a group in which nothing touches any more.
template <class V>
[[gnu::always_inline]] inline void clear_forces(GatherMap& map, const LaneGroup<V>& group) {
  if ((map.filled & bits_of(group)) == 0) return;
  ForceRow *const *row_i = map.row_i.data() + group.first, *const *row_j =
                                                               map.row_j.data() + group.first;
  unrolled<width_of<V>>([&](std::size_t l)
                            __attribute__((always_inline)) { *row_i[l] = *row_j[l] = ForceRow{}; });
  map.filled &= ~bits_of(group);
}

/// Positions of a group's pairs, and which of them touch.
template <class V>
struct TouchTest {
  Vec<V> separation;  ///< [m] from i to j
  V squared;          ///< [m2]
  MaskOf<V> touching;
};
template <class V>
[[gnu::always_inline]] inline TouchTest<V> test_touch(const StepBlock& s, const Bodies<V>& bodies,
                                                      const PairPacket& p, const GatherMap& map,
                                                      const LaneGroup<V>& group) {
  TouchTest<V> test;
  test.separation =
      bodies.position(p.j, map.body_j, group) - bodies.position(p.i, map.body_i, group);
  if (s.constants.periodic) test.separation = folded(test.separation, s.constants.periods);
  test.squared = dot(test.separation, test.separation);
  const V near = touch_distance<V>(group, p, group(p.touching));
  test.touching = less<V>(test.squared, near * near);
  return test;
}

/// Computes the forces of a group in a step. `begun` and `ended` are lanes of the packet, number
/// `n`.
template <class Law, class V>
[[gnu::always_inline]] inline ContactForce<V> apply_group(
    const StepBlock& s, const Bodies<V>& bodies, std::size_t n, PairPacket& p, const GatherMap& map,
    const LaneGroup<V>& group, const TouchTest<V>& test, std::uint32_t begun, std::uint32_t ended) {
  PairMotion<V> motion;
  motion.separation = test.separation;
  motion.vj = bodies.velocity(p.j, map.body_j, group);
  motion.relative_velocity = bodies.velocity(p.i, map.body_i, group) - motion.vj;
  motion.wi = bodies.angular_velocity(p.i, map.body_i, group);
  motion.wj = bodies.angular_velocity(p.j, map.body_j, group);
  const ContactGeometry<V> geometry = contact_geometry<V>(group, p, motion, test.squared);
  if (begun != 0) {
    OnsetSpeeds speeds;
    put_onset_speeds<V>(group, geometry, motion, speeds);
    s.callbacks.record_onset({n, begun}, speeds);
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

/// Computes the forces of packet `n` in a step and gives those of each group to `put`. Returns
/// whether contacts ended.
template <class Law, class V, class Put>
[[gnu::always_inline]] inline bool apply_packet(StepBlock& s, const Bodies<V>& bodies,
                                                std::size_t n, const Put& put) {
  constexpr int groups = lanes / width_of<V>;
  PairPacket& p = s.packets[n];
  GatherMap& map = s.gather_maps[n];
  TouchTest<V> tests[groups];
  std::uint32_t touched = 0, touching = 0;
  for (int k = 0; k < groups; ++k) {
    const LaneGroup<V> group{k * width_of<V>};
    tests[k] = test_touch<V>(s, bodies, p, map, group);
    touched |= group.bits(group(p.touching));
    touching |= group.bits(tests[k].touching);
  }
  const std::uint32_t begun = touching & ~touched, ended = touched & ~touching;
  if (begun != 0) s.callbacks.begin({n, begun});
  if (ended != 0) s.callbacks.end({n, ended});
  for (int k = 0; k < groups; ++k) {
    const LaneGroup<V> group{k * width_of<V>};
    const std::uint32_t own = bits_of(group);
    if (((touched | touching) & own) == 0)
      clear_forces<V>(map, group);
    else
      put(map, group,
          apply_group<Law, V>(s, bodies, n, p, map, group, tests[k], begun & own, ended & own));
  }
  return ended != 0;
}

/// Updates the wall contact points of a charge.
[[gnu::always_inline]] inline void update_wall_points(const StepBlock& s, ParticleData& w,
                                                      const DriveSample& drive) {
  if (w.wall_neighbours.empty()) return;
  s.jar.wall_points(w.wall_neighbours, w.wall_point_lanes,
                    s.start + static_cast<double>(w.step) * s.constants.dt, drive, w.bodies.data(),
                    w.balls.data(), w.bodies.data() + w.balls.size(), w.wall_points_due);
  w.wall_points_due = false;
}

/// Sums the force rows of each ball, in the order of its lanes; then the second half kick. Unused
/// lanes of the last group may get forces of other balls, which their factor 0 cancels.
template <class V>
[[gnu::always_inline]] inline void sum_forces(ParticleData& w) {
  const auto* rows = reinterpret_cast<const char*>(w.force_rows.data());
  const std::uint32_t* offset = w.row_offsets.data();
  const std::uint16_t* rows_of_ball = w.rows_of_ball.data();
  ForceRow sums[width_of<V>]{};
  for (std::size_t ball = 0; ball < w.count; ball += width_of<V>) {
    const std::size_t end = std::min<std::size_t>(width_of<V>, w.count - ball);
    for (std::size_t l = 0; l < end; ++l) {
      RowSum<V> sum;
      for (int left = rows_of_ball[ball + l]; left > 0; --left)
        sum.add(reinterpret_cast<const double*>(rows + *offset++));
      sum.put(sums[l].values);
    }
    V f[4], t[4];
    load_columns<V>([&](std::size_t l) -> const ForceRow& { return sums[l]; }, 0, f);
    load_columns<V>([&](std::size_t l) -> const ForceRow& { return sums[l]; }, 4, t);
    second_half_kick<V>(w.balls[ball / lanes], {static_cast<int>(ball % lanes)}, {f[0], f[1], f[2]},
                        {t[0], t[1], t[2]});
  }
}

/// Computes all packets, and the second half kick of all charges.
template <class Law, class V>
[[gnu::always_inline]] inline void apply_contacts(StepBlock& s) {
  const bool in_registers = can_permute<V> && !s.shared && s.charges.front()->fits_registers;
  const Bodies<V> bodies{s.shared ? nullptr : s.charges.front()->bodies.data(), in_registers};
  Vec<V> force{}, torque{};
  bool ended = false;
  for (std::size_t n = 0; n < s.packets.size(); ++n) {
    const auto put = [&](GatherMap & map, const LaneGroup<V>& group, const ContactForce<V>& found)
        __attribute__((always_inline)) {
      if constexpr (can_permute<V>)
        if (in_registers) return gather_forces<V>(map, found, force, torque);
      put_forces<V>(map, group, found);
    };
    ended |= apply_packet<Law, V>(s, bodies, n, put);
  }
  for (ParticleData* w : s.charges) {
    w->touched = w->contacts > 0;
    if constexpr (can_permute<V>)
      if (in_registers) {
        second_half_kick<V>(w->balls[0], {0}, force, torque);
        continue;
      }
    sum_forces<V>(*w);
  }
  if (ended) s.callbacks.forces_done();
}

/// Moves all charges by a step, and their wall contact points. Charges that fail are taken out.
template <class V>
[[gnu::always_inline]] inline void move_charges(StepBlock& s, const DriveSample& before,
                                                const DriveSample& after) {
  for (std::size_t c = 0; c < s.charges.size();) {
    ParticleData& w = *s.charges[c];
    const bool moved_far = half_kick_and_drift<V>(s, w, before, after);
    ++w.step;
    if (moved_far && !s.callbacks.rebuild_neighbour_list(c)) continue;
    update_wall_points(s, w, after);
    ++c;
  }
}

/// The main loop over the steps of a block.
template <class Law, class V>
[[gnu::always_inline]] inline void step_block(StepBlock& s) {
  for (std::size_t k = 0; k + 1 < s.drive.size() && !s.charges.empty(); ++k) {
    ++s.step;
    move_charges<V>(s, s.drive[k], s.drive[k + 1]);
    s.constants.jar_velocity = s.drive[k + 1].velocity;
    apply_contacts<Law, V>(s);
    bool pause = s.step == s.pause;
    for (const ParticleData* w : s.charges) pause |= !w->touched && w->step >= w->idle_from;
    if (pause && k + 2 < s.drive.size() && !s.callbacks.pause()) return;
  }
}

template <class Law>
struct BlockLoop {
  template <int width>
  [[gnu::always_inline]] static void run(StepBlock& s) {
    step_block<Law, Register<width>>(s);
  }
};
template <class Law>
BlockStepper block_stepper() {
  return Multiversioned<BlockLoop<Law>, BlockStepper>::best();
}

}  // namespace mahlwerk::soft

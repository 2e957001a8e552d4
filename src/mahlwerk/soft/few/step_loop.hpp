// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/bodies.hpp"
#include "mahlwerk/soft/few/integration.hpp"

// The innermost loop of FewBodySolver: a template, compiled for each law and each instruction set.
// V is a register; a packet is computed in groups of as many lanes.
namespace mahlwerk::soft {

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
  if (has_friction_history(s.constants)) get_friction_history<V>(group, p, history);
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
  put_friction_history<V>(s.constants, group, history, p);
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

/// Adds the forces of the wall contacts of a group to the loads of the jar and its parts.
template <class V>
inline void add_wall_loads(const StepBlock& s, const Bodies<V>& bodies, const PairPacket& p,
                           const GatherMap& map, const LaneGroup<V>& group,
                           const DriveSample& drive, const ContactForce<V>& force) {
  const Vec<V> points = bodies.position(p.j, map.body_j, group);
  for (int l = 0; l < width_of<V>; ++l) {
    const auto lane = static_cast<std::size_t>(group.first + l);
    const auto of = [&](const Vec<V>& a) { return Vec3{a.x[l], a.y[l], a.z[l]}; };
    if (p.wall[lane] != 0 && p.touching[lane] != 0)
      s.callbacks.add_wall_load(drive,
                                {p.face[lane], of(points), of(force.force), of(force.torque_j)});
  }
}

/// Updates the wall contact points of a charge.
[[gnu::always_inline]] inline void update_wall_points(const StepBlock& s, ParticleData& w,
                                                      const DriveSample& drive) {
  if (w.wall_neighbours.empty()) return;
  s.jar.wall_points(w.wall_neighbours, w.wall_point_lanes,
                    s.start + static_cast<double>(w.step) * s.constants.dt, drive, w.bodies.data(),
                    w.balls.data(), w.bodies.data() + w.balls.size(), w.wall_points_due,
                    w.near_facets.data());
  w.wall_points_due = false;
}

/// Computes all packets, and the second half kick of all charges.
template <class Law, class V>
[[gnu::always_inline]] inline void apply_contacts(StepBlock& s, const DriveSample& drive) {
  const bool in_registers = can_permute<V> && !s.shared && s.charges.front()->fits_registers;
  const Bodies<V> bodies{s.shared ? nullptr : s.charges.front()->bodies.data(), in_registers};
  Vec<V> force{}, torque{};
  bool ended = false;
  for (std::size_t n = 0; n < s.packets.size(); ++n) {
    const auto put = [&](GatherMap & map, const LaneGroup<V>& group, const ContactForce<V>& found)
        __attribute__((always_inline)) {
      if (s.loads) add_wall_loads<V>(s, bodies, s.packets[n], map, group, drive, found);
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
  if (s.liquid)
    for (std::size_t c = 0; c < s.charges.size(); ++c) s.callbacks.add_liquid_forces(c, drive);
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
    apply_contacts<Law, V>(s, s.drive[k + 1]);
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

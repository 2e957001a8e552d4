// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/soft/kernel/force_rows.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"

// Gathers the bodies of a group of contacts from the ball records, and scatters forces back to the
// balls.
namespace mahlwerk::soft {

/// The balls of the lanes of a group.
template <class V>
[[gnu::always_inline]] inline const std::int32_t* bodies_of(const LaneBodies& at,
                                                            const LaneGroup<V>& group) {
  return at.data() + group.first;
}

/// Gathers positions and velocities.
template <class V>
[[gnu::always_inline]] inline void gather_motion(const BallRecord* rows, const std::int32_t* at,
                                                 Vec<V>& position, Vec<V>& velocity) {
  V x[4], v[4];
  const auto row = [&](std::size_t l) -> const BallRecord& { return rows[at[l]]; };
  load_columns<V>(row, 0, x);
  load_columns<V>(row, 4, v);
  position = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
}
/// Gathers the differences of positions and velocities, j minus i.
template <class V>
[[gnu::always_inline]] inline void gather_differences(const BallRecord* rows, const std::int32_t* i,
                                                      const std::int32_t* j, Vec<V>& position,
                                                      Vec<V>& velocity) {
  if constexpr (width_of<V> == 8) {  // half the transpositions
    V x[4], v[4];
    unrolled<4>([&](std::size_t k) __attribute__((always_inline)) {
      const BallRecord &a = rows[i[k]], &a4 = rows[i[k + 4]];
      const BallRecord &b = rows[j[k]], &b4 = rows[j[k + 4]];
      x[k] = load_fours(b, b4, 0) - load_fours(a, a4, 0);
      v[k] = load_fours(b, b4, 4) - load_fours(a, a4, 4);
    });
    transpose(x), transpose(v);
    position = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
  } else if constexpr (width_of<V> == 4) {
    V x[4], v[4];
    unrolled<4>([&](std::size_t k) __attribute__((always_inline)) {
      const BallRecord &a = rows[i[k]], &b = rows[j[k]];
      x[k] = load_part<V>(b, 0) - load_part<V>(a, 0);
      v[k] = load_part<V>(b, 4) - load_part<V>(a, 4);
    });
    transpose(x), transpose(v);
    position = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
  } else {
    Vec<V> xi, vi, xj, vj;
    gather_motion<V>(rows, i, xi, vi);
    gather_motion<V>(rows, j, xj, vj);
    position = xj - xi, velocity = vj - vi;
  }
}
template <class V>
[[gnu::always_inline]] inline Vec<V> gather_spins(const SpinRecord* spins, const std::int32_t* at) {
  V w[4];
  load_columns<V>([&](std::size_t l) -> const SpinRecord& { return spins[at[l]]; }, 0, w);
  return {w[0], w[1], w[2]};
}

/// Scatters: adds a row for each lane of a group to those of its balls, in the order of the lanes.
template <class V>
[[gnu::always_inline]] inline void add_rows(VectorPair* ball_forces, std::int32_t first,
                                            const std::int32_t* at, const ForceRows<V>& rows) {
  unrolled<width_of<V>>([&](std::size_t l) __attribute__((always_inline)) {
    rows.add(l, &ball_forces[at[l] - first].x);
  });
}

/// The bodies of a packet: the balls, or with rounded bodies their spheres, which are placed first.
inline PacketRows packet_rows(const ChunkStep& s, Chunk& chunk, ContactPackets& list, std::size_t n,
                              ContactKind kind) {
  const ContactPacket& g = list.packets[n];
  if (!s.rounded) return {s.rows, s.spins, &g.i, &g.j};
  s.callbacks->place_contact_spheres(chunk, list, n);
  const ContactSpheres& spheres = chunk.spheres;
  return {spheres.rows.data(), spheres.spins.data(), &spheres.i,
          kind == ContactKind::wall ? &g.j : &spheres.j};
}

/// Adds the torques of the forces on the spheres of rounded bodies about their centres of mass.
template <class V>
[[gnu::always_inline]] inline void add_arm_torques(const LaneGroup<V>& group,
                                                   const ContactSpheres& spheres,
                                                   ContactForce<V>& force) {
  force.torque_i = force.torque_i + cross(group(spheres.arm_i), force.force);
  force.torque_j = force.torque_j - cross(group(spheres.arm_j), force.force);
}

/// Relative motion of the pairs of a group. `points` are the wall contact points of its packet,
/// `from` has its bodies.
template <class V>
[[gnu::always_inline]] inline PairMotion<V> gather_pair_motion(const ChunkStep& s,
                                                               const PacketRows& from,
                                                               const LaneGroup<V>& group,
                                                               ContactKind kind,
                                                               const Vec<Lanes>& points) {
  PairMotion<V> motion;
  const V zero{};
  const std::int32_t *i = bodies_of<V>(*from.i, group), *j = bodies_of<V>(*from.j, group);
  Vec<V> position, velocity;
  motion.wi = gather_spins<V>(from.spins, i);
  if (kind == ContactKind::wall) {
    gather_motion<V>(from.rows, i, position, velocity);
    const Vec<V> at = group(points);
    motion.wj = in_all_lanes<V>(s.drive.spin);
    Vec<V> offset{};
    for (int l = 0; s.turning && l < width_of<V>; ++l) {
      if (j[l] < s.jar->first_rotor_face()) continue;
      const MovingWall::FaceMotion of = s.jar->face_motion(j[l], s.drive, s.wall_axes);
      motion.wj.x[l] = of.spin.x, motion.wj.y[l] = of.spin.y, motion.wj.z[l] = of.spin.z;
      offset.x[l] = of.velocity.x, offset.y[l] = of.velocity.y, offset.z[l] = of.velocity.z;
    }
    motion.vj = cross(motion.wj, at);
    if (s.turning) motion.vj = motion.vj + offset;
    motion.separation = at - position;
    motion.relative_velocity = velocity - motion.vj;
  } else {
    gather_differences<V>(from.rows, i, j, position, velocity);
    motion.separation = position;
    if (s.constants.periodic) motion.separation = folded(position, s.constants.periods);
    motion.relative_velocity = -velocity;
    motion.vj = {zero, zero, zero};
    motion.wj = gather_spins<V>(from.spins, j);
  }
  return motion;
}

[[gnu::always_inline]] inline void prefetch(const ChunkStep& s, const ContactPacket& g,
                                            ContactKind kind) {
  for (std::size_t l = 0; l < lanes; ++l) {
    __builtin_prefetch(&s.spins[g.i[l]]);
    if (kind == ContactKind::wall) continue;
    __builtin_prefetch(&s.rows[g.j[l]]);
    __builtin_prefetch(&s.spins[g.j[l]]);
  }
}

}  // namespace mahlwerk::soft

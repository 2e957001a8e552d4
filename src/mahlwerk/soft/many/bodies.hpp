// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/soft/many/chunk_step.hpp"

// Gathers the bodies of eight contacts from the ball records, and scatters forces back to the
// balls.
namespace mahlwerk::soft {

using LaneBodies = std::array<std::int32_t, lanes>;  // a body for each lane

/// Gathers positions and velocities. Without AVX-512, element by element.
template <bool avx512>
[[gnu::always_inline]] inline void gather_motion(const BallRecord* rows, const LaneBodies& at,
                                                 Vec<Lanes>& position, Vec<Lanes>& velocity) {
  Lanes x[4], v[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const BallRecord& a = rows[at[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!avx512) {
      x[0][l] = a.x, x[1][l] = a.y, x[2][l] = a.z;
      v[0][l] = a.u, v[1][l] = a.v, v[2][l] = a.w;
    } else if (k < 4) {
      const BallRecord& b = rows[at[k + 4]];
      x[k] = load_fours(a, b), v[k] = load_last_fours(a, b);
    }
  }
  if constexpr (avx512) transpose(x), transpose(v);
  position = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
}
/// Gathers the differences of positions and velocities, j minus i.
template <bool avx512>
[[gnu::always_inline]] inline void gather_differences(const BallRecord* rows,
                                                      const ContactPacket& g, Vec<Lanes>& position,
                                                      Vec<Lanes>& velocity) {
  Lanes x[4], v[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const BallRecord &i = rows[g.i[k]], &j = rows[g.j[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!avx512) {
      x[0][l] = j.x - i.x, x[1][l] = j.y - i.y, x[2][l] = j.z - i.z;
      v[0][l] = j.u - i.u, v[1][l] = j.v - i.v, v[2][l] = j.w - i.w;
    } else if (k < 4) {
      const BallRecord &i4 = rows[g.i[k + 4]], &j4 = rows[g.j[k + 4]];
      x[k] = load_fours(j, j4) - load_fours(i, i4),
      v[k] = load_last_fours(j, j4) - load_last_fours(i, i4);
    }
  }
  if constexpr (avx512) transpose(x), transpose(v);
  position = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
}
template <bool avx512>
[[gnu::always_inline]] inline Vec<Lanes> gather_spins(const SpinRecord* spins,
                                                      const LaneBodies& at) {
  Lanes w[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const SpinRecord& a = spins[at[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!avx512)
      w[0][l] = a.x, w[1][l] = a.y, w[2][l] = a.z;
    else if (k < 4)
      w[k] = load_fours(a, spins[at[k + 4]]);
  }
  if constexpr (avx512) transpose(w);
  return {w[0], w[1], w[2]};
}

/// Scatters: adds forces and torques to the rows of the balls, in the order of the lanes.
template <bool avx512>
[[gnu::always_inline]] inline void add_forces(VectorPair* ball_forces, std::int32_t first,
                                              const LaneBodies& at, const Vec<Lanes>& force,
                                              const Vec<Lanes>& torque) {
  Lanes r[8] = {force.x, force.y, force.z, {}, torque.x, torque.y, torque.z, {}};
  if constexpr (avx512) {
    transpose(r);
    for (int l = 0; l < lanes; ++l) {
      VectorPair& sum = ball_forces[at[static_cast<std::size_t>(l)] - first];
      store_eight(sum, load_eight(sum) + r[l]);
    }
  } else {
    for (int l = 0; l < lanes; ++l) {
      VectorPair& sum = ball_forces[at[static_cast<std::size_t>(l)] - first];
      sum.x += r[0][l], sum.y += r[1][l], sum.z += r[2][l];
      sum.a += r[4][l], sum.b += r[5][l], sum.c += r[6][l];
    }
  }
}

/// Relative motion of the pairs of a packet.
template <bool avx512>
[[gnu::always_inline]] inline PairMotion gather_pair_motion(const ChunkStep& s,
                                                            const ContactPacket& g,
                                                            LaneMask touching, ContactKind kind) {
  PairMotion motion;
  const Lanes zero{};
  Vec<Lanes> position, velocity;
  motion.wi = gather_spins<avx512>(s.spins, g.i);
  if (kind == ContactKind::wall) {
    AlignedLanes points[3];
    s.jar->wall_points(s.rows, g.i, g.j, touching, s.time, s.pull_off_distance, points);
    gather_motion<avx512>(s.rows, g.i, position, velocity);
    const Vec<Lanes> at{points[0].value, points[1].value, points[2].value};
    const Vec3& spin = s.drive.spin;
    motion.wj = {zero + spin.x, zero + spin.y, zero + spin.z};
    for (int l = 0; s.turning && l < lanes; ++l) {
      if (g.j[static_cast<std::size_t>(l)] < s.jar->first_rotor_face()) continue;
      const Vec3& rotor = s.drive.rotor_spin;
      motion.wj.x[l] = rotor.x, motion.wj.y[l] = rotor.y, motion.wj.z[l] = rotor.z;
    }
    motion.vj = cross(motion.wj, at);
    motion.separation = at - position;
    motion.relative_velocity = velocity - motion.vj;
  } else {
    gather_differences<avx512>(s.rows, g, position, velocity);
    motion.separation = position;
    if (s.constants.periodic) motion.separation = folded(position, s.constants.periods);
    motion.relative_velocity = -velocity;
    motion.vj = {zero, zero, zero};
    motion.wj = gather_spins<avx512>(s.spins, g.j);
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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/isa.hpp"
#include "mahlwerk/soft/many/bodies.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"
#include "mahlwerk/soft/many/prefetch_queue.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

// A step of a chunk: contacts, then the balls. A template, compiled for each law and instruction
// set.
namespace mahlwerk::soft {

/// Gathers the parameters of a packet's species pairs, lane by lane.
[[gnu::always_inline]] inline void gather_parameters(const PairParameters* parameters,
                                                     const ContactPacket& g, PairParameters& out) {
  for (int l = 0; l < lanes; ++l)
    copy_lane(parameters[g.species_pair[static_cast<std::size_t>(l)]], l, out, l);
}

/// Computes the contacts of one kind and adds their forces to the balls of the chunk.
template <class Law, bool avx512>
[[gnu::always_inline]] inline void apply_packets(ChunkStep& s, Chunk& chunk, ContactKind kind,
                                                 VectorPair* ball_forces, PrefetchQueue& prefetches,
                                                 ContactWork& sums) {
  ContactPackets& list = kind == ContactKind::own    ? chunk.own
                         : kind == ContactKind::halo ? chunk.halo
                                                     : chunk.wall;
  PairParameters gathered;
  for (std::size_t n = 0; n < list.packets.size(); ++n) {
    ContactPacket& g = list.packets[n];
    prefetches.fetch();
    if (g.touching == 0) continue;
    if (n + 2 < list.packets.size()) prefetch(s, list.packets[n + 2], kind);
    const LaneMask touched = mask(g.touching);
    const PairMotion motion = gather_pair_motion<avx512>(s, g, touched, kind);
    const PairParameters* parameters = &s.parameters[g.species_pair[0]];
    if (!list.parameters.empty())
      parameters = &list.parameters[n];
    else if (!g.one_species_pair)
      gather_parameters(s.parameters, g, gathered), parameters = &gathered;
    const Lanes squared = dot(motion.separation, motion.separation),
                near = touch_distance(*parameters, touched);
    const LaneMask touching = less(squared, near * near) & touched;
    const ContactGeometry geometry = contact_geometry(*parameters, motion, squared);
    const ContactTransitions transitions{mask(g.begun), touching ^ touched};
    const bool ends = any(transitions.ended), changes = ends || g.begun != 0;
    if (g.begun != 0) {
      s.callbacks->begin(chunk, list, n, geometry, motion);
      if (!list.parameters.empty()) parameters = &list.parameters[n];
    }
    History past;
    past.spring = g.spring;
    past.tensile = mask(g.tensile);
    if (s.has_history) {
      const OptionalHistory& k = list.optional_histories[n];
      for (int i = 0; i < contact::law_history_size; ++i) past.law_history[i] = k.law_history[i];
      past.rolling_spring_torque = k.rolling_spring_torque, past.stiffness = k.stiffness;
    }
    ContactWork d;
    const ContactForce out =
        contact_force<Law>(*parameters, past, d, s.constants, motion, geometry, touching,
                           changes ? &transitions : nullptr, kind == ContactKind::wall);
    g.spring = past.spring;
    g.tensile = any(past.tensile) ? bits(past.tensile, lanes) : 0;
    if (s.has_history) {
      OptionalHistory& k = list.optional_histories[n];
      for (int i = 0; i < contact::law_history_size; ++i) k.law_history[i] = past.law_history[i];
      k.rolling_spring_torque = past.rolling_spring_torque, k.stiffness = past.stiffness;
    }
    g.impulse += d.impulse;
    g.lost_normal += d.normal;
    g.lost_tangential += d.tangential + d.rolling;
    sums.normal += d.normal, sums.tangential += d.tangential, sums.rolling += d.rolling;
    sums.sliding += d.sliding;
    if (kind == ContactKind::wall) sums.wall += d.wall;
    sums.max_overlap = max(sums.max_overlap, d.max_overlap * parameters->inverse_radius);
    add_forces<avx512>(ball_forces, chunk.first, g.i, out.force, out.torque_i);
    if (kind == ContactKind::own)
      add_forces<avx512>(ball_forces, chunk.first, g.j, -out.force, out.torque_j);
    if (ends) s.callbacks->end(chunk, list, n, touching);
    if (kind == ContactKind::wall) list.wall_normals[n].normal = geometry.n;
  }
}

/// Tests `count` pairs, at most eight: a bit for each that touches.
template <bool avx512>
[[gnu::always_inline]] inline std::uint32_t touching_bits(const ChunkStep& s,
                                                          const NeighbourPair* pairs,
                                                          std::size_t count) {
  PairSeparation pair = pair_separations<avx512>(s.rows, pairs, count);
  if (s.constants.periodic) pair.centres = folded(pair.centres, s.constants.periods);
  const LaneMask mask = less(dot(pair.centres, pair.centres), pair.touch * pair.touch);
  if (!any(mask)) return 0;
  return bits(mask, count);
}

/// Tests the due pairs of the Verlet list; those that touch become contacts.
template <bool avx512>
[[gnu::always_inline]] inline void find_contacts(const ChunkStep& s, Chunk& chunk) {
  VerletList& w = chunk.ball_pairs;
  const auto scan = [&](const std::vector<NeighbourPair>& pairs, std::size_t end) {
    chunk.new_touches.clear();
    for (std::size_t k = 0; k < end; k += lanes) {
      constexpr std::size_t lookahead = 4 * lanes;  // prefetch distance in pairs
      for (std::size_t n = k + lookahead; n < std::min(end, k + lookahead + lanes); ++n)
        __builtin_prefetch(&s.rows[pairs[n].other]);
      std::uint32_t bits =
          touching_bits<avx512>(s, pairs.data() + k, std::min<std::size_t>(lanes, end - k));
      for (; bits != 0; bits &= bits - 1)
        chunk.new_touches.push_back(static_cast<std::int32_t>(k) + __builtin_ctz(bits));
    }
    chunk.sums.tests += static_cast<std::int64_t>(end);
  };
  scan(w.pairs, w.due(chunk.max_gap_decrease, s.bin));
  for (std::size_t n = chunk.new_touches.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.new_touches[n]);
    s.callbacks->activate(chunk, w.pairs[k]);
    w.remove(k);
  }
  scan(w.separated, w.separated.size());
  for (std::size_t n = chunk.new_touches.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.new_touches[n]);
    s.callbacks->activate(chunk, w.separated[k]);
    w.separated[k] = w.separated.back();
    w.separated.pop_back();
  }
}

/// Integrates the balls of a chunk over a step (velocity Verlet, dem.26).
template <bool avx512, bool streaming>
[[gnu::always_inline]] inline void integrate_balls(const ChunkStep& s, const Chunk& chunk,
                                                   const VectorPair* ball_forces,
                                                   ChunkDisplacement& displacement) {
  const double dt = s.constants.dt;
  const Vec3 &b0 = s.drive.body_acceleration, &b1 = s.next_drive.body_acceleration;
  const Lanes body_kick_before = dt * Lanes{b0.x, b0.y, b0.z},
              body_kick_after = 0.5 * dt * Lanes{b1.x, b1.y, b1.z};
  const Four predicted_mean{displacement.predicted_mean.x, displacement.predicted_mean.y,
                            displacement.predicted_mean.z};
  Four sum{}, max_deviation{};
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Lanes half_kick =
        s.half_kick_factors[s.species[i]].value * load_eight(ball_forces[i - chunk.first]);
    const Lanes half = load_eight(s.half_step[i]) + 2.0 * half_kick + body_kick_before;
    const Lanes predicted = half + half_kick + body_kick_after;
    store_eight(s.half_step[i], half);
    const Lanes row = load_eight(s.rows[i]);
    const Lanes position =
        row + dt * __builtin_shufflevector(half, Lanes{}, 0, 1, 2, 8, 8, 8, 8, 8);
    const Lanes next = __builtin_shufflevector(position, predicted, 0, 1, 2, 3, 8, 9, 10, 15);
    const Four turn = __builtin_shufflevector(predicted, predicted, 4, 5, 6, 15);
    if constexpr (streaming) {
      stream_store(s.next_rows[i], next);
      stream_store(s.next_spins[i], turn);
    } else {
      store_eight(s.next_rows[i], next);
      store_four(s.next_spins[i], turn);
    }
    const Four way = __builtin_shufflevector(position, position, 0, 1, 2, 2) -
                     load_four(s.reference_positions[i]);
    const Four deviation = way - predicted_mean;
    sum += way;
    max_deviation = max_deviation > deviation ? max_deviation : deviation;
    max_deviation = max_deviation > -deviation ? max_deviation : -deviation;
  }
  if constexpr (streaming) store_fence();
  const double count = std::max(1, chunk.last - chunk.first);
  displacement.spread =
      std::sqrt(max_deviation[0] * max_deviation[0] + max_deviation[1] * max_deviation[1] +
                max_deviation[2] * max_deviation[2]);
  displacement.mean = {sum[0] / count, sum[1] / count, sum[2] / count};
}

/// Queues the memory of the next chunk for prefetching.
[[gnu::always_inline]] inline PrefetchQueue prefetch_next_chunk(const ChunkStep& s,
                                                                const Chunk& chunk,
                                                                const Chunk* following) {
  PrefetchQueue prefetches;
  if (following == nullptr) return prefetches;
  const Chunk& c = *following;
  const auto balls = static_cast<std::size_t>(c.last - c.first);
  prefetches.add(&s.rows[c.first], balls);
  prefetches.add(&s.spins[c.first], balls);
  prefetches.add(c.ball_pairs.pairs.data(), c.ball_pairs.due(c.max_gap_decrease, s.bin));
  prefetches.add(c.own.packets.data(), c.own.packets.size());
  prefetches.add(c.halo.packets.data(), c.halo.packets.size());
  prefetches.add(&s.half_step[c.first], balls);
  prefetches.add(&s.reference_positions[c.first], balls);
  prefetches.divide(chunk.own.packets.size() + chunk.halo.packets.size());
  return prefetches;
}

/// One step of a chunk.
template <class Law, bool avx512>
[[gnu::always_inline]] inline void step_chunk(ChunkStep& s, Chunk& chunk, const Chunk* following,
                                              BallForces& ball_forces,
                                              ChunkDisplacement& displacement) {
  PrefetchQueue prefetches = prefetch_next_chunk(s, chunk, following);
  find_contacts<avx512>(s, chunk);
  s.callbacks->test_walls(chunk);
  std::fill_n(ball_forces.begin(), chunk.last - chunk.first, VectorPair{});
  // Not unrolled: otherwise this large body would be compiled three times.
#pragma GCC unroll 1
  for (const ContactKind kind : {ContactKind::own, ContactKind::halo, ContactKind::wall}) {
    ContactWork d;
    apply_packets<Law, avx512>(s, chunk, kind, ball_forces.data(), prefetches, d);
    const double part = kind == ContactKind::halo ? 0.5 : 1;
    ContactWork& all = chunk.sums.work;
    all.normal += part * d.normal;
    all.tangential += part * d.tangential;
    all.rolling += part * d.rolling;
    all.sliding += part * d.sliding;
    all.wall += d.wall;
    all.max_overlap = max(all.max_overlap, d.max_overlap);
  }
  chunk.sums.ball_steps += chunk.balls_in_contact;
  if (avx512 && s.large)
    integrate_balls<avx512, avx512>(s, chunk, ball_forces.data(), displacement);
  else
    integrate_balls<avx512, false>(s, chunk, ball_forces.data(), displacement);
}

template <class Law>
struct ChunkLoop {
  template <bool avx512>
  [[gnu::always_inline]] static void run(ChunkStep& s, Chunk& c, const Chunk* next, BallForces& l,
                                         ChunkDisplacement& d) {
    step_chunk<Law, avx512>(s, c, next, l, d);
  }
};
template <class Law>
ChunkStepper chunk_stepper() {
  return Multiversioned<ChunkLoop<Law>, ChunkStepper>::best();
}

}  // namespace mahlwerk::soft

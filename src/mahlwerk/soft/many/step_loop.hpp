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

// A step of a chunk: contacts, then the balls. One text for each law and instruction set.
namespace mahlwerk::soft {

/// Lane by lane the parameters of their species pairs.
[[gnu::always_inline]] inline void gather(const PairParameters* parameters, const ContactPacket& g,
                                          PairParameters& out) {
  for (int l = 0; l < lanes; ++l)
    copy_lane(parameters[g.species_pair[static_cast<std::size_t>(l)]], l, out, l);
}

/// Contacts of one kind: what they do to the balls of the chunk.
template <class Law, bool avx512>
[[gnu::always_inline]] inline void apply_packets(ChunkStep& s, Chunk& chunk, ContactKind kind,
                                                 VectorPair* loads, PrefetchQueue& ahead,
                                                 ContactWork& sums) {
  ContactPackets& list = kind == ContactKind::own    ? chunk.own
                         : kind == ContactKind::halo ? chunk.halo
                                                     : chunk.wall;
  PairParameters made;
  for (std::size_t n = 0; n < list.packets.size(); ++n) {
    ContactPacket& g = list.packets[n];
    ahead.fetch();
    if (g.touching == 0) continue;
    if (n + 2 < list.packets.size()) prefetch(s, list.packets[n + 2], kind);
    const LaneMask touched = mask(g.touching);
    const Bodies b = bodies<avx512>(s, g, touched, kind);
    const PairParameters* parameters = &s.parameters[g.species_pair[0]];
    if (!list.parameters.empty())
      parameters = &list.parameters[n];
    else if (!g.alike)
      gather(s.parameters, g, made), parameters = &made;
    const Lanes squared = dot(b.apart, b.apart), near = touch_distance(*parameters, touched);
    const LaneMask touching = less(squared, near * near) & touched;
    const ContactGeometry m = contact_geometry(*parameters, b, squared);
    const Edges edges{mask(g.fresh), touching ^ touched};
    const bool ends = any(edges.ended), changes = ends || g.fresh != 0;
    if (g.fresh != 0) {
      s.events->begin(chunk, list, n, m, b);
      if (!list.parameters.empty()) parameters = &list.parameters[n];
    }
    History past;
    past.spring = g.spring;
    past.pulls = mask(g.pulling);
    if (s.remembers) {
      const Memory& k = list.memories[n];
      for (int i = 0; i < contact::law_memories; ++i) past.memory[i] = k.memory[i];
      past.roll = k.roll, past.stiffness = k.stiffness;
    }
    ContactWork d;
    const ContactForce out =
        contact_force<Law>(*parameters, past, d, s.frame, b, m, touching,
                           changes ? &edges : nullptr, kind == ContactKind::wall);
    g.spring = past.spring;
    g.pulling = any(past.pulls) ? bits(past.pulls, lanes) : 0;
    if (s.remembers) {
      Memory& k = list.memories[n];
      for (int i = 0; i < contact::law_memories; ++i) k.memory[i] = past.memory[i];
      k.roll = past.roll, k.stiffness = past.stiffness;
    }
    g.impulse += d.impulse;
    g.lost_normal += d.normal;
    g.lost_across += d.tangential + d.rolling;
    sums.normal += d.normal, sums.tangential += d.tangential, sums.rolling += d.rolling;
    sums.sliding += d.sliding;
    if (kind == ContactKind::wall) sums.wall += d.wall;
    sums.deepest = larger(sums.deepest, d.deepest * parameters->per_radius);
    add<avx512>(loads, chunk.first, g.i, out.force, out.torque_i);
    if (kind == ContactKind::own) add<avx512>(loads, chunk.first, g.j, -out.force, out.torque_j);
    if (ends) s.events->end(chunk, list, n, touching);
    if (kind == ContactKind::wall) list.facings[n].normal = m.n;
  }
}

/// Which of the pairs from `at` on, up to eight, touch: a bit for each.
template <bool avx512>
[[gnu::always_inline]] inline std::uint32_t touching_of(const ChunkStep& s,
                                                        const NeighbourPair* pairs,
                                                        std::size_t count) {
  Apart pair = apart<avx512>(s.rows, pairs, count);
  if (s.frame.periodic) pair.centres = folded(pair.centres, s.frame.periods);
  const LaneMask mask = less(dot(pair.centres, pair.centres), pair.touch * pair.touch);
  if (!any(mask)) return 0;
  return bits(mask, count);
}

/// Pairs that are near: those that touch now become contacts.
template <bool avx512>
[[gnu::always_inline]] inline void find_contacts(const ChunkStep& s, Chunk& chunk) {
  VerletList& w = chunk.near;
  const auto scan = [&](const std::vector<NeighbourPair>& pairs, std::size_t end) {
    chunk.met.clear();
    for (std::size_t k = 0; k < end; k += lanes) {
      constexpr std::size_t ahead = 4 * lanes;  // so that rows are there when they are asked for
      for (std::size_t n = k + ahead; n < std::min(end, k + ahead + lanes); ++n)
        __builtin_prefetch(&s.rows[pairs[n].other]);
      std::uint32_t bits =
          touching_of<avx512>(s, pairs.data() + k, std::min<std::size_t>(lanes, end - k));
      for (; bits != 0; bits &= bits - 1)
        chunk.met.push_back(static_cast<std::int32_t>(k) + __builtin_ctz(bits));
    }
    chunk.sums.tests += static_cast<std::int64_t>(end);
  };
  scan(w.pairs, w.due(chunk.bound, s.bin));
  for (std::size_t n = chunk.met.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.met[n]);
    s.events->activate(chunk, w.pairs[k]);
    w.remove(k);
  }
  scan(w.separated, w.separated.size());
  for (std::size_t n = chunk.met.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.met[n]);
    s.events->activate(chunk, w.separated[k]);
    w.separated[k] = w.separated.back();
    w.separated.pop_back();
  }
}

/// The balls of a chunk, a step on (dem.26).
template <bool avx512, bool past_cache>
[[gnu::always_inline]] inline void move(const ChunkStep& s, const Chunk& chunk,
                                        const VectorPair* loads, Drift& drift) {
  const double dt = s.frame.step;
  const Vec3 &b0 = s.before.pull, &b1 = s.after.pull;
  const Lanes pull0 = dt * Lanes{b0.x, b0.y, b0.z}, pull1 = 0.5 * dt * Lanes{b1.x, b1.y, b1.z};
  const Four guess{drift.guess.x, drift.guess.y, drift.guess.z};
  Four sum{}, most{};
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Lanes kick = s.kicks[s.species[i]].is * eight(loads[i - chunk.first]);
    const Lanes half = eight(s.half[i]) + 2.0 * kick + pull0;
    const Lanes seen = half + kick + pull1;
    put_eight(s.half[i], half);
    const Lanes row = eight(s.rows[i]);
    const Lanes position =
        row + dt * __builtin_shufflevector(half, Lanes{}, 0, 1, 2, 8, 8, 8, 8, 8);
    const Lanes next = __builtin_shufflevector(position, seen, 0, 1, 2, 3, 8, 9, 10, 15);
    const Four turn = __builtin_shufflevector(seen, seen, 4, 5, 6, 15);
    if constexpr (past_cache) {
      put_past_cache(s.next[i], next);
      put_past_cache(s.next_spins[i], turn);
    } else {
      put_eight(s.next[i], next);
      put_four(s.next_spins[i], turn);
    }
    const Four way =
        __builtin_shufflevector(position, position, 0, 1, 2, 2) - four(s.list_positions[i]);
    const Four off = way - guess;
    sum += way;
    most = most > off ? most : off;
    most = most > -off ? most : -off;
  }
  if constexpr (past_cache) all_are_put();
  const double count = std::max(1, chunk.last - chunk.first);
  drift.spread = std::sqrt(most[0] * most[0] + most[1] * most[1] + most[2] * most[2]);
  drift.mean = {sum[0] / count, sum[1] / count, sum[2] / count};
}

/// What the chunk after this one will ask for.
[[gnu::always_inline]] inline PrefetchQueue fetching(const ChunkStep& s, const Chunk& chunk,
                                                     const Chunk* following) {
  PrefetchQueue ahead;
  if (following == nullptr) return ahead;
  const Chunk& c = *following;
  const auto balls = static_cast<std::size_t>(c.last - c.first);
  ahead.add(&s.rows[c.first], balls);
  ahead.add(&s.spins[c.first], balls);
  ahead.add(c.near.pairs.data(), c.near.due(c.bound, s.bin));
  ahead.add(c.own.packets.data(), c.own.packets.size());
  ahead.add(c.halo.packets.data(), c.halo.packets.size());
  ahead.add(&s.half[c.first], balls);
  ahead.add(&s.list_positions[c.first], balls);
  ahead.divide(chunk.own.packets.size() + chunk.halo.packets.size());
  return ahead;
}

/// One step of a chunk.
template <class Law, bool avx512>
[[gnu::always_inline]] inline void step_chunk(ChunkStep& s, Chunk& chunk, const Chunk* following,
                                              Loads& loads, Drift& drift) {
  PrefetchQueue ahead = fetching(s, chunk, following);
  find_contacts<avx512>(s, chunk);
  s.events->test_walls(chunk);
  std::fill_n(loads.begin(), chunk.last - chunk.first, VectorPair{});
#pragma GCC unroll 1
  for (const ContactKind kind :
       {ContactKind::own, ContactKind::halo, ContactKind::wall}) {  // the text once, not thrice
    ContactWork d;
    apply_packets<Law, avx512>(s, chunk, kind, loads.data(), ahead, d);
    const double part = kind == ContactKind::halo ? 0.5 : 1;
    ContactWork& all = chunk.sums.work;
    all.normal += part * d.normal;
    all.tangential += part * d.tangential;
    all.rolling += part * d.rolling;
    all.sliding += part * d.sliding;
    all.wall += d.wall;
    all.deepest = larger(all.deepest, d.deepest);
  }
  chunk.sums.ball_steps += chunk.in_touch;
  if (avx512 && s.large)
    move<avx512, avx512>(s, chunk, loads.data(), drift);
  else
    move<avx512, false>(s, chunk, loads.data(), drift);
}

template <class Law>
struct ChunkLoop {
  template <bool avx512>
  [[gnu::always_inline]] static void run(ChunkStep& s, Chunk& c, const Chunk* next, Loads& l,
                                         Drift& d) {
    step_chunk<Law, avx512>(s, c, next, l, d);
  }
};
template <class Law>
ChunkStepper chunk_stepper() {
  return Compiled<ChunkLoop<Law>, ChunkStepper>::best();
}

}  // namespace mahlwerk::soft

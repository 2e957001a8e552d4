// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/ahead.hpp"
#include "mahlwerk/soft/apart.hpp"
#include "mahlwerk/soft/machines.hpp"
#include "mahlwerk/soft/pass.hpp"

// A step of a chunk of a crowd: contacts, then the balls. One text for each law and kind of
// machine.
namespace mahlwerk::soft {

enum class Whose { own, cross, wall };

using Bodied = std::array<std::int32_t, lanes>;  // a body for each lane

/// Places and velocities. Without wide registers, number by number.
template <bool wide>
[[gnu::always_inline]] inline void motion(const Row* rows, const Bodied& at, Vec<Lanes>& place,
                                          Vec<Lanes>& velocity) {
  Lanes x[4], v[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const Row& a = rows[at[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!wide) {
      x[0][l] = a.x, x[1][l] = a.y, x[2][l] = a.z;
      v[0][l] = a.u, v[1][l] = a.v, v[2][l] = a.w;
    } else if (k < 4) {
      const Row& b = rows[at[k + 4]];
      x[k] = fours(a, b), v[k] = last_fours(a, b);
    }
  }
  if constexpr (wide) transpose(x), transpose(v);
  place = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
}
/// The same, of j less i.
template <bool wide>
[[gnu::always_inline]] inline void differences(const Row* rows, const Grip& g, Vec<Lanes>& place,
                                               Vec<Lanes>& velocity) {
  Lanes x[4], v[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const Row &i = rows[g.i[k]], &j = rows[g.j[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!wide) {
      x[0][l] = j.x - i.x, x[1][l] = j.y - i.y, x[2][l] = j.z - i.z;
      v[0][l] = j.u - i.u, v[1][l] = j.v - i.v, v[2][l] = j.w - i.w;
    } else if (k < 4) {
      const Row &i4 = rows[g.i[k + 4]], &j4 = rows[g.j[k + 4]];
      x[k] = fours(j, j4) - fours(i, i4), v[k] = last_fours(j, j4) - last_fours(i, i4);
    }
  }
  if constexpr (wide) transpose(x), transpose(v);
  place = {x[0], x[1], x[2]}, velocity = {v[0], v[1], v[2]};
}
template <bool wide>
[[gnu::always_inline]] inline Vec<Lanes> spins(const Turn* turns, const Bodied& at) {
  Lanes w[4];
  for (std::size_t k = 0; k < lanes; ++k) {
    const Turn& a = turns[at[k]];
    const auto l = static_cast<int>(k);
    if constexpr (!wide)
      w[0][l] = a.x, w[1][l] = a.y, w[2][l] = a.z;
    else if (k < 4)
      w[k] = fours(a, turns[at[k + 4]]);
  }
  if constexpr (wide) transpose(w);
  return {w[0], w[1], w[2]};
}

/// Adds forces and torques to the rows of the balls, in the order of the lanes.
template <bool wide>
[[gnu::always_inline]] inline void add(Twin* loads, std::int32_t first,
                                       const std::array<std::int32_t, lanes>& at,
                                       const Vec<Lanes>& force, const Vec<Lanes>& torque) {
  Lanes r[8] = {force.x, force.y, force.z, {}, torque.x, torque.y, torque.z, {}};
  if constexpr (wide) {
    transpose(r);
    for (int l = 0; l < lanes; ++l) {
      Twin& sum = loads[at[static_cast<std::size_t>(l)] - first];
      put_eight(sum, eight(sum) + r[l]);
    }
  } else {
    for (int l = 0; l < lanes; ++l) {
      Twin& sum = loads[at[static_cast<std::size_t>(l)] - first];
      sum.x += r[0][l], sum.y += r[1][l], sum.z += r[2][l];
      sum.a += r[4][l], sum.b += r[5][l], sum.c += r[6][l];
    }
  }
}

/// The bodies of a grip.
template <bool wide>
[[gnu::always_inline]] inline Bodies bodies(const Pass& s, const Grip& g, LaneMask touching,
                                            Whose whose) {
  Bodies b;
  const Lanes none{};
  Vec<Lanes> place, velocity;
  b.wi = spins<wide>(s.turns, g.i);
  if (whose == Whose::wall) {
    Eight foot[3];
    s.jar->feet(s.rows, g.i, g.j, touching, s.time, s.reach, foot);
    motion<wide>(s.rows, g.i, place, velocity);
    const Vec<Lanes> at{foot[0].is, foot[1].is, foot[2].is};
    const Vec3& spin = s.before.spin;
    b.wj = {none + spin.x, none + spin.y, none + spin.z};
    for (int l = 0; s.turning && l < lanes; ++l) {
      if (g.j[static_cast<std::size_t>(l)] < s.jar->turning_from()) continue;
      const Vec3& rotor = s.before.rotor;
      b.wj.x[l] = rotor.x, b.wj.y[l] = rotor.y, b.wj.z[l] = rotor.z;
    }
    b.vj = cross(b.wj, at);
    b.apart = at - place;
    b.relative = velocity - b.vj;
  } else {
    differences<wide>(s.rows, g, place, velocity);
    b.apart = place;
    if (s.frame.periodic)
      b.apart = {folded(place.x, s.frame.periods.x), folded(place.y, s.frame.periods.y),
                 folded(place.z, s.frame.periods.z)};
    b.relative = -velocity;
    b.vj = {none, none, none};
    b.wj = spins<wide>(s.turns, g.j);
  }
  return b;
}

[[gnu::always_inline]] inline void prefetch(const Pass& s, const Grip& g, Whose whose) {
  for (std::size_t l = 0; l < lanes; ++l) {
    __builtin_prefetch(&s.turns[g.i[l]]);
    if (whose == Whose::wall) continue;
    __builtin_prefetch(&s.rows[g.j[l]]);
    __builtin_prefetch(&s.turns[g.j[l]]);
  }
}

/// Lane by lane what their breeds are.
[[gnu::always_inline]] inline void mixed(const Make* makes, const Grip& g, Make& out) {
  for (int l = 0; l < lanes; ++l) copy_lane(makes[g.breed[static_cast<std::size_t>(l)]], l, out, l);
}

/// Contacts of one kind: what they do to the balls of the chunk.
template <class Law, bool wide>
[[gnu::always_inline]] inline void grip(Pass& s, Chunk& chunk, Whose whose, Twin* loads,
                                        Ahead& ahead, Deeds& sums) {
  Grips& list = whose == Whose::own ? chunk.own : whose == Whose::cross ? chunk.cross : chunk.wall;
  Make made;
  for (std::size_t n = 0; n < list.grips.size(); ++n) {
    Grip& g = list.grips[n];
    ahead.fetch();
    if (g.touching == 0) continue;
    if (n + 2 < list.grips.size()) prefetch(s, list.grips[n + 2], whose);
    const LaneMask touched = mask(g.touching);
    const Bodies b = bodies<wide>(s, g, touched, whose);
    const Make* make = &s.makes[g.breed[0]];
    if (!list.makes.empty())
      make = &list.makes[n];
    else if (!g.alike)
      mixed(s.makes, g, made), make = &made;
    const Lanes squared = dot(b.apart, b.apart), near = touch_distance(*make, touched);
    const LaneMask touching = less(squared, near * near) & touched;
    const Meeting m = meet(*make, b, squared);
    if (g.fresh != 0) {
      s.comings->begin(chunk, list, n, m, b);
      if (!list.makes.empty()) make = &list.makes[n];
    }
    if (any(touching ^ touched)) s.comings->end(chunk, list, n, touching);
    if (whose == Whose::wall) list.facings[n].normal = m.n;
    History past;
    past.spring = g.spring;
    if (s.remembers) {
      const Memory& k = list.memories[n];
      for (int i = 0; i < contact::law_memories; ++i) past.memory[i] = k.memory[i];
      past.roll = k.roll, past.stiffness = k.stiffness;
    }
    Deeds d;
    const Push out = push<Law>(*make, past, d, s.frame, b, m, touching, whose == Whose::wall);
    g.spring = past.spring;
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
    if (whose == Whose::wall) sums.wall += d.wall;
    sums.deepest = larger(sums.deepest, d.deepest * make->per_radius);
    add<wide>(loads, chunk.first, g.i, out.force, out.torque_i);
    if (whose == Whose::own) add<wide>(loads, chunk.first, g.j, -out.force, out.torque_j);
  }
}

/// Which of the pairs from `at` on, up to eight, touch: a bit for each.
template <bool wide>
[[gnu::always_inline]] inline int touching_of(const Pass& s, const Nigh* pairs, std::size_t count) {
  Apart pair = apart<wide>(s.rows, pairs, count);
  if (s.frame.periodic)
    pair.centres = {folded(pair.centres.x, s.frame.periods.x),
                    folded(pair.centres.y, s.frame.periods.y),
                    folded(pair.centres.z, s.frame.periods.z)};
  const LaneMask mask = less(dot(pair.centres, pair.centres), pair.touch * pair.touch);
  if (!any(mask)) return 0;
  int bits = 0;
  for (std::size_t l = 0; l < count; ++l) bits |= mask[static_cast<int>(l)] != 0 ? 1 << l : 0;
  return bits;
}

/// Pairs that are near: those that touch now become contacts.
template <bool wide>
[[gnu::always_inline]] inline void look(const Pass& s, Chunk& chunk) {
  Waiting& w = chunk.near;
  const auto scan = [&](const std::vector<Nigh>& pairs, std::size_t end) {
    chunk.met.clear();
    for (std::size_t k = 0; k < end; k += lanes) {
      constexpr std::size_t ahead = 4 * lanes;  // so that rows are there when they are asked for
      for (std::size_t n = k + ahead; n < std::min(end, k + ahead + lanes); ++n)
        __builtin_prefetch(&s.rows[pairs[n].other]);
      int bits = touching_of<wide>(s, pairs.data() + k, std::min<std::size_t>(lanes, end - k));
      for (; bits != 0; bits &= bits - 1)
        chunk.met.push_back(static_cast<std::int32_t>(k) +
                            __builtin_ctz(static_cast<unsigned>(bits)));
    }
    chunk.doings.tests += static_cast<std::int64_t>(end);
  };
  scan(w.pairs, w.due(chunk.bound, s.bin));
  for (std::size_t n = chunk.met.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.met[n]);
    s.comings->seize(chunk, w.pairs[k]);
    w.remove(k);
  }
  scan(w.parted, w.parted.size());
  for (std::size_t n = chunk.met.size(); n-- > 0;) {
    const auto k = static_cast<std::size_t>(chunk.met[n]);
    s.comings->seize(chunk, w.parted[k]);
    w.parted[k] = w.parted.back();
    w.parted.pop_back();
  }
}

/// The balls of a chunk, a step on (dem.26).
template <bool wide, bool past_cache>
[[gnu::always_inline]] inline void move(const Pass& s, const Chunk& chunk, const Twin* loads,
                                        Drift& drift) {
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
    const Lanes place = row + dt * __builtin_shufflevector(half, Lanes{}, 0, 1, 2, 8, 8, 8, 8, 8);
    const Lanes next = __builtin_shufflevector(place, seen, 0, 1, 2, 3, 8, 9, 10, 15);
    const Four turn = __builtin_shufflevector(seen, seen, 4, 5, 6, 15);
    if constexpr (past_cache) {
      put_past_cache(s.next[i], next);
      put_past_cache(s.next_turns[i], turn);
    } else {
      put_eight(s.next[i], next);
      put_four(s.next_turns[i], turn);
    }
    const Four way = __builtin_shufflevector(place, place, 0, 1, 2, 2) - four(s.looked[i]);
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
[[gnu::always_inline]] inline Ahead fetching(const Pass& s, const Chunk& chunk,
                                             const Chunk* following) {
  Ahead ahead;
  if (following == nullptr) return ahead;
  const Chunk& c = *following;
  const auto balls = static_cast<std::size_t>(c.last - c.first);
  ahead.add(&s.rows[c.first], balls);
  ahead.add(&s.turns[c.first], balls);
  ahead.add(c.near.pairs.data(), c.near.due(c.bound, s.bin));
  ahead.add(c.own.grips.data(), c.own.grips.size());
  ahead.add(c.cross.grips.data(), c.cross.grips.size());
  ahead.add(&s.half[c.first], balls);
  ahead.add(&s.looked[c.first], balls);
  ahead.divide(chunk.own.grips.size() + chunk.cross.grips.size());
  return ahead;
}

/// The main loop's body for a crowd.
template <class Law, bool wide>
[[gnu::always_inline]] inline void pass(Pass& s, Chunk& chunk, const Chunk* following, Loads& loads,
                                        Drift& drift) {
  Ahead ahead = fetching(s, chunk, following);
  look<wide>(s, chunk);
  s.comings->look_at_walls(chunk);
  std::fill_n(loads.begin(), chunk.last - chunk.first, Twin{});
#pragma GCC unroll 1
  for (const Whose whose : {Whose::own, Whose::cross, Whose::wall}) {  // the text once, not thrice
    Deeds d;
    grip<Law, wide>(s, chunk, whose, loads.data(), ahead, d);
    const double part = whose == Whose::cross ? 0.5 : 1;
    Deeds& all = chunk.doings.deeds;
    all.normal += part * d.normal;
    all.tangential += part * d.tangential;
    all.rolling += part * d.rolling;
    all.sliding += part * d.sliding;
    all.wall += d.wall;
    all.deepest = larger(all.deepest, d.deepest);
  }
  chunk.doings.ball_steps += chunk.in_touch;
  if (wide && s.large)
    move<wide, wide>(s, chunk, loads.data(), drift);
  else
    move<wide, false>(s, chunk, loads.data(), drift);
}

#ifdef MAHLWERK_WIDE
template <class Law>
[[gnu::target("avx512f,avx512dq,avx512vl"), gnu::flatten]] void pass_wide(Pass& s, Chunk& c,
                                                                          const Chunk* next,
                                                                          Loads& l, Drift& d) {
  pass<Law, true>(s, c, next, l, d);
}
#endif
#ifdef MAHLWERK_MIDDLING
template <class Law>
[[gnu::target("avx2"), gnu::flatten]] void pass_middling(Pass& s, Chunk& c, const Chunk* next,
                                                         Loads& l, Drift& d) {
  pass<Law, false>(s, c, next, l, d);
}
#endif
template <class Law>
[[gnu::flatten]] void pass_plain(Pass& s, Chunk& c, const Chunk* next, Loads& l, Drift& d) {
  pass<Law, false>(s, c, next, l, d);
}

template <class Law>
PassOf pass_of() {
#ifdef MAHLWERK_WIDE
  if (machine() == Machine::wide) return pass_wide<Law>;
#endif
#ifdef MAHLWERK_MIDDLING
  if (machine() == Machine::middling) return pass_middling<Law>;
#endif
  return pass_plain<Law>;
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/many/bodies.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"
#include "mahlwerk/soft/many/prefetch_queue.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

// A step of a chunk: contacts, then the balls. A template, compiled for each law and instruction
// set. V is a register; a packet is computed in groups of as many lanes.
namespace mahlwerk::soft {

/// Gathers the parameters of a packet's species pairs, lane by lane.
[[gnu::always_inline]] inline void gather_parameters(const PairParameters* parameters,
                                                     const ContactPacket& g, PairParameters& out) {
  for (std::size_t l = 0; l < lanes; ++l) copy_lane(parameters[g.species_pair[l]], l, out, l);
}

/// Computes the forces of a group. `begun`, `ended` and `tensile` (at the last step) are bits of
/// lanes.
template <class Law, class V>
[[gnu::always_inline]] inline ContactForce<V> apply_group(
    ChunkStep& s, ContactPackets& list, std::size_t n, const LaneGroup<V>& group,
    const PairMotion<V>& motion, const ContactGeometry<V>& geometry, const MaskOf<V>& touching,
    std::uint32_t begun, std::uint32_t ended, std::uint32_t tensile,
    const PairParameters& parameters, ContactKind kind, ContactWork& sums) {
  ContactPacket& g = list.packets[n];
  if (begun != 0) {
    OnsetSpeeds speeds;
    put_onset_speeds<V>(group, geometry, motion, speeds);
    s.callbacks->record_onset(list, n, begun, speeds);
  }
  GroupHistory<V> history;
  history.spring = group(g.spring);
  history.tensile = group.mask(tensile);
  if (s.has_history) {
    const OptionalHistory& k = list.optional_histories[n];
    history.law_history[0] = group(k.law_history[0]);
    history.law_history[1] = group(k.law_history[1]);
    history.rolling_spring_torque = group(k.rolling_spring_torque);
    history.stiffness = group(k.stiffness);
  }
  const ContactTransitions<V> transitions{group.mask(begun), group.mask(ended)};
  WorkOfStep<V> work;
  const ContactForce<V> out = contact_force<Law, V>(
      group, parameters, history, work, s.constants, motion, geometry, touching,
      (begun | ended) != 0 ? &transitions : nullptr, kind == ContactKind::wall);
  group.put(g.spring, history.spring);
  g.tensile |= group.bits(history.tensile);
  if (s.has_history) {
    OptionalHistory& k = list.optional_histories[n];
    group.put(k.law_history[0], history.law_history[0]);
    group.put(k.law_history[1], history.law_history[1]);
    group.put(k.rolling_spring_torque, history.rolling_spring_torque);
    group.put(k.stiffness, history.stiffness);
  }
  group.add(g.impulse, work.impulse);
  group.add(g.lost_normal, work.normal);
  group.add(g.lost_tangential, work.tangential + work.rolling);
  group.add(sums.normal, work.normal);
  group.add(sums.tangential, work.tangential);
  group.add(sums.rolling, work.rolling);
  group.add(sums.sliding, work.sliding);
  if (kind == ContactKind::wall) group.add(sums.wall, work.wall);
  group.put(sums.max_overlap,
            max(group(sums.max_overlap), work.overlap * group(parameters.inverse_radius)));
  if (kind == ContactKind::wall) {
    // A contact that ends keeps the normal of its last step: the ball may have left the face.
    Vec<Lanes>& normal = list.wall_normals[n].normal;
    group.put(normal,
              ended == 0 ? geometry.n : select<V>(transitions.ended, group(normal), geometry.n));
  }
  return out;
}

/// Motion, geometry and touch test of a group.
template <class V>
struct GroupState {
  PairMotion<V> motion;
  ContactGeometry<V> geometry;
  MaskOf<V> touching;
};
template <class V>
[[gnu::always_inline]] inline GroupState<V> group_state(const ChunkStep& s, const ContactPacket& g,
                                                        const LaneGroup<V>& group, ContactKind kind,
                                                        const Vec<Lanes>& points,
                                                        const PairParameters& parameters) {
  GroupState<V> state;
  const MaskOf<V> touched = group.mask(g.touching);
  state.motion = gather_pair_motion<V>(s, g, group, kind, points);
  const V squared = dot(state.motion.separation, state.motion.separation),
          near = touch_distance<V>(group, parameters, touched);
  state.touching = less<V>(squared, near * near) & touched;
  state.geometry = contact_geometry<V>(group, parameters, state.motion, squared);
  return state;
}

/// Computes the contacts of a packet and adds their forces to the balls of the chunk: first those
/// of balls i, then those of balls j, each in the order of the lanes.
template <class Law, class V>
[[gnu::always_inline]] inline void apply_packet(ChunkStep& s, Chunk& chunk, ContactPackets& list,
                                                std::size_t n, ContactKind kind,
                                                VectorPair* ball_forces,
                                                const PairParameters& species_parameters,
                                                ContactWork& sums) {
  ContactPacket& g = list.packets[n];
  Vec<Lanes> points;
  if (kind == ContactKind::wall)
    s.jar->wall_points(s.rows, g.i, g.j, g.touching, s.time, s.pull_off_distance, points);
  const std::uint32_t begun = g.begun, tensile = g.tensile;
  if (begun != 0) s.callbacks->begin(chunk, list, n);
  const PairParameters& parameters =
      list.parameters.empty() ? species_parameters : list.parameters[n];
  ForceRows<V> on_j[lanes / width_of<V>];
  std::uint32_t touching = 0;
  g.tensile = 0;
  for (int first = 0; first < lanes; first += width_of<V>) {
    const LaneGroup<V> group{first};
    const std::uint32_t own = ((1U << width_of<V>)-1) << first;
    const auto f = static_cast<std::size_t>(first);
    if ((g.touching & own) == 0) continue;
    const GroupState<V> state = group_state<V>(s, g, group, kind, points, parameters);
    const std::uint32_t still = group.bits(state.touching);
    touching |= still;
    const ContactForce<V> force = apply_group<Law, V>(
        s, list, n, group, state.motion, state.geometry, state.touching, begun & own,
        g.touching & own & ~still, tensile, parameters, kind, sums);
    const ForceRows<V> on_i(force.force, force.torque_i);
    add_rows<V>(ball_forces, chunk.first, g.i.data() + f, on_i);
    if (kind == ContactKind::own)
      on_j[f / width_of<V>] = on_i.opposite(force.force, force.torque_j);
  }
  if (kind == ContactKind::own)
    for (std::size_t f = 0; f < lanes; f += width_of<V>)
      if ((g.touching >> f & ((1U << width_of<V>)-1)) != 0)
        add_rows<V>(ball_forces, chunk.first, g.j.data() + f, on_j[f / width_of<V>]);
  if (const std::uint32_t ended = g.touching & ~touching; ended != 0)
    s.callbacks->end(chunk, list, n, ended);
}

/// Computes the contacts of one kind and adds their forces to the balls of the chunk.
template <class Law, class V>
[[gnu::always_inline]] inline void apply_packets(ChunkStep& s, Chunk& chunk, ContactKind kind,
                                                 VectorPair* ball_forces, PrefetchQueue& prefetches,
                                                 ContactWork& sums) {
  ContactPackets& list = kind == ContactKind::own    ? chunk.own
                         : kind == ContactKind::halo ? chunk.halo
                                                     : chunk.wall;
  PairParameters gathered;
  for (std::size_t n = 0; n < list.packets.size(); ++n) {
    const ContactPacket& g = list.packets[n];
    prefetches.fetch();
    if (g.touching == 0) continue;
    if (s.large && n + 2 < list.packets.size()) prefetch(s, list.packets[n + 2], kind);
    const PairParameters* parameters = &s.parameters[g.species_pair[0]];
    if (list.parameters.empty() && !g.one_species_pair)
      gather_parameters(s.parameters, g, gathered), parameters = &gathered;
    apply_packet<Law, V>(s, chunk, list, n, kind, ball_forces, *parameters, sums);
  }
}

/// Tests `count` pairs, at most a register: a bit for each that touches.
template <class V>
[[gnu::always_inline]] inline std::uint32_t touching_bits(const ChunkStep& s,
                                                          const NeighbourPair* pairs,
                                                          std::size_t count) {
  PairSeparation<V> pair = pair_separations<V>(s.rows, pairs, count);
  if (s.constants.periodic) pair.centres = folded(pair.centres, s.constants.periods);
  return bits(less<V>(dot(pair.centres, pair.centres), pair.touch * pair.touch)) &
         ((1U << count) - 1);
}

/// Tests the due pairs of the Verlet list; those that touch become contacts.
template <class V>
[[gnu::always_inline]] inline void find_contacts(const ChunkStep& s, Chunk& chunk) {
  VerletList& w = chunk.ball_pairs;
  const auto scan = [&](const std::vector<NeighbourPair>& pairs, std::size_t end) {
    chunk.new_touches.clear();
    for (std::size_t k = 0; k < end; k += width_of<V>) {
      constexpr std::size_t lookahead = 4 * lanes;  // prefetch distance in pairs
      for (std::size_t n = k + lookahead; s.large && n < std::min(end, k + lookahead + width_of<V>);
           ++n)
        __builtin_prefetch(&s.rows[pairs[n].other]);
      std::uint32_t bits =
          touching_bits<V>(s, pairs.data() + k, std::min<std::size_t>(width_of<V>, end - k));
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

/// Stores the parts of a record, past the cache if `streaming`.
template <bool streaming, class V, std::size_t parts, class R>
[[gnu::always_inline]] inline void store_record(R& record, const V (&values)[parts]) {
  for (std::size_t p = 0; p < parts; ++p) {
    if constexpr (streaming)
      stream_part<V>(record, p * width_of<V>, values[p]);
    else
      store_part<V>(record, p * width_of<V>, values[p]);
  }
}

/// A ball's numbers in a step of the integration, in parts of a register: four of the position,
/// eight of the predicted velocity and spin.
template <class V>
struct IntegratedBall {
  static constexpr std::size_t count = 4 / std::min(width_of<V>, 4);
  using Part = Register<std::min(width_of<V>, 4)>;
  Part position[count], velocity[count], spin[count];
};

/// Velocity Verlet (dem.26) for a ball: advances its half-step velocity and spin.
template <class V>
[[gnu::always_inline]] inline IntegratedBall<V> integrate_ball(const ChunkStep& s, std::int32_t i,
                                                               const VectorPair& ball_force,
                                                               const VectorPair& body_kick_before,
                                                               const VectorPair& body_kick_after) {
  constexpr std::size_t w = width_of<V>;
  using Ball = IntegratedBall<V>;
  using Part = typename Ball::Part;
  const Lanes& factor = s.half_kick_factors[s.species[i]];
  Ball ball;
  for (std::size_t part = 0; part < 8; part += w) {
    const V half_kick = load<V>(factor.values + part) * load_part<V>(ball_force, part);
    const V half =
        load_part<V>(s.half_step[i], part) + 2.0 * half_kick + load_part<V>(body_kick_before, part);
    const V predicted = half + half_kick + load_part<V>(body_kick_after, part);
    store_part<V>(s.half_step[i], part, half);
    if constexpr (w == 8) {
      ball.velocity[0] = __builtin_shufflevector(predicted, predicted, 0, 1, 2, 3);
      ball.spin[0] = __builtin_shufflevector(predicted, predicted, 4, 5, 6, 7);
      ball.position[0] = load_part<Part>(s.rows[i], 0) +
                         s.constants.dt * __builtin_shufflevector(half, half, 0, 1, 2, 3);
    } else {
      const std::size_t p = part % 4 / w;
      (part < 4 ? ball.velocity : ball.spin)[p] = predicted;
      if (part < 4) ball.position[p] = load_part<V>(s.rows[i], part) + s.constants.dt * half;
    }
  }
  return ball;
}

/// Integrates the balls of a chunk over a step.
template <class V, bool streaming>
[[gnu::always_inline]] inline void integrate_balls(const ChunkStep& s, const Chunk& chunk,
                                                   const VectorPair* ball_forces,
                                                   ChunkDisplacement& displacement) {
  using Ball = IntegratedBall<V>;
  using Part = typename Ball::Part;
  constexpr std::size_t count = Ball::count, w = width_of<Part>;
  const double dt = s.constants.dt;
  const Vec3 before = dt * s.drive.body_acceleration,
             after = 0.5 * dt * s.next_drive.body_acceleration;
  const VectorPair kick_before{before.x, before.y, before.z}, kick_after{after.x, after.y, after.z};
  alignas(64) const double predicted_mean[4] = {
      displacement.predicted_mean.x, displacement.predicted_mean.y, displacement.predicted_mean.z};
  Part sum[count]{}, max_deviation[count]{};
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Ball ball =
        integrate_ball<V>(s, i, ball_forces[i - chunk.first], kick_before, kick_after);
    if constexpr (width_of<V> == 8) {
      const V next[1] = {
          __builtin_shufflevector(ball.position[0], ball.velocity[0], 0, 1, 2, 3, 4, 5, 6, 7)};
      store_record<streaming>(s.next_rows[i], next);
    } else {
      Part next[2 * count];
      for (std::size_t p = 0; p < count; ++p)
        next[p] = ball.position[p], next[count + p] = ball.velocity[p];
      store_record<streaming>(s.next_rows[i], next);
    }
    store_record<streaming>(s.next_spins[i], ball.spin);
    for (std::size_t p = 0; p < count; ++p) {
      const Part way = ball.position[p] - reference_part<Part>(s.reference_positions[i], p * w);
      const Part deviation = way - load<Part>(predicted_mean + p * w);
      sum[p] += way;
      max_deviation[p] = max(max_deviation[p], deviation);
      max_deviation[p] = max(max_deviation[p], -deviation);
    }
  }
  if constexpr (streaming) store_fence();
  const auto number = [](const Part(&parts)[count], std::size_t k) { return parts[k / w][k % w]; };
  const double balls = std::max(1, chunk.last - chunk.first);
  displacement.spread = std::sqrt(number(max_deviation, 0) * number(max_deviation, 0) +
                                  number(max_deviation, 1) * number(max_deviation, 1) +
                                  number(max_deviation, 2) * number(max_deviation, 2));
  displacement.mean = {number(sum, 0) / balls, number(sum, 1) / balls, number(sum, 2) / balls};
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
template <class Law, class V>
[[gnu::always_inline]] inline void step_chunk(ChunkStep& s, Chunk& chunk, const Chunk* following,
                                              BallForces& ball_forces,
                                              ChunkDisplacement& displacement) {
  PrefetchQueue prefetches = prefetch_next_chunk(s, chunk, following);
  find_contacts<V>(s, chunk);
  s.callbacks->test_walls(chunk);
  std::fill_n(ball_forces.begin(), chunk.last - chunk.first, VectorPair{});
  // Not unrolled: otherwise this large body would be compiled three times.
#pragma GCC unroll 1
  for (const ContactKind kind : {ContactKind::own, ContactKind::halo, ContactKind::wall}) {
    ContactWork d;
    apply_packets<Law, V>(s, chunk, kind, ball_forces.data(), prefetches, d);
    const double part = kind == ContactKind::halo ? 0.5 : 1;
    ContactWork& all = chunk.sums.work;
    for (int first = 0; first < lanes; first += width_of<V>) {
      const LaneGroup<V> group{first};
      group.add(all.normal, part * group(d.normal));
      group.add(all.tangential, part * group(d.tangential));
      group.add(all.rolling, part * group(d.rolling));
      group.add(all.sliding, part * group(d.sliding));
      group.add(all.wall, group(d.wall));
      group.put(all.max_overlap, max(group(all.max_overlap), group(d.max_overlap)));
    }
  }
  chunk.sums.ball_steps += chunk.balls_in_contact;
  if (s.large)
    integrate_balls<V, true>(s, chunk, ball_forces.data(), displacement);
  else
    integrate_balls<V, false>(s, chunk, ball_forces.data(), displacement);
}

template <class Law>
struct ChunkLoop {
  template <int width>
  [[gnu::always_inline]] static void run(ChunkStep& s, Chunk& c, const Chunk* next, BallForces& l,
                                         ChunkDisplacement& d) {
    step_chunk<Law, Register<width>>(s, c, next, l, d);
  }
};
template <class Law>
ChunkStepper chunk_stepper() {
  return Multiversioned<ChunkLoop<Law>, ChunkStepper>::best();
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/soft/many/bodies.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"
#include "mahlwerk/soft/many/integration.hpp"
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

/// Follows the energy that the loading of each contact puts in, its largest value since the grains
/// were looked at: what is stored, and what has been dissipated since it began to be compressed
/// (bed.1).
template <class V>
[[gnu::always_inline]] inline void follow_loading(const ChunkStep& s, const LaneGroup<V>& group,
                                                  const ContactGeometry<V>& geometry,
                                                  const MaskOf<V>& touching,
                                                  const WorkOfStep<V>& work,
                                                  StressHistory& stress) {
  const V zero{};
  const MaskOf<V> loading = less(zero, geometry.overlap_rate) & touching;
  const V stored = s.stored_share * max(work.elastic * geometry.overlap, zero);
  V lost = select<V>(group.mask(stress.unloading), zero, group(stress.lost));
  lost = select<V>(loading, lost + max(work.normal, zero), group(stress.lost));
  group.put(stress.lost, lost);
  group.put(stress.energy, max(group(stress.energy), where<V>(touching, stored + lost)));
  const std::uint32_t own = ((1U << width_of<V>)-1) << group.first;
  stress.unloading = (stress.unloading & ~own) | (own & ~group.bits(loading));
}

/// Reduces the overlaps of contacts that rest at an overlap, which shrinks as the bodies part
/// (bed.6). Returns the lanes of such contacts; those of them that do not press touch without
/// force.
template <class V>
[[gnu::always_inline]] inline std::uint32_t rest_overlaps(const LaneGroup<V>& group,
                                                          StressHistory& stress,
                                                          ContactGeometry<V>& geometry,
                                                          MaskOf<V>& pressing) {
  const V zero{}, rest = group(stress.rest);
  const MaskOf<V> rests = less(zero, rest);
  if (!any(rests)) return 0;
  const V left = select<V>(rests, max(min(rest, geometry.overlap), zero), rest);
  group.put(stress.rest, left);
  geometry.overlap = geometry.overlap - left;
  pressing = pressing & (less(zero, geometry.overlap) | ~rests);
  return group.bits(rests);
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
  const bool friction = has_friction_history(s.constants);
  if (friction) get_friction_history<V>(group, list.friction_histories[n], history);
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
  if (friction) put_friction_history<V>(s.constants, group, history, list.friction_histories[n]);
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
  if (s.stresses) follow_loading<V>(s, group, geometry, touching, work, list.stresses[n]);
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
                                                        const PacketRows& from,
                                                        const LaneGroup<V>& group, ContactKind kind,
                                                        const Vec<Lanes>& points,
                                                        const PairParameters& parameters) {
  GroupState<V> state;
  const MaskOf<V> touched = group.mask(g.touching);
  state.motion = gather_pair_motion<V>(s, from, group, kind, points);
  const V squared = dot(state.motion.separation, state.motion.separation),
          near = touch_distance<V>(group, parameters, touched);
  state.touching = less<V>(squared, near * near) & touched;
  state.geometry = contact_geometry<V>(group, parameters, state.motion, squared);
  return state;
}

/// The facets kept for the lanes of a wall packet.
inline geometry::NearFacets* near_facets(Chunk& chunk, std::size_t packet) {
  if (chunk.near_facets.size() <= packet) chunk.near_facets.resize(packet + 1);
  return chunk.near_facets[packet].data();
}

/// Adds the forces of the wall contacts of a group, the lanes in `touching`, to the loads.
template <class V>
inline void add_wall_loads(const ChunkStep& s, Chunk& chunk, const ContactPacket& g,
                           const LaneGroup<V>& group, const Vec<Lanes>& points,
                           const ContactForce<V>& force, std::uint32_t touching) {
  for (int l = 0; l < width_of<V>; ++l) {
    const auto lane = static_cast<std::size_t>(group.first + l);
    if ((touching >> lane & 1) == 0) continue;
    const auto of = [&](const Vec<V>& a) { return Vec3{a.x[l], a.y[l], a.z[l]}; };
    s.callbacks->add_wall_load(
        s, chunk, {g.j[lane], get_lane(points, lane), of(force.force), of(force.torque_j)});
  }
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
  const PacketRows from = packet_rows(s, chunk, list, n, kind);
  if (kind == ContactKind::wall)
    s.jar->wall_points(from.rows, *from.i, g.j, g.touching, s.wall_axes, s.pull_off_distance,
                       points, s.jar->keeps_near_facets() ? near_facets(chunk, n) : nullptr);
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
    GroupState<V> state = group_state<V>(s, g, from, group, kind, points, parameters);
    const std::uint32_t still = group.bits(state.touching);
    touching |= still;
    std::uint32_t changing = own;  // lanes whose contacts begin and end as others do
    if (s.stresses)
      changing &= ~rest_overlaps<V>(group, list.stresses[n], state.geometry, state.touching);
    ContactForce<V> force = apply_group<Law, V>(
        s, list, n, group, state.motion, state.geometry, state.touching, begun & changing,
        g.touching & changing & ~still, tensile, parameters, kind, sums);
    if (s.rounded) add_arm_torques<V>(group, chunk.spheres, force);
    const ForceRows<V> on_i(force.force, force.torque_i);
    add_rows<V>(ball_forces, chunk.first, g.i.data() + f, on_i);
    if (kind == ContactKind::wall && s.loads)
      add_wall_loads<V>(s, chunk, g, group, points, force, g.touching & own);
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
  for (const ContactPackets* list : {&c.own, &c.halo})
    for (const auto& block : list->packets.blocks()) prefetches.add(block->data(), block->size());
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
  if (s.liquid) s.callbacks->add_liquid_forces(s, chunk, ball_forces);
  chunk.sums.ball_steps += chunk.balls_in_contact;
  if (s.body_of != nullptr && chunk.first < chunk.last && s.body_of[chunk.first] >= 0)
    return s.callbacks->step_bodies(s, chunk, ball_forces, displacement);
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

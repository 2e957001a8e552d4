// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/many/solver.hpp"

// Contacts that begin and end, and their records.
namespace mahlwerk::soft {
namespace {

bool is_wall(const NeighbourPair& pair) {
  return pair.other < 0;
}

}  // namespace

void ManyBodySolver::test_walls(Chunk& chunk) {
  VerletList& w = chunk.near_wall;
  const auto touches = [&](const NeighbourPair& pair) {
    const BallRecord& ball = now_[static_cast<std::size_t>(pair.ball)];
    return jar_->gap(~pair.other, ball.position(), clock(step_), ball.radius).distance <
           ball.radius;
  };
  const std::size_t due = w.due(chunk.wall_bound, skin_ * VerletList::width);
  for (std::size_t k = due; k-- > 0;) {
    if (!touches(w.pairs[k])) continue;
    activate(chunk, w.pairs[k]);
    w.remove(k);
  }
  for (std::size_t k = w.separated.size(); k-- > 0;) {
    if (!touches(w.separated[k])) continue;
    activate(chunk, w.separated[k]);
    w.separated[k] = w.separated.back();
    w.separated.pop_back();
  }
  chunk.sums.tests += static_cast<std::int64_t>(due);
}

void ManyBodySolver::activate(Chunk& chunk, const NeighbourPair& pair) {
  const std::int32_t mine = species_[static_cast<std::size_t>(pair.ball)];
  const bool own = !is_wall(pair) && pair.other >= chunk.first && pair.other < chunk.last;
  ContactPackets& list = is_wall(pair) ? chunk.wall : own ? chunk.own : chunk.halo;
  const std::int32_t species_pair =
      is_wall(pair) ? pairs_.wall(mine, ~pair.other)
                    : pairs_.balls(mine, species_[static_cast<std::size_t>(pair.other)]);
  const std::int32_t at = free_lane(list, species_pair, pair.ball);
  ContactPacket& g = list.packets[static_cast<std::size_t>(at / lanes)];
  const auto l = static_cast<std::size_t>(at % lanes);
  g.i[l] = pair.ball;
  g.j[l] = is_wall(pair) ? ~pair.other : pair.other;
  g.touching |= bit(at % lanes);
  g.fresh |= bit(static_cast<int>(l));
}

/// A lane for a contact of `ball` and of that species pair, its history cleared.
std::int32_t ManyBodySolver::free_lane(ContactPackets& list, std::int32_t species_pair,
                                       std::int32_t ball) {
  if (list.free.empty()) {
    const auto g = static_cast<std::int32_t>(list.packets.size());
    const bool wall = parameters_[static_cast<std::size_t>(species_pair)].wall[0] != 0;
    // An eighth more, not twice as many: it is most of the memory.
    if (const std::size_t n = list.packets.size(); n == list.packets.capacity())
      list.make_room(n + n / 8 + 4, remembers_, rules_.model.curved_walls && wall);
    list.packets.emplace_back();
    ContactPacket& fresh = list.packets.back();
    fresh.species_pair.fill(species_pair);
    fresh.i.fill(ball);
    fresh.j.fill(wall ? 0 : ball);
    list.began.emplace_back();
    if (remembers_) list.memories.emplace_back();
    if (wall) list.facings.emplace_back();
    if (rules_.model.curved_walls && wall)
      list.parameters.push_back(parameters_[static_cast<std::size_t>(species_pair)]);
    for (int l = lanes - 1; l >= 0; --l) list.free.push_back(g * lanes + l);
  }
  const std::int32_t at = list.free.back();
  list.free.pop_back();
  const auto n = static_cast<std::size_t>(at / lanes);
  const int l = at % lanes;
  ContactPacket& g = list.packets[n];
  g.species_pair[static_cast<std::size_t>(l)] = species_pair;
  g.alike = true;
  for (int k = 0; k < lanes; ++k)
    g.alike =
        g.alike && (!g.touches(k) || g.species_pair[static_cast<std::size_t>(k)] == species_pair);
  if (g.alike) g.species_pair.fill(species_pair);
  g.pulling &= ~bit(l);
  put(g.spring, l, {});
  g.impulse[l] = g.lost_normal[l] = g.lost_across[l] = 0;
  if (remembers_) {
    Memory& m = list.memories[n];
    for (Lanes& memory : m.memory) memory[l] = 0;
    put(m.roll, l, {});
    m.stiffness[l] = 0;
  }
  return at;
}

void ManyBodySolver::touches(Chunk& chunk, std::int32_t ball, int more) {
  std::int32_t& count = contacts_of_[static_cast<std::size_t>(ball)];
  const bool was = count > 0;
  count += more;
  if ((count > 0) != was) chunk.in_touch += count > 0 ? 1 : -1;
}

void ManyBodySolver::begin(Chunk& chunk, ContactPackets& list, std::size_t n,
                           const ContactGeometry& m, const Bodies& b) {
  ContactPacket& g = list.packets[n];
  for (int l = 0; l < lanes; ++l) {
    if ((g.fresh & bit(l)) == 0) continue;
    const auto k = static_cast<std::size_t>(l);
    touches(chunk, g.i[k], 1);
    if (&list == &chunk.own) touches(chunk, g.j[k], 1);
    PairParameters* own = list.parameters.empty() ? nullptr : &list.parameters[n];
    const PairParameters& usual = parameters_[static_cast<std::size_t>(g.species_pair[k])];
    if (own != nullptr) {
      copy_lane(usual, l, *own, l);
      bend(*own, l, *jar_, g.j[k], now_[static_cast<std::size_t>(g.i[k])].position(), clock(step_),
           pairs_[g.species_pair[k]], *rules_.model.law);
    }
    Beginning& began = list.began[n][k];
    began = beginning(step_, m, b, l);
    if (remembers_)
      begin_memory(list.memories[n].memory, own != nullptr ? *own : usual, l, began.approach,
                   *rules_.model.law);
  }
  g.fresh = 0;
}

void ManyBodySolver::end(Chunk& chunk, ContactPackets& list, std::size_t n,
                         const LaneMask& touching) {
  ContactPacket& g = list.packets[n];
  const bool wall = &list == &chunk.wall;
  for (int l = 0; l < lanes; ++l) {
    if (!g.touches(l) || touching[l] != 0) continue;
    const auto k = static_cast<std::size_t>(l);
    touches(chunk, g.i[k], -1);
    if (&list == &chunk.own) touches(chunk, g.j[k], -1);
    if (&list != &chunk.halo || g.i[k] < g.j[k]) record(chunk, list, n, l);
    (wall ? chunk.near_wall : chunk.near).separated.push_back({g.i[k], wall ? ~g.j[k] : g.j[k]});
    g.touching &= ~bit(l);
    put(g.spring, l, {});
    list.free.push_back(static_cast<std::int32_t>(n) * lanes + l);
  }
}

void ManyBodySolver::record(Chunk& chunk, const ContactPackets& list, std::size_t n, int l) {
  const ContactPacket& g = list.packets[n];
  const bool wall = &list == &chunk.wall;
  const auto k = static_cast<std::size_t>(l);
  const BallRecord& ball = now_[static_cast<std::size_t>(g.i[k])];
  const Beginning& began = list.began[n][k];
  const SpeciesPair& pair = pairs_[g.species_pair[k]];
  const double t = clock(step_), duration = time_of(step_ - began.step);
  const int face = wall ? g.j[k] : -1;
  const Vec3 apart =
      wall ? one(list.facings[n].normal, l)
           : nearest(now_[static_cast<std::size_t>(g.j[k])].position() - ball.position());
  const Vec3 normal = (1 / norm(apart)) * apart;
  chunk.ended.push_back({step_,
                         {.time = time_of(began.step),
                          .duration = duration,
                          .ball = id_[static_cast<std::size_t>(g.i[k])],
                          .other = wall ? ~g.j[k] : id_[static_cast<std::size_t>(g.j[k])],
                          .where = jar_->own(ball.position() + ball.radius * normal, t, face),
                          .normal = jar_->own(normal, t, face),
                          .mass = pair.touching.mass,
                          .approach = began.approach,
                          .slip = began.slip,
                          .glide = began.glide,
                          .impulse = g.impulse[l],
                          .lost_normal = g.lost_normal[l],
                          .lost_tangential = g.lost_across[l]}});
  ++chunk.sums.collisions;
  if (outlasts(duration, began, pair, *rules_.model.law)) ++chunk.sums.lasting;
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>
#include <utility>

#include "mahlwerk/soft/many/solver.hpp"

// Lane allocation after a rebuild: contacts move with their balls to new rows and chunks.
namespace mahlwerk::soft {
namespace {

constexpr std::int32_t contact_kinds = 3;
constexpr std::size_t contact_block = BlockList<ContactPacket>::block_size;  // packets

// List numbers: the lists of all chunks in turn, those of a chunk in the order of ContactKind.
ContactKind kind_of(std::int32_t list) {
  return static_cast<ContactKind>(list % contact_kinds);
}
ContactPackets& list_of(std::vector<Chunk>& chunks, std::int32_t list) {
  Chunk& chunk = chunks[static_cast<std::size_t>(list / contact_kinds)];
  const ContactKind kind = kind_of(list);
  return kind == ContactKind::own ? chunk.own : kind == ContactKind::halo ? chunk.halo : chunk.wall;
}

/// The block of a contact in its list.
std::size_t block_of(const auto& contact) {
  return static_cast<std::size_t>(contact.lane / lanes) / contact_block;
}
std::int32_t& copies_left_of(std::vector<Chunk>& chunks, const auto& contact) {
  return list_of(chunks, contact.list).copies_left[block_of(contact)];
}

}  // namespace

/// Lists every contact once, sorted by the new rows of its balls; `to` maps old rows to new rows.
ManyBodySolver::ContactsByBall ManyBodySolver::collect_contacts(
    const std::vector<std::int32_t>& to) {
  ContactsByBall all;
  const auto each = [&](const auto& f) {
    for (std::int32_t number = 0; number < contact_kinds * std::ssize(chunks_); ++number) {
      const ContactPackets& list = list_of(chunks_, number);
      for (std::int32_t at = 0; at < lanes * static_cast<std::int32_t>(list.packets.size()); ++at) {
        const ContactPacket& g = list.packets[static_cast<std::size_t>(at / lanes)];
        const auto l = static_cast<std::size_t>(at % lanes);
        if (!g.touches(l)) continue;
        if (kind_of(number) == ContactKind::halo && g.i[l] > g.j[l])
          continue;  // the other chunk's copy is listed
        const std::int32_t j =
            kind_of(number) == ContactKind::wall ? g.j[l] : to[static_cast<std::size_t>(g.j[l])];
        f(ContactAddress{to[static_cast<std::size_t>(g.i[l])], j, number, at});
      }
    }
  };
  all.first.assign(to.size() + 2, 0);
  each([&](const ContactAddress& k) { ++all.first[static_cast<std::size_t>(k.i) + 2]; });
  std::partial_sum(all.first.begin(), all.first.end(), all.first.begin());
  all.contacts.resize(static_cast<std::size_t>(all.first.back()));
  each([&](const ContactAddress& k) {
    auto& next = all.first[static_cast<std::size_t>(k.i) + 1];  // ends as the end of i
    all.contacts[static_cast<std::size_t>(next++)] = k;
  });
  const auto order = [](const ContactAddress& k) {
    return std::tuple(kind_of(k.list) == ContactKind::wall, k.j);
  };
  for (std::size_t i = 0; i < to.size(); ++i)
    std::sort(
        all.contacts.begin() + all.first[i], all.contacts.begin() + all.first[i + 1],
        [&](const ContactAddress& a, const ContactAddress& b) { return order(a) < order(b); });
  return all;
}

/// Copies the contacts from the old chunks to the new ones, in parallel by new chunk.
void ManyBodySolver::distribute_contacts(const ContactsByBall& all, std::vector<Chunk>& old) {
  for (std::int32_t number = 0; number < contact_kinds * std::ssize(old); ++number) {
    ContactPackets& list = list_of(old, number);
    list.copies_left.assign(list.packets.blocks().size(), 0);
  }
  // Halo contacts that are listed under a ball of another chunk.
  std::vector<std::vector<std::int32_t>> incoming(chunks_.size());
  for (std::size_t n = 0; n < all.contacts.size(); ++n) {
    const ContactAddress& k = all.contacts[n];
    std::int32_t& copies_left = copies_left_of(old, k);
    ++copies_left;
    if (kind_of(k.list) == ContactKind::wall) continue;
    const std::int32_t other = chunk_of(k.j);
    if (other == chunk_of(k.i)) continue;
    ++copies_left;
    incoming[static_cast<std::size_t>(other)].push_back(static_cast<std::int32_t>(n));
  }
  for (std::int32_t number = 0; number < contact_kinds * std::ssize(old); ++number) {
    ContactPackets& list = list_of(old, number);
    for (std::size_t block = 0; block < list.copies_left.size(); ++block)
      if (list.copies_left[block] == 0) list.free_block(block);
  }
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    const std::vector<std::int32_t>& arrivals = incoming[static_cast<std::size_t>(c)];
    const std::int32_t begin = all.first[static_cast<std::size_t>(chunk.first)];
    const std::int32_t end = all.first[static_cast<std::size_t>(chunk.last)];
    const auto give = [&](std::int32_t n) {
      const ContactAddress& k = all.contacts[static_cast<std::size_t>(n)];
      ContactPackets& from = list_of(old, k.list);
      place_contact(chunk, k, from);
      if (std::atomic_ref(copies_left_of(old, k)).fetch_sub(1) == 1) from.free_block(block_of(k));
    };
    auto at = arrivals.begin();
    for (; at != arrivals.end() && *at < begin; ++at) give(*at);
    for (std::int32_t n = begin; n < end; ++n) give(n);
    for (; at != arrivals.end(); ++at) give(*at);
  });
}

/// Copies a contact to the chunk. Ball i of the copy is the first ball of the contact, or the
/// second one if the first belongs to another chunk.
void ManyBodySolver::place_contact(Chunk& chunk, const ContactAddress& k,
                                   const ContactPackets& from) {
  const std::int32_t species = species_[static_cast<std::size_t>(k.i)];
  if (kind_of(k.list) == ContactKind::wall)
    return copy_contact(chunk.wall, k, from, k.i, k.j, pairs_.wall_pair_index(species, k.j), 1);
  const std::int32_t other = species_[static_cast<std::size_t>(k.j)];
  const auto has = [&](std::int32_t ball) { return ball >= chunk.first && ball < chunk.last; };
  if (!has(k.i))
    return copy_contact(chunk.halo, k, from, k.j, k.i, pairs_.ball_pair_index(other, species), -1);
  ContactPackets& list = has(k.j) ? chunk.own : chunk.halo;
  copy_contact(list, k, from, k.i, k.j, pairs_.ball_pair_index(species, other), 1);
}

/// Copies the contact with its history to a free lane, with ball `i` as the first; `sign` is -1
/// where the balls change places.
void ManyBodySolver::copy_contact(ContactPackets& list, const ContactAddress& k,
                                  const ContactPackets& from, std::int32_t i, std::int32_t j,
                                  std::int32_t species_pair, double sign) {
  const std::int32_t at = free_lane(list, species_pair, i);
  const auto n = static_cast<std::size_t>(at / lanes), l = static_cast<std::size_t>(at % lanes),
             old = static_cast<std::size_t>(k.lane / lanes),
             m = static_cast<std::size_t>(k.lane % lanes);
  ContactPacket& g = list.packets[n];
  const ContactPacket& was = from.packets[old];
  g.touching |= bit(l);
  if ((was.tensile & bit(m)) != 0) g.tensile |= bit(l);
  g.i[l] = i, g.j[l] = j;
  list.onsets[n][l] = from.onsets[old][m];
  set_lane(g.spring, l, sign * get_lane(was.spring, m));
  g.impulse[l] = was.impulse[m];
  g.lost_normal[l] = was.lost_normal[m], g.lost_tangential[l] = was.lost_tangential[m];
  if (has_history_) {
    OptionalHistory& extra = list.optional_histories[n];
    const OptionalHistory& past = from.optional_histories[old];
    for (int a = 0; a < contact::law_history_size; ++a)
      extra.law_history[a][l] = past.law_history[a][m];
    set_lane(extra.rolling_spring_torque, l, sign * get_lane(past.rolling_spring_torque, m));
    extra.stiffness[l] = past.stiffness[m];
  }
  if (has_friction_history_) {
    FrictionHistory& extra = list.friction_histories[n];
    const FrictionHistory& past = from.friction_histories[old];
    set_lane(extra.turning_force, l, sign * get_lane(past.turning_force, m));
    extra.load[l] = past.load[m], extra.twist[l] = past.twist[m];
  }
  if (!list.wall_normals.empty())
    set_lane(list.wall_normals[n].normal, l, get_lane(from.wall_normals[old].normal, m));
  if (!list.hulls.empty())
    list.hulls[n][l] = sign < 0 ? from.hulls[old][m].swapped() : from.hulls[old][m];
  if (settings_.breakage) {
    StressHistory& extra = list.stresses[n];
    const StressHistory& past = from.stresses[old];
    extra.rest[l] = past.rest[m], extra.lost[l] = past.lost[m], extra.energy[l] = past.energy[m];
    if ((past.unloading & bit(m)) != 0) extra.unloading |= bit(l);
  }
  if (!list.parameters.empty()) {
    PairParameters& own = list.parameters[n];
    copy_lane(from.parameters[old], m, own, l);
    if (sign < 0) std::swap(own.radius_i[l], own.radius_j[l]);
  }
}

}  // namespace mahlwerk::soft

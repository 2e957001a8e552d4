// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <utility>

#include "mahlwerk/soft/few/packet_lanes.hpp"
#include "mahlwerk/soft/few/replicate_batch.hpp"

// Lanes of the shared packets: pairs of replicates get them and give them back.
namespace mahlwerk::soft {
namespace {

/// Index of a member of a sorted list.
template <class T>
std::size_t index_in(const std::vector<T>& sorted, const T& member) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sorted, member) - sorted.begin());
}

}  // namespace

/// Gives all pairs of active replicates a lane of empty packets, those that touch the first.
void ReplicateBatch::load_all() {
  std::size_t pairs = 0;
  for (const Replicate* r : active_) pairs += r->solver->listed_pairs_.size();
  packets_.clear(), gather_maps_.clear(), owners_.clear(), free_lanes_.clear();
  add_packets((pairs + lanes - 1) / lanes);
  for (Replicate* r : active_) load(*r);
}

void ReplicateBatch::add_packets(std::size_t count) {
  const std::size_t first = packets_.size(), end = first + count;
  packets_.resize(end), gather_maps_.resize(end), owners_.resize(end), free_lanes_.resize(end);
  for (std::size_t n = first; n < end; ++n)
    for (std::size_t l = 0; l < lanes; ++l) clear({n, l});
}

void ReplicateBatch::clear(const Place& place) {
  clear_lane(packets_[place.packet], place.lane);
  owners_[place.packet][place.lane] = {};
  free_lanes_[place.packet] |= 1U << place.lane;
  GatherMap& map = gather_maps_[place.packet];
  map.body_i[place.lane] = map.body_j[place.lane] = &no_body_.position.x[0];
  map.row_i[place.lane] = map.row_j[place.lane] = &no_row_;
}

/// The first or the last free lane; if there is none, the first of a new packet.
ReplicateBatch::Place ReplicateBatch::free_place(bool first) {
  const std::size_t count = packets_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t n = first ? k : count - 1 - k;
    const std::uint32_t free = free_lanes_[n];
    if (free == 0) continue;
    return {n, static_cast<std::size_t>(first ? std::countr_zero(free)
                                              : static_cast<int>(std::bit_width(free)) - 1)};
  }
  add_packets(1);
  return {count, 0};
}

/// Calls `f` with the place of each pair among the replicate's own packets.
template <class F>
void ReplicateBatch::each_own(const Replicate& r, const F& f) {
  const std::vector<PairPacket>& packets = r.solver->particles_.packets;
  for (std::size_t n = 0; n < packets.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l)
      if (packets[n].used[l]) f(Place{n, l});
}

/// Gives all pairs of a replicate lanes.
void ReplicateBatch::load(Replicate& r) {
  r.pairs.clear();
  reload(r);
}

/// Gives pairs lanes that have none; updates the lanes of the others, which may have moved among
/// the replicate's own packets.
void ReplicateBatch::reload(Replicate& r) {
  const std::vector<Pair> before = std::exchange(r.pairs, r.solver->listed_pairs_);
  const std::vector<Place> places = std::exchange(r.places, std::vector<Place>(r.pairs.size()));
  const std::vector<PairPacket>& packets = r.solver->particles_.packets;
  each_own(r, [&](const Place& own) {
    const PairPacket& p = packets[own.packet];
    const Pair pair = FewBodySolver::pair_of(p, own.lane);
    const auto old = std::ranges::lower_bound(before, pair);
    Place& place = r.places[index_in(r.pairs, pair)];
    if (old != before.end() && *old == pair) {
      place = places[static_cast<std::size_t>(old - before.begin())];
    } else {
      place = free_place(p.touching[own.lane] != 0);
      copy_lane(p, own.lane, packets_[place.packet], place.lane);
    }
    connect(r, own, place);
  });
}

/// Connects a lane of a shared packet with the bodies and force rows of its replicate.
void ReplicateBatch::connect(Replicate& r, const Place& own, const Place& place) {
  const ParticleData& w = r.solver->particles_;
  owners_[place.packet][place.lane] = {&r, own};
  free_lanes_[place.packet] &= ~(1U << place.lane);
  packets_[place.packet].j[place.lane] = w.packets[own.packet].j[own.lane];
  const GatherMap& from = w.gather_maps[own.packet];
  GatherMap& to = gather_maps_[place.packet];
  to.body_i[place.lane] = from.body_i[own.lane], to.body_j[place.lane] = from.body_j[own.lane];
  to.row_i[place.lane] = from.row_i[own.lane], to.row_j[place.lane] = from.row_j[own.lane];
  to.filled |= (from.filled >> own.lane & 1) << place.lane;
}

/// Gives a pair back to the packets of its replicate.
void ReplicateBatch::store_lane(const Place& place) {
  const Owner& owner = owners_[place.packet][place.lane];
  ParticleData& w = owner.replicate->solver->particles_;
  copy_lane(packets_[place.packet], place.lane, w.packets[owner.own.packet], owner.own.lane);
  w.gather_maps[owner.own.packet].filled |= 1U << owner.own.lane;
  clear(place);
}

void ReplicateBatch::store(Replicate& r) {
  for (const Place& place : r.places) store_lane(place);
  r.pairs.clear(), r.places.clear();
}

/// Gives back the pairs that were not found.
void ReplicateBatch::store_missing(const Replicate& r) {
  for (std::size_t k = 0; k < r.pairs.size(); ++k)
    if (!std::ranges::binary_search(r.solver->found_pairs_, r.pairs[k])) store_lane(r.places[k]);
}

/// Tells the replicate's own packets which pairs touch.
void ReplicateBatch::store_touching(const Replicate& r) {
  for (const Place& place : r.places) {
    const Place& own = owners_[place.packet][place.lane].own;
    r.solver->particles_.packets[own.packet].touching[own.lane] =
        packets_[place.packet].touching[place.lane];
  }
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "mahlwerk/soft/crowd.hpp"

// The balls of a crowd are put in order along a curve through space and cut into chunks, and
// contacts move with them.
namespace mahlwerk::soft {
namespace {

constexpr std::int32_t chunk_size = 1024;

template <class Rows>
void permute(Rows& all, const std::vector<std::int32_t>& from) {
  Rows sorted(all.size());
  for (std::size_t k = 0; k < from.size(); ++k) sorted[k] = all[static_cast<std::size_t>(from[k])];
  all.swap(sorted);
}

Vec3 one(const Vec<Lanes>& a, int lane) {
  return {a.x[lane], a.y[lane], a.z[lane]};
}
void put(Vec<Lanes>& a, int lane, const Vec3& b) {
  a.x[lane] = b.x, a.y[lane] = b.y, a.z[lane] = b.z;
}

}  // namespace

/// The old row of each new one: by class of sizes, then along the curve.
std::vector<std::int32_t> Crowd::sort_balls() {
  struct Place {
    int size;
    std::uint64_t key;
    std::int32_t row;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<std::vector<Vec3>> places(class_radius_.size());
  std::vector<Place> order(now_.size());
  for (std::size_t k = 0; k < now_.size(); ++k) {
    const Vec3 x = now_[k].place();
    if (!std::isfinite(squared(x))) stop(k, "its place or speed is no number");
    order[k] = {class_of_[static_cast<std::size_t>(species_[k])], 0, static_cast<std::int32_t>(k)};
    places[static_cast<std::size_t>(order[k].size)].push_back(x);
  }
  grids_.clear();
  class_first_.assign(1, 0);
  for (std::size_t c = 0; c < places.size(); ++c) {
    grids_.emplace_back(places[c], class_radius_[c], skin_ + reach_, jar_->periods());
    class_first_.push_back(class_first_.back() + static_cast<std::int32_t>(places[c].size()));
  }
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k].key = grids_[static_cast<std::size_t>(order[k].size)].key(now_[k].place());
  std::ranges::sort(order);
  std::vector<std::int32_t> from;
  from.reserve(order.size());
  for (const Place& p : order) from.push_back(p.row);
  return from;
}

void Crowd::reorder(const std::vector<std::int32_t>& from) {
  permute(now_, from);
  permute(turns_, from);
  permute(half_, from);
  permute(id_, from);
  permute(species_, from);
  permute(contacts_of_, from);
  std::vector<Vec3> places;
  for (std::size_t c = 0; c + 1 < class_first_.size(); ++c) {
    places.clear();
    for (std::int32_t row = class_first_[c]; row < class_first_[c + 1]; ++row)
      places.push_back(now_[static_cast<std::size_t>(row)].place());
    grids_[c].fill(places, class_first_[c]);
  }
}

/// Every contact once, in the order of the rows that its balls will have.
std::vector<Crowd::Kept> Crowd::take_contacts(const std::vector<std::int32_t>& to) {
  std::vector<Kept> all;
  const auto take = [&](Grips& list, bool wall, bool shared) {
    for (std::size_t n = 0; n < list.grips.size(); ++n) {
      const Grip& g = list.grips[n];
      for (std::int32_t l = 0; l < lanes; ++l) {
        const auto k = static_cast<std::size_t>(l);
        if (!g.touches(l) || (shared && g.i[k] > g.j[k])) continue;
        all.push_back({.i = to[static_cast<std::size_t>(g.i[k])],
                       .j = wall ? g.j[k] : to[static_cast<std::size_t>(g.j[k])],
                       .wall = wall,
                       .list = &list,
                       .grip = static_cast<std::int32_t>(n),
                       .lane = l});
        ++list.leaving;
      }
    }
  };
  for (Chunk& chunk : chunks_) {
    chunk.near = chunk.near_wall = {};
    take(chunk.own, false, false);
    take(chunk.cross, false, true);
    take(chunk.wall, true, false);
  }
  std::ranges::sort(all, {}, [](const Kept& c) { return std::tuple(c.i, c.wall, c.j); });
  return all;
}

/// Chunks of about equal size; returns those there were.
std::vector<Chunk> Crowd::divide() {
  std::vector<Chunk> old = std::move(chunks_);
  chunks_.clear();
  for (std::size_t c = 0; c + 1 < class_first_.size(); ++c) {
    const std::int32_t first = class_first_[c], count = class_first_[c + 1] - first;
    const std::int32_t parts = (count + chunk_size - 1) / chunk_size;
    for (std::int32_t p = 0; p < parts; ++p) {
      Chunk& chunk = chunks_.emplace_back();
      chunk.first = first + static_cast<std::int32_t>(std::int64_t{count} * p / parts);
      chunk.last = first + static_cast<std::int32_t>(std::int64_t{count} * (p + 1) / parts);
      for (std::int32_t row = chunk.first; row < chunk.last; ++row)
        if (contacts_of_[static_cast<std::size_t>(row)] > 0) ++chunk.in_touch;
    }
  }
  return old;
}

std::int32_t Crowd::chunk_of(std::int32_t ball) const {
  const auto after = std::ranges::upper_bound(chunks_, ball, {}, &Chunk::first);
  return static_cast<std::int32_t>(after - chunks_.begin()) - 1;
}

void Crowd::give_contact(const Kept& c) {
  Chunk& mine = chunks_[static_cast<std::size_t>(chunk_of(c.i))];
  const std::int32_t species = species_[static_cast<std::size_t>(c.i)];
  if (c.wall) return give(mine.wall, c, c.i, c.j, breeds_.wall(species, c.j), 1);
  const std::int32_t other = species_[static_cast<std::size_t>(c.j)];
  const bool own = c.j >= mine.first && c.j < mine.last;
  give(own ? mine.own : mine.cross, c, c.i, c.j, breeds_.balls(species, other), 1);
  if (own) return;
  Chunk& its = chunks_[static_cast<std::size_t>(chunk_of(c.j))];
  give(its.cross, c, c.j, c.i, breeds_.balls(other, species), -1);
}

/// A lane for the contact as ball `i` sees it, with all that it remembers.
void Crowd::give(Grips& list, const Kept& c, std::int32_t i, std::int32_t j, std::int32_t breed,
                 double sign) {
  const std::int32_t at = free_lane(list, breed, i);
  const auto n = static_cast<std::size_t>(at / lanes), old = static_cast<std::size_t>(c.grip);
  const int l = at % lanes, m = c.lane;
  Grip& g = list.grips[n];
  const Grip& from = c.list->grips[old];
  g.touching |= bit(l);
  g.i[static_cast<std::size_t>(l)] = i, g.j[static_cast<std::size_t>(l)] = j;
  list.began[n][static_cast<std::size_t>(l)] = c.list->began[old][static_cast<std::size_t>(m)];
  put(g.spring, l, sign * one(from.spring, m));
  g.impulse[l] = from.impulse[m];
  g.lost_normal[l] = from.lost_normal[m], g.lost_across[l] = from.lost_across[m];
  if (remembers_) {
    Memory& memory = list.memories[n];
    const Memory& past = c.list->memories[old];
    for (int k = 0; k < contact::law_memories; ++k) memory.memory[k][l] = past.memory[k][m];
    put(memory.roll, l, sign * one(past.roll, m));
    memory.stiffness[l] = past.stiffness[m];
  }
  if (!list.makes.empty()) copy_lane(c.list->makes[old], m, list.makes[n], l);
}

/// Which chunks each thread does: about the same of balls and contacts.
void Crowd::share_work() {
  const auto weight = [](const Chunk& c) {
    return c.last - c.first +
           2 * lanes *
               static_cast<std::int64_t>(c.own.grips.size() + c.cross.grips.size() +
                                         c.wall.grips.size());
  };
  std::int64_t all = 0, done = 0;
  for (const Chunk& c : chunks_) all += weight(c);
  share_.assign(1, 0);
  std::int32_t c = 0;
  for (int t = 1; t < crew_.size(); ++t) {
    for (; static_cast<std::size_t>(c) < chunks_.size() && done * crew_.size() < all * t; ++c)
      done += weight(chunks_[static_cast<std::size_t>(c)]);
    share_.push_back(c);
  }
  share_.push_back(static_cast<std::int32_t>(chunks_.size()));
  for (Loads& loads : loads_) loads.resize(chunk_size);
}

}  // namespace mahlwerk::soft

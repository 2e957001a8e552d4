// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/soft/crowd.hpp"

// The balls of a crowd are put in order along a curve through space and cut into chunks, and
// contacts move with them.
namespace mahlwerk::soft {
namespace {

constexpr std::int32_t chunk_size = 1024;

template <class T>
void permute(std::vector<T>& all, const std::vector<std::int32_t>& from) {
  std::vector<T> sorted(all.size());
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

/// Every contact once, with the rows that its balls will have.
std::vector<Crowd::Kept> Crowd::take_contacts(const std::vector<std::int32_t>& to) const {
  std::vector<Kept> all;
  const auto take = [&](const Grips& list, bool wall, bool shared) {
    for (std::size_t n = 0; n < list.grips.size(); ++n) {
      const Grip& g = list.grips[n];
      for (int l = 0; l < lanes; ++l) {
        const auto k = static_cast<std::size_t>(l);
        if (g.touching[l] == 0 || (shared && g.i[k] > g.j[k])) continue;
        Kept c{.i = to[static_cast<std::size_t>(g.i[k])],
               .j = wall ? g.j[k] : to[static_cast<std::size_t>(g.j[k])],
               .breed = g.breed[k],
               .wall = wall,
               .began = list.began[n][k],
               .spring = one(g.spring, l),
               .normal = one(g.normal, l),
               .roll = {},
               .stiffness = remembers_ ? list.memories[n].stiffness[l] : 0,
               .impulse = g.impulse[l],
               .lost_normal = g.lost_normal[l],
               .lost_across = g.lost_across[l],
               .memory = {},
               .make = list.makes.empty() ? nullptr : &list.makes[n],
               .lane = l};
        if (remembers_) {
          for (std::size_t m = 0; m < c.memory.size(); ++m)
            c.memory[m] = list.memories[n].memory[m][l];
          c.roll = one(list.memories[n].roll, l);
        }
        all.push_back(c);
      }
    }
  };
  for (const Chunk& chunk : chunks_) {
    take(chunk.own, false, false);
    take(chunk.cross, false, true);
    take(chunk.wall, true, false);
  }
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
  const auto give = [&](Grips& list, std::int32_t i, std::int32_t j, std::int32_t breed,
                        double sign) {
    const std::int32_t at = free_lane(list, breed, i);
    const auto n = static_cast<std::size_t>(at / lanes);
    const int l = at % lanes;
    const auto k = static_cast<std::size_t>(l);
    Grip& g = list.grips[n];
    g.touching[l] = -1;
    g.i[k] = i, g.j[k] = j;
    list.began[n][k] = c.began;
    put(g.spring, l, sign * c.spring);
    put(g.normal, l, sign * c.normal);
    g.impulse[l] = c.impulse, g.lost_normal[l] = c.lost_normal, g.lost_across[l] = c.lost_across;
    if (remembers_) {
      for (std::size_t m = 0; m < c.memory.size(); ++m) list.memories[n].memory[m][l] = c.memory[m];
      put(list.memories[n].roll, l, sign * c.roll);
      list.memories[n].stiffness[l] = c.stiffness;
    }
    if (c.make != nullptr) copy_lane(*c.make, c.lane, list.makes[n], l);
  };
  Chunk& mine = chunks_[static_cast<std::size_t>(chunk_of(c.i))];
  if (c.wall) return give(mine.wall, c.i, c.j, c.breed, 1);
  if (c.j >= mine.first && c.j < mine.last) return give(mine.own, c.i, c.j, c.breed, 1);
  give(mine.cross, c.i, c.j, c.breed, 1);
  const std::int32_t turned = breeds_.balls(species_[static_cast<std::size_t>(c.j)],
                                            species_[static_cast<std::size_t>(c.i)]);
  give(chunks_[static_cast<std::size_t>(chunk_of(c.j))].cross, c.j, c.i, turned, -1);
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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/soft/crowd.hpp"
#include "mahlwerk/soft/went_wrong.hpp"

// Who is near whom in a crowd: balls are put in order along a curve through space and cut into
// chunks, contacts move with them, and each chunk looks for pairs that may touch before any ball
// has moved far.
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

/// Sorts pairs into bins of `width` by their gaps.
void into_bins(Waiting& w, const std::vector<Nigh>& found, const std::vector<double>& gaps,
               double width) {
  std::array<std::int32_t, Waiting::bins + 1> count{};
  const auto bin = [&](double gap) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>(gap / width), 0, Waiting::bins - 1));
  };
  for (const double gap : gaps) ++count[bin(gap) + 1];
  for (std::size_t b = 1; b < count.size(); ++b) count[b] += count[b - 1];
  w.end = count;
  w.pairs.resize(found.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    w.pairs[static_cast<std::size_t>(count[bin(gaps[k])]++)] = found[k];
  w.parted.clear();
}

}  // namespace

struct Crowd::Kept {
  std::int32_t i = 0, j = 0, breed = 0;  // rows; of a wall j is the face
  bool wall = false;
  Beginning began;
  Vec3 spring, normal, roll;
  double stiffness = 0, impulse = 0, lost_normal = 0, lost_across = 0;
  std::array<double, contact::law_memories> memory{};
  const Make* make = nullptr;  // and the lane, where curved walls change it
  int lane = 0;
};

void Crowd::rebuild() {
  settle();
  gather();
  tune_skin();
  const std::vector<std::int32_t> from = sort_balls();
  std::vector<std::int32_t> to(from.size());
  for (std::size_t k = 0; k < from.size(); ++k)
    to[static_cast<std::size_t>(from[k])] = static_cast<std::int32_t>(k);
  const std::vector<Kept> kept = take_contacts(to);
  reorder(from);
  const std::vector<Chunk> old = divide();  // kept contacts point into it
  for (const Kept& k : kept) give_contact(k);
  share_work();
  std::vector<Wrong> wrong(chunks_.size());
  crew_.all([&](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    for (std::int32_t c = share_[t]; c < share_[t + 1]; ++c) {
      Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
      find_near(chunk);
      wrong[static_cast<std::size_t>(c)] = near_walls(chunk);
    }
  });
  grids_.clear();
  spent_ = 0;
  mark_places();
  for (const Wrong& w : wrong)
    if (w.why != nullptr) stop(w.row, w.why);
}

/// From here on motion is reckoned.
void Crowd::mark_places() {
  widest_ = 0;
  for (std::size_t k = 0; k < now_.size(); ++k) {
    const Row& row = now_[k];
    widest_ = std::max({widest_, std::abs(row.x), std::abs(row.y), std::abs(row.z)});
    looked_[k] = {static_cast<float>(row.x), static_cast<float>(row.y), static_cast<float>(row.z)};
  }
  looked_step_ = step_;
  sorted_at_ = tests();
  drifts_.assign(chunks_.size(), {});
  guesses_.assign(chunks_.size(), {});
  for (Chunk& chunk : chunks_) chunk.bound = chunk.wall_bound = 0;
}

std::int64_t Crowd::tests() const {
  std::int64_t all = account_.search_steps;
  for (const Chunk& chunk : chunks_) all += chunk.doings.tests;
  return all;
}

/// Looking at pairs has cost what sorting them anew does, after which fewer need be looked at. (7
/// was found by trial; 4 to 12 make no difference.)
bool Crowd::worth_sorting() const {
  std::int64_t pairs = 0;
  for (const Chunk& c : chunks_)
    pairs += std::ssize(c.near.pairs) + std::ssize(c.near.parted) + std::ssize(c.near_wall.pairs);
  return tests() - sorted_at_ > 7 * pairs;
}

/// Near pairs by their gaps now.
void Crowd::sort_pairs() {
  double most = 0;
  for (const Chunk& c : chunks_) most = std::max({most, c.bound, c.wall_bound});
  spent_ += most;
  crew_.all([&](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    std::vector<Nigh> pairs;
    std::vector<double> gaps;
    for (std::int32_t c = share_[t]; c < share_[t + 1]; ++c) {
      Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
      for (Waiting* w : {&chunk.near, &chunk.near_wall}) {
        pairs.swap(w->pairs);
        pairs.insert(pairs.end(), w->parted.begin(), w->parted.end());
        gaps.clear();
        for (const Nigh& pair : pairs) gaps.push_back(gap(pair));
        into_bins(*w, pairs, gaps, skin_ * Waiting::width);
      }
    }
  });
  for (const Chunk& c : chunks_)
    pairs_sorted_ += std::ssize(c.near.pairs) + std::ssize(c.near_wall.pairs);
  mark_places();
}

double Crowd::gap(const Nigh& pair) const {
  const Row& a = now_[static_cast<std::size_t>(pair.ball)];
  if (pair.other < 0) return jar_->gap(~pair.other, a.place(), clock(step_)).distance - a.radius;
  const Row& b = now_[static_cast<std::size_t>(pair.other)];
  return norm(nearest(b.place() - a.place())) - a.radius - b.radius;
}

/// The skin for which looking for near pairs and looking at them cost least together, in counts, so
/// that every machine takes the same.
void Crowd::tune_skin() {
  const auto steps = static_cast<double>(step_ - tuning_.step);
  tuning_.step = step_;
  if (steps < 2) return;
  // In ns: of a pair at a step, of sorting it, of looking for those of a ball.
  constexpr double look = 2, sort = 6, find = 700;
  const auto all = static_cast<double>(account_.search_steps);
  const double cost = (look * (all - tuning_.looked) + sort * static_cast<double>(pairs_sorted_) +
                       find * static_cast<double>(now_.size())) /
                      steps;
  pairs_sorted_ = 0;
  if (tuning_.last_cost > 0 && cost > tuning_.last_cost) tuning_.growing = 1 / tuning_.growing;
  tuning_.last_cost = cost;
  tuning_.looked = all;
  double smallest = geometry::never;
  for (const Species& s : breeds_.all_species()) smallest = std::min(smallest, s.radius);
  skin_ = std::clamp(skin_ * tuning_.growing, 0.1 * smallest, 2 * smallest);
}

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

/// Near pairs that have no contact yet. A pair with a ball of another chunk is found by both.
void Crowd::find_near(Chunk& chunk) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;
  for (const Grips* list : {&chunk.own, &chunk.cross})
    for (const Grip& g : list->grips)
      for (std::size_t l = 0; l < lanes; ++l) {
        if (g.touching[static_cast<int>(l)] == 0) continue;
        const bool own = list == &chunk.own;
        touching.emplace_back(own ? std::min(g.i[l], g.j[l]) : g.i[l],
                              own ? std::max(g.i[l], g.j[l]) : g.j[l]);
      }
  std::ranges::sort(touching);
  std::vector<Nigh> found;
  std::vector<double> gaps;
  auto at = touching.begin();
  std::vector<bool> beside(chunks_.size());
  const auto outside = [&](std::int32_t j) { return j < chunk.first || j >= chunk.last; };
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Row& ball = now_[static_cast<std::size_t>(i)];
    const Vec3 x = ball.place();
    const auto begin = at;
    while (at != touching.end() && at->first == i) ++at;
    const auto has = [&](std::int32_t j) {
      return std::any_of(begin, at, [&](const auto& pair) { return pair.second == j; });
    };
    for (const Grid& grid : grids_)
      grid.near(x, ball.radius + grid.radius() + skin_ + reach_,
                [&](std::int32_t first, std::int32_t last) {
                  for (std::int32_t j = first; j < last; ++j) {
                    if (j <= i && !outside(j)) continue;
                    const Row& other = now_[static_cast<std::size_t>(j)];
                    const double touch = ball.radius + other.radius;
                    const double far = touch + skin_ + reach_;
                    const double distance2 = squared(nearest(other.place() - x));
                    if (!(distance2 < far * far)) continue;
                    if (outside(j)) beside[static_cast<std::size_t>(chunk_of(j))] = true;
                    if (has(j)) continue;
                    found.push_back({i, j});
                    gaps.push_back(std::sqrt(distance2) - touch);
                  }
                });
  }
  for (const auto& [i, j] : touching)
    if (outside(j)) beside[static_cast<std::size_t>(chunk_of(j))] = true;
  chunk.beside.clear();
  for (std::size_t c = 0; c < beside.size(); ++c)
    if (beside[c]) chunk.beside.push_back(static_cast<std::int32_t>(c));
  into_bins(chunk.near, found, gaps, skin_ * Waiting::width);
}

/// Finds a ball that has gone wrong, too.
Crowd::Wrong Crowd::near_walls(Chunk& chunk) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;
  for (const Grip& g : chunk.wall.grips)
    for (std::size_t l = 0; l < lanes; ++l)
      if (g.touching[static_cast<int>(l)] != 0) touching.emplace_back(g.i[l], g.j[l]);
  std::ranges::sort(touching);
  std::vector<Nigh> found;
  std::vector<double> gaps, all(static_cast<std::size_t>(jar_->faces()));
  const double t = clock(step_);
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Row& ball = now_[static_cast<std::size_t>(i)];
    jar_->distances(ball.place(), t, all);
    for (int face = 0; face < jar_->faces(); ++face) {
      const double gap = all[static_cast<std::size_t>(face)] - ball.radius;
      if (gap > skin_ + reach_ || !jar_->meets(face, ball.radius)) continue;
      if (!(gap > -ball.radius)) return {static_cast<std::size_t>(i), "it is outside the jar"};
      if (std::ranges::binary_search(touching, std::pair(i, face))) continue;
      found.push_back({i, ~face});
      gaps.push_back(gap);
    }
  }
  into_bins(chunk.near_wall, found, gaps, skin_ * Waiting::width);
  return {};
}

/// Bodies that overlap much at the start would fly apart.
void Crowd::refuse_overlaps() const {
  for (const Chunk& chunk : chunks_) {
    for (const Waiting* w : {&chunk.near, &chunk.near_wall})
      for (const Nigh& pair : w->pairs) {
        const Row& a = now_[static_cast<std::size_t>(pair.ball)];
        const auto ball = static_cast<std::size_t>(id_[static_cast<std::size_t>(pair.ball)]);
        if (pair.other < 0) {
          const double gap = jar_->gap(~pair.other, a.place(), clock(0)).distance;
          const double overlap = (a.radius - gap) / a.radius;
          if (overlap > rules_.most_overlap) throw overlapping(ball, "the jar", overlap);
          continue;
        }
        const Row& b = now_[static_cast<std::size_t>(pair.other)];
        const double distance = norm(nearest(b.place() - a.place()));
        const double overlap = (a.radius + b.radius - distance) / std::min(a.radius, b.radius);
        if (overlap > rules_.most_overlap)
          throw overlapping(
              ball, fmt::format("ball {}", id_[static_cast<std::size_t>(pair.other)] + 1), overlap);
      }
  }
}

}  // namespace mahlwerk::soft

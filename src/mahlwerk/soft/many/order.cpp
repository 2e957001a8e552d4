// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Balls are sorted along a space-filling curve (Morton order) and divided into chunks.
namespace mahlwerk::soft {
namespace {

constexpr std::int32_t chunk_size = 1024;

/// Number of chunks of `balls` balls.
std::int32_t chunk_count(std::int32_t balls) {
  return (balls + chunk_size - 1) / chunk_size;
}

/// Permutes in place, along the cycles of the permutation: a second array would take a tenth of all
/// memory.
template <class Rows>
void permute(Rows& all, const std::vector<std::int32_t>& from) {
  std::vector<bool> done(from.size());
  for (std::size_t first = 0; first < from.size(); ++first) {
    if (done[first]) continue;
    const auto kept = all[first];
    std::size_t at = first;
    for (auto next = static_cast<std::size_t>(from[at]); next != first;
         next = static_cast<std::size_t>(from[at])) {
      all[at] = all[next];
      done[at] = true;
      at = next;
    }
    all[at] = kept;
    done[at] = true;
  }
}

/// Row and its sort key; sort_by_key is a stable radix sort.
struct KeyedRow {
  std::uint64_t key = 0;
  std::int32_t row = 0;
};
void sort_by_key(std::vector<KeyedRow>& all) {
  constexpr int digit = 11;
  std::uint64_t bits = 0;
  for (const KeyedRow& k : all) bits |= k.key;
  std::vector<KeyedRow> other(all.size());
  for (int shift = 0; shift < 64 && bits >> shift != 0; shift += digit) {
    std::array<std::size_t, (1 << digit) + 1> at{};
    const auto of = [&](const KeyedRow& k) { return k.key >> shift & ((1 << digit) - 1); };
    for (const KeyedRow& k : all) ++at[of(k) + 1];
    for (std::size_t d = 1; d < at.size(); ++d) at[d] += at[d - 1];
    for (const KeyedRow& k : all) other[at[of(k)]++] = k;
    all.swap(other);
  }
}

}  // namespace

/// Sorts the balls along the curve, divides them into new chunks, and moves their contacts.
void ManyBodySolver::sort_into_chunks() {
  for (Chunk& chunk : chunks_) chunk.ball_pairs = {}, chunk.wall_pairs = {};  // frees memory
  const std::vector<std::int32_t> from = sort_balls();
  std::vector<std::int32_t> to(from.size());
  for (std::size_t k = 0; k < from.size(); ++k)
    to[static_cast<std::size_t>(from[k])] = static_cast<std::int32_t>(k);
  const ContactsByBall contacts = collect_contacts(to);
  reorder(from);
  std::vector<Chunk> old = make_chunks();
  share_work();
  distribute_contacts(contacts, old);
  share_work();
}

/// Returns the old row of each new row: sorted by size class, then along the curve; those of balls
/// that leave are the last.
std::vector<std::int32_t> ManyBodySolver::sort_balls() {
  std::vector<PositionBounds> bounds(class_radius_.size());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Vec3 x = rows_[k].position();
    if (!std::isfinite(squared(x))) stop(k, not_finite_message);
    if (leaves(k)) continue;
    bounds[class_of(k)].add(x);
  }
  grids_.clear();
  class_first_.assign(1, 0);
  for (std::size_t c = 0; c < bounds.size(); ++c) {
    grids_.emplace_back(bounds[c], class_radius_[c], skin_ + pull_off_distance_, jar_->periods());
    class_first_.push_back(class_first_.back() + static_cast<std::int32_t>(bounds[c].count));
  }
  std::vector<std::int32_t> from;
  from.reserve(rows_.size());
  std::vector<KeyedRow> order;
  for (std::size_t c = 0; c < grids_.size(); ++c) {
    if (c >= first_body_class_) {
      sort_bodies(c, from);
      continue;
    }
    order.clear();
    order.reserve(bounds[c].count);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (class_of(k) == c && !leaves(k))
        order.push_back({grids_[c].key(rows_[k].position()), static_cast<std::int32_t>(k)});
    sort_by_key(order);
    for (const KeyedRow& k : order) from.push_back(k.row);
  }
  for (std::size_t k = 0; k < leaves_.size(); ++k)
    if (leaves_[k]) from.push_back(static_cast<std::int32_t>(k));
  return from;
}

void ManyBodySolver::reorder(const std::vector<std::int32_t>& from) {
  permute(rows_, from);
  permute(spins_, from);
  permute(half_step_, from);
  permute(id_, from);
  permute(species_, from);
  permute(contacts_of_, from);
  if (bodies_.has_members()) reorder_bodies(from);
  if (keeps_next_rows_) permute(next_rows_, from), permute(next_spins_, from);
  const auto kept = static_cast<std::size_t>(class_first_.back());
  if (kept < from.size()) drop_rows(kept);
  for (std::size_t c = 0; c + 1 < class_first_.size(); ++c)
    grids_[c].fill(class_first_[c], class_first_[c + 1],
                   [&](std::int32_t row) { return grid_position(static_cast<std::size_t>(row)); });
}

/// Makes chunks of about equal size; returns the old ones.
std::vector<Chunk> ManyBodySolver::make_chunks() {
  std::vector<Chunk> old = std::move(chunks_);
  chunks_.clear();
  const auto cut = [&](std::int32_t row) {  // a chunk holds whole bodies
    return static_cast<std::size_t>(row) < rows_.size() && is_member(static_cast<std::size_t>(row))
               ? bodies_.first_row(row)
               : row;
  };
  for (std::size_t c = 0; c + 1 < class_first_.size(); ++c) {
    const std::int32_t first = class_first_[c], count = class_first_[c + 1] - first;
    const std::int32_t all = chunk_count(count);
    for (std::int32_t p = 0; p < all; ++p) {
      Chunk& chunk = chunks_.emplace_back();
      chunk.first = cut(first + static_cast<std::int32_t>(std::int64_t{count} * p / all));
      chunk.last = cut(first + static_cast<std::int32_t>(std::int64_t{count} * (p + 1) / all));
      for (std::int32_t row = chunk.first; row < chunk.last; ++row)
        if (contacts_of_[static_cast<std::size_t>(row)] > 0) ++chunk.balls_in_contact;
    }
  }
  return old;
}

std::int32_t ManyBodySolver::chunk_of(std::int32_t ball) const {
  std::int32_t chunk = 0;
  std::size_t c = 0;
  for (; ball >= class_first_[c + 1]; ++c)
    chunk += chunk_count(class_first_[c + 1] - class_first_[c]);
  const std::int32_t first = class_first_[c], count = class_first_[c + 1] - first;
  chunk += static_cast<std::int32_t>(std::int64_t{ball - first} * chunk_count(count) / count);
  // Rounding; bodies move a border by less than a body.
  while (ball >= chunks_[static_cast<std::size_t>(chunk)].last) ++chunk;
  return chunk;
}

/// Divides the chunks among the threads, with about the same number of balls and contacts each.
void ManyBodySolver::share_work() {
  const auto weight = [](const Chunk& c) {
    return c.last - c.first +
           2 * lanes *
               static_cast<std::int64_t>(c.own.packets.size() + c.halo.packets.size() +
                                         c.wall.packets.size());
  };
  std::int64_t all = 0, done = 0;
  for (const Chunk& c : chunks_) all += weight(c);
  share_.assign(1, 0);
  std::int32_t c = 0;
  for (int t = 1; t < team_.size(); ++t) {
    for (; static_cast<std::size_t>(c) < chunks_.size() && done * team_.size() < all * t; ++c)
      done += weight(chunks_[static_cast<std::size_t>(c)]);
    share_.push_back(c);
  }
  share_.push_back(static_cast<std::int32_t>(chunks_.size()));
  std::int32_t most = chunk_size;
  for (const Chunk& chunk : chunks_) most = std::max(most, chunk.last - chunk.first);
  for (BallForces& ball_forces : ball_forces_) ball_forces.resize(static_cast<std::size_t>(most));
}

}  // namespace mahlwerk::soft

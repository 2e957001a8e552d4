// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/periodic.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

namespace mahlwerk::soft {

void Candidates::add(const BallRecord* rows, std::int32_t first, std::int32_t last) {
  for (std::int32_t j = first; j < last; ++j, ++count_) {
    if (count_ == lanes * blocks_.size()) blocks_.emplace_back();
    Block& block = blocks_[count_ / lanes];
    const std::size_t l = count_ % lanes;
    const BallRecord& ball = rows[j];
    block.x[l] = ball.x, block.y[l] = ball.y, block.z[l] = ball.z;
    block.radius[l] = ball.radius, block.row[l] = j;
  }
}

template <class V>
[[gnu::always_inline]] inline MaskOf<V> Candidates::test(const LaneGroup<V>& group, const Block& b,
                                                         const Query& query, V& squared) const {
  Vec<V> separation{group(b.x) - query.position.x, group(b.y) - query.position.y,
                    group(b.z) - query.position.z};
  if (periodic_) separation = nearest_image<V>(separation, periods_);
  squared = dot(separation, separation);
  const V far = group(b.radius) + query.beyond, row = group(b.row), zero{};
  return less<V>(squared, far * far) & (less<V>(zero + static_cast<double>(query.after), row) |
                                        less<V>(row, zero + static_cast<double>(query.before)));
}

template <class V>
[[gnu::always_inline]] inline void Candidates::find(const Query& query) {
  found_.clear();
  for (std::size_t n = 0; n < count_; n += width_of<V>) {
    const Block& b = blocks_[n / lanes];
    const LaneGroup<V> group{static_cast<int>(n % lanes)};
    V squared;
    std::uint32_t near = bits(test<V>(group, b, query, squared));
    if (count_ - n < width_of<V>) near &= (1U << (count_ - n)) - 1;
    for (; near != 0; near &= near - 1) {
      const int l = __builtin_ctz(near);
      const auto lane = static_cast<std::size_t>(group.first + l);
      found_.push_back(
          {static_cast<std::int32_t>(b.row[lane]), std::sqrt(squared[l]) - b.radius[lane]});
    }
  }
}

struct Candidates::Search {
  template <int width>
  [[gnu::always_inline]] static void run(Candidates& all, const Query& query) {
    all.find<Register<width>>(query);
  }
};

Candidates::Candidates(const Vec3& periods)
    : periods_(periods),
      periodic_(is_periodic(periods)),
      find_(Multiversioned<Search, void (*)(Candidates&, const Query&)>::best()) {}

std::span<const Candidates::Neighbour> Candidates::find_near(const Query& query) {
  find_(*this, query);
  return found_;
}

}  // namespace mahlwerk::soft

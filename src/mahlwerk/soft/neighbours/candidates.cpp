// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/isa.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

namespace mahlwerk::soft {

void Candidates::add(const BallRecord* rows, std::int32_t first, std::int32_t last) {
  for (std::int32_t j = first; j < last; ++j, ++count_) {
    if (count_ == lanes * blocks_.size()) blocks_.emplace_back();
    Block& block = blocks_[count_ / lanes];
    const auto l = static_cast<int>(count_ % lanes);
    const BallRecord& ball = rows[j];
    block.x[l] = ball.x, block.y[l] = ball.y, block.z[l] = ball.z;
    block.radius[l] = ball.radius, block.row[l] = j;
  }
}

[[gnu::always_inline]] inline LaneMask Candidates::test(const Block& b, const Query& query,
                                                        Lanes& squared) const {
  Vec<Lanes> separation{b.x - query.position.x, b.y - query.position.y, b.z - query.position.z};
  if (periodic_) separation = nearest_image(separation, periods_);
  squared = dot(separation, separation);
  const Lanes far = b.radius + query.beyond, zero{};
  return less(squared, far * far) &
         (less(zero + query.after, b.row) | less(b.row, zero + query.before));
}

[[gnu::always_inline]] inline void Candidates::find(const Query& query) {
  found_.clear();
  for (std::size_t n = 0; n * lanes < count_; ++n) {
    const Block& b = blocks_[n];
    Lanes squared;
    const LaneMask near = test(b, query, squared);
    if (!any(near)) continue;
    std::uint32_t those = bits(near, std::min<std::size_t>(lanes, count_ - n * lanes));
    for (; those != 0; those &= those - 1) {
      const int l = __builtin_ctz(those);
      found_.push_back({static_cast<std::int32_t>(b.row[l]), std::sqrt(squared[l]) - b.radius[l]});
    }
  }
}

struct Candidates::Search {
  template <bool avx512>
  [[gnu::always_inline]] static void run(Candidates& all, const Query& query) {
    all.find(query);
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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

constexpr std::uint32_t bit(std::size_t lane) {
  return 1U << lane;
}

/// Neighbour pair: two balls, or a ball and the face ~other if other < 0.
struct NeighbourPair {
  std::int32_t ball = 0, other = 0;
};

/// Separations of as many pairs of balls as fit a register.
template <class V>
struct PairSeparation {
  Vec<V> centres;  ///< [m] from ball to other
  V touch;         ///< [m] sum of the radii
};

/// Separations of `count` pairs, at most a register; lanes from `count` on repeat the first pair.
template <class V>
[[gnu::always_inline]] inline PairSeparation<V> pair_separations(const BallRecord* rows,
                                                                 const NeighbourPair* pairs,
                                                                 std::size_t count) {
  V c[4];
  const auto pair = [&](std::size_t k) -> const NeighbourPair& { return pairs[k < count ? k : 0]; };
  const auto ball = [&](std::size_t k) -> const BallRecord& { return rows[pair(k).ball]; };
  const auto other = [&](std::size_t k) -> const BallRecord& { return rows[pair(k).other]; };
  if constexpr (width_of<V> == 8) {  // differences before the transposition: half of its work
    constexpr V sign{1, 1, 1, -1, 1, 1, 1, -1};
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = load_fours(other(k), other(k + 4), 0) - sign * load_fours(ball(k), ball(k + 4), 0);
    transpose(c);
  } else if constexpr (width_of<V> == 4) {
    constexpr V sign{1, 1, 1, -1};
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = load_part<V>(other(k)) - sign * load_part<V>(ball(k));
    transpose(c);
  } else {
    V a[4];
    load_columns<V>(ball, 0, a);
    load_columns<V>(other, 0, c);
    for (std::size_t k = 0; k < 3; ++k) c[k] = c[k] - a[k];
    c[3] = c[3] + a[3];
  }
  return {{c[0], c[1], c[2]}, c[3]};
}

/// Computes the gaps between the surfaces of pairs of balls [m].
void find_gaps(const BallRecord* rows, std::span<const NeighbourPair> pairs, const Vec3& periods,
               std::span<double> gaps);

}  // namespace mahlwerk::soft

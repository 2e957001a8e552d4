// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

constexpr std::uint32_t bit(int lane) {
  return 1U << lane;
}
/// The mask of the lanes whose bits are set.
[[gnu::always_inline]] inline LaneMask mask(std::uint32_t bits) {
  constexpr LaneMask lane{0, 1, 2, 3, 4, 5, 6, 7};
  return -(((LaneMask{} + static_cast<std::int64_t>(bits)) >> lane) & 1);
}
/// The bits of the lanes that are set among the first `count`.
[[gnu::always_inline]] inline std::uint32_t bits(const LaneMask& mask, std::size_t count) {
  std::uint32_t all = 0;
  for (int l = 0; l < static_cast<int>(count); ++l) all |= mask[l] != 0 ? bit(l) : 0;
  return all;
}

/// Neighbour pair: two balls, or a ball and the face ~other if other < 0.
struct NeighbourPair {
  std::int32_t ball = 0, other = 0;
};

/// Separations of eight pairs of balls.
struct PairSeparation {
  Vec<Lanes> centres;  ///< [m] from ball to other
  Lanes touch;         ///< [m] sum of the radii
};

/// Separations of `count` pairs, at most eight; lanes from `count` on repeat the first pair.
template <bool avx512>
[[gnu::always_inline]] inline PairSeparation pair_separations(const BallRecord* rows,
                                                              const NeighbourPair* pairs,
                                                              std::size_t count) {
  Lanes c[4];
  const Lanes sign{1, 1, 1, -1, 1, 1, 1, -1};
  const auto pair = [&](std::size_t k) -> const NeighbourPair& { return pairs[k < count ? k : 0]; };
  for (std::size_t k = 0; k < lanes; ++k) {
    const BallRecord &a = rows[pair(k).ball], &b = rows[pair(k).other];
    const auto l = static_cast<int>(k);
    if constexpr (!avx512)
      c[0][l] = b.x - a.x, c[1][l] = b.y - a.y, c[2][l] = b.z - a.z, c[3][l] = b.radius + a.radius;
    else if (k < 4)
      c[k] = load_fours(b, rows[pair(k + 4).other]) - sign * load_fours(a, rows[pair(k + 4).ball]);
  }
  if constexpr (avx512) transpose(c);
  return {{c[0], c[1], c[2]}, c[3]};
}

/// Computes the gaps between the surfaces of pairs of balls [m].
void find_gaps(const BallRecord* rows, std::span<const NeighbourPair> pairs, const Vec3& periods,
               std::span<double> gaps);

}  // namespace mahlwerk::soft

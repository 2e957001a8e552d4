// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/soft/rows.hpp"

namespace mahlwerk::soft {

/// A pair that is near; other < 0: the face ~other.
struct Nigh {
  std::int32_t ball = 0, other = 0;
};

/// Eight pairs of balls.
struct Apart {
  Vec<Lanes> centres;  ///< [m] from one to the other
  Lanes touch;         ///< [m] sum of the radii
};

/// Up to eight pairs; lanes from `count` on are those of the first.
template <bool wide>
[[gnu::always_inline]] inline Apart apart(const Row* rows, const Nigh* pairs, std::size_t count) {
  Lanes c[4];
  const Lanes sign{1, 1, 1, -1, 1, 1, 1, -1};
  const auto pair = [&](std::size_t k) -> const Nigh& { return pairs[k < count ? k : 0]; };
  for (std::size_t k = 0; k < lanes; ++k) {
    const Row &a = rows[pair(k).ball], &b = rows[pair(k).other];
    const auto l = static_cast<int>(k);
    if constexpr (!wide)
      c[0][l] = b.x - a.x, c[1][l] = b.y - a.y, c[2][l] = b.z - a.z, c[3][l] = b.radius + a.radius;
    else if (k < 4)
      c[k] = fours(b, rows[pair(k + 4).other]) - sign * fours(a, rows[pair(k + 4).ball]);
  }
  if constexpr (wide) transpose(c);
  return {{c[0], c[1], c[2]}, c[3]};
}

/// How far the surfaces of pairs of balls are from each other [m]. `periods` [m] are infinite where
/// places do not repeat.
void find_gaps(const Row* rows, std::span<const Nigh> pairs, const Vec3& periods,
               std::span<double> gaps);

}  // namespace mahlwerk::soft

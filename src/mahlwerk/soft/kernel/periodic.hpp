// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"

// Minimum-image separations in a periodic box; `periods` [m] are infinite where it is not periodic.
namespace mahlwerk::soft {

inline bool is_periodic(const Vec3& periods) {
  return std::isfinite(periods.x) || std::isfinite(periods.y) || std::isfinite(periods.z);
}

/// Separation to the nearest image, for any distance.
inline Vec3 nearest_image(const Vec3& separation, const Vec3& periods) {
  return {std::remainder(separation.x, periods.x), std::remainder(separation.y, periods.y),
          std::remainder(separation.z, periods.z)};
}
template <class V>
[[gnu::always_inline]] inline Vec<V> nearest_image(const Vec<V>& separation, const Vec3& periods) {
  const auto fold = [](const V& a, double period) {
    return lanes_from<V>([&](int l) { return std::remainder(a[l], period); });
  };
  return {fold(separation.x, periods.x), fold(separation.y, periods.y),
          fold(separation.z, periods.z)};
}

/// Separation to the nearest image, for any distance below 1e15 periods. Positions are not kept
/// within a period, so balls may drift apart without limit.
template <class V>
[[gnu::always_inline]] inline V folded(const V& a, double period) {
  constexpr double round_to_integer = 6755399441055744;  // 1.5 * 2^52
  const double finite = std::min(period, 1e300);
  const V x = a * (1 / finite);
  return a - finite * ((x + round_to_integer) - round_to_integer);
}
template <class V>
[[gnu::always_inline]] inline Vec<V> folded(const Vec<V>& separation, const Vec3& periods) {
  return {folded<V>(separation.x, periods.x), folded<V>(separation.y, periods.y),
          folded<V>(separation.z, periods.z)};
}

}  // namespace mahlwerk::soft

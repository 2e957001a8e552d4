// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"

// Separations in a periodic box; `periods` [m] are infinite where it does not repeat.
namespace mahlwerk::soft {

inline bool repeats(const Vec3& periods) {
  return std::isfinite(periods.x) || std::isfinite(periods.y) || std::isfinite(periods.z);
}

/// To the nearest image, however far apart.
inline Vec3 nearest_image(const Vec3& apart, const Vec3& periods) {
  return {std::remainder(apart.x, periods.x), std::remainder(apart.y, periods.y),
          std::remainder(apart.z, periods.z)};
}
inline Vec<Lanes> nearest_image(const Vec<Lanes>& apart, const Vec3& periods) {
  Vec<Lanes> nearest;
  for (int l = 0; l < lanes; ++l) {
    nearest.x[l] = std::remainder(apart.x[l], periods.x);
    nearest.y[l] = std::remainder(apart.y[l], periods.y);
    nearest.z[l] = std::remainder(apart.z[l], periods.z);
  }
  return nearest;
}

/// To the nearest image, of positions that are at most a period and a half apart.
[[gnu::always_inline]] inline Lanes folded(const Lanes& a, const Lanes& period) {
  Lanes x = a;
  x -= choose(x > 0.5 * period, period, Lanes{});
  x += choose(x < -0.5 * period, period, Lanes{});
  return x;
}
[[gnu::always_inline]] inline Vec<Lanes> folded(const Vec<Lanes>& apart,
                                                const Vec<Lanes>& periods) {
  return {folded(apart.x, periods.x), folded(apart.y, periods.y), folded(apart.z, periods.z)};
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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
inline Vec<Lanes> nearest_image(const Vec<Lanes>& separation, const Vec3& periods) {
  Vec<Lanes> nearest;
  for (int l = 0; l < lanes; ++l) {
    nearest.x[l] = std::remainder(separation.x[l], periods.x);
    nearest.y[l] = std::remainder(separation.y[l], periods.y);
    nearest.z[l] = std::remainder(separation.z[l], periods.z);
  }
  return nearest;
}

/// Separation to the nearest image, for positions at most 1.5 periods apart.
[[gnu::always_inline]] inline Lanes folded(const Lanes& a, const Lanes& period) {
  Lanes x = a;
  x -= select(x > 0.5 * period, period, Lanes{});
  x += select(x < -0.5 * period, period, Lanes{});
  return x;
}
[[gnu::always_inline]] inline Vec<Lanes> folded(const Vec<Lanes>& separation,
                                                const Vec<Lanes>& periods) {
  return {folded(separation.x, periods.x), folded(separation.y, periods.y),
          folded(separation.z, periods.z)};
}

}  // namespace mahlwerk::soft

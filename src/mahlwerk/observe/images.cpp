// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/images.hpp"

#include <cmath>

namespace mahlwerk::observe {

double folded(double x, double period) {
  return std::isfinite(period) ? std::remainder(x, period) : x;
}

Vec3 folded(const Vec3& p, const Vec3& periods) {
  return {folded(p.x, periods.x), folded(p.y, periods.y), folded(p.z, periods.z)};
}

Images images(std::span<const scene::Ball> balls, const Vec3& periods, double within) {
  Images all;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    all.balls.push_back(balls[i]);
    all.balls.back().position = folded(balls[i].position, periods);
    all.of.push_back(static_cast<std::uint32_t>(i));
  }
  // Along one axis after the other, images of images along those before.
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double period = periods.*axis;
    if (!std::isfinite(period)) continue;
    const std::size_t before = all.balls.size();
    for (std::size_t i = 0; i < before; ++i)
      for (const double side : {-1.0, 1.0})
        for (double away = period;; away += period) {
          scene::Ball image = all.balls[i];
          image.position.*axis += side * away;
          if (std::abs(image.position.*axis) > 0.5 * period + within) break;
          all.balls.push_back(image);
          all.of.push_back(all.of[i]);
        }
  }
  return all;
}

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/meetings.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::event {
namespace {

template <bool periodic>
Meeting first(const Asking& me, std::span<const Line> lines, std::span<const std::int32_t> others,
              const double* radii, const Vec3& periods, Meeting best) {
  double soonest = best.time - me.time;
  for (const std::int32_t other : others) {
    const Line& line = lines[static_cast<std::size_t>(other)];
    Vec3 r = me.position - line.at(me.time);
    if constexpr (periodic) r = nearest_image(r, periods);
    const Vec3 u = me.velocity - line.velocity;
    const double reach = me.radius + radii[line.species];
    const double b = dot(r, u), u2 = squared(u), gap = squared(r) - reach * reach;
    const double d = b * b - u2 * gap;
    if (!((b < 0) & (d > 0))) continue;
    const double time = std::max(gap, 0.0) / (std::sqrt(d) - b);
    if (time < soonest) {
      soonest = time;
      best = {me.time + time, other};
    }
  }
  return best;
}

}  // namespace

Meeting first_meeting(const Asking& asking, std::span<const Line> lines,
                      std::span<const std::int32_t> others, const double* radii,
                      const Vec3& periods, Meeting best) {
  if (periods.x < at_no_time) return first<true>(asking, lines, others, radii, periods, best);
  return first<false>(asking, lines, others, radii, periods, best);
}

}  // namespace mahlwerk::event

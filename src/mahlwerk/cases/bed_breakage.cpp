// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/bed_breakage.hpp"

#include <algorithm>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::cases {

bool coarse_grains(const Case& c) {
  if (!c.powder || !c.powder->size || !c.powder->grain_size) return false;
  constexpr double rounding = 1e-9;
  return c.powder->feed.law != powder::Feed::Law::equal ||
         *c.powder->grain_size > *c.powder->size * (1 + rounding);
}

powder::BedBreakage bed_breakage(const Case& c, int replicate) {
  const BedBreakage& given = *c.bed_breakage;
  const double grain = c.powder->grain_size.value_or(1);
  powder::BedBreakage bed;
  bed.kind = static_cast<std::int32_t>(c.balls.size()) - 1;
  bed.grain_size = grain;
  bed.coarse = coarse_grains(c);
  bed.feed = c.powder->feed;
  if (bed.feed.law == powder::Feed::Law::equal) bed.feed.size = c.powder->size.value_or(grain);
  bed.smallest_fragment = given.smallest.value_or(grain / 4);
  bed.finest =
      given.finest.value_or((bed.coarse ? bed.feed.smallest() / 4 : bed.smallest_fragment) / 16);
  bed.per_octave = static_cast<int>(given.classes_per_octave);
  bed.breakage = given.breakage;
  bed.fragments = given.fragments;
  bed.seed = c.seed + static_cast<std::uint64_t>(replicate);
  return bed;
}

std::int64_t largest_grain_number(const Case& c) {
  const std::int64_t count = c.balls.back().count;
  if (coarse_grains(c)) return count;
  const auto sizes = static_cast<std::int64_t>(bed_breakage(c).diameters().size());
  return std::max(c.bed_breakage->largest_number.value_or(4 * count), count + sizes);
}

std::vector<scene::Ball> spare_grains(const Case& c) {
  if (coarse_grains(c)) return {};
  const std::vector<double> diameters = bed_breakage(c).diameters();
  const BallSet& grains = c.balls.back();
  scene::Ball ball;
  ball.kind = static_cast<std::int32_t>(c.balls.size()) - 1;
  ball.density = grains.density;
  ball.outside = true;
  std::vector<scene::Ball> spare(static_cast<std::size_t>(largest_grain_number(c) - grains.count),
                                 ball);
  for (std::size_t k = 0; k < spare.size(); ++k)
    spare[k].radius = 0.5 * diameters[std::min(k, diameters.size() - 1)];
  return spare;
}

}  // namespace mahlwerk::cases

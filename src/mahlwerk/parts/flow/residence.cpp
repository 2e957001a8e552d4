// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/flow/residence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace mahlwerk::parts::flow {

ResidenceTimes residence_times(std::vector<Tracer> tracers) {
  constexpr double most_unknown = 0.05;
  std::ranges::sort(tracers, {}, [](const Tracer& s) { return std::tuple(s.time, !s.left); });
  ResidenceTimes found{.steps = {{}}, .longest = 0, .mean = 0, .spread = 0};
  double inside = 1, first = 0, second = 0;  // moments: of S, and of 2 t S
  const auto integrate = [&](double from, double to) {
    first += inside * (to - from);
    second += inside * (to * to - from * from);
  };
  for (std::size_t k = 0; k < tracers.size(); ++k) {
    integrate(found.longest, tracers[k].time);
    found.longest = tracers[k].time;
    if (!tracers[k].left) continue;
    inside *= 1 - 1 / static_cast<double>(tracers.size() - k);  // of those followed so long
    if (found.steps.back().time == tracers[k].time)
      found.steps.back().inside = inside;
    else
      found.steps.push_back({tracers[k].time, inside});
  }
  const bool known = !(inside > most_unknown);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  found.mean = known ? first : unknown;
  found.spread = known ? std::sqrt(std::max(0.0, second - first * first)) : unknown;
  return found;
}

}  // namespace mahlwerk::parts::flow

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/heat_share.hpp"

#include <algorithm>

namespace mahlwerk::results {
double heat_share_in_balls(const cases::Case& c, const Replicate& r) {
  if (c.heat->share_in_balls) return *c.heat->share_in_balls;
  if (r.read_before) return r.read_before->heat_in_balls;
  double between_balls = 0, recorded = 0;
  for (int pair = 0; pair < r.tally.by_pair.pairs(); ++pair) {
    const double lost = r.tally.by_pair[pair].spectra.energy_lost.sum();
    recorded += lost;
    if (!r.tally.by_pair.kinds_of(pair).with_jar()) between_balls += lost;
  }
  const double all = std::max(recorded, r.energy_balance.lost() - r.at_settled.lost());
  return all > 0 ? 0.5 + 0.5 * between_balls / all : 0.5;
}

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The groups of quantities, in the order of summary.json.
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/wear.hpp"

namespace mahlwerk::results {

std::vector<Measure> measures(const cases::Case& what) {
  std::vector<Measure> all;
  for (const std::vector<Measure>& group :
       {collision_rates(), collision_rates_by_partner(what), collision_means(), power_measures(),
        loss_measures(what), contact_time_measures(what), mill_measures(what),
        energy_balance_measures(), dose_measures(what), regime_measures(what),
        motion_measures(what), tangential_measures(), wear_measures(what), heat_measures(what),
        capture_measures(what), grinding_measures(what), kinetics_measures(what),
        grain_measures(what), check_measures()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mahlwerk::results

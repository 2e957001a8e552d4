// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The groups of quantities, in the order of summary.json.
#include "mahlwerk/results/quantities/bed.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/kinetics.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/sensors.hpp"
#include "mahlwerk/results/quantities/wear.hpp"

namespace mahlwerk::results {

std::vector<Measure> measures(const cases::Case& mill_case) {
  std::vector<Measure> all;
  for (const std::vector<Measure>& group : {collision_rates(),
                                            collision_rates_by_partner(mill_case),
                                            collision_means(),
                                            power_measures(),
                                            loss_measures(mill_case),
                                            contact_time_measures(mill_case),
                                            mill_measures(mill_case),
                                            energy_balance_measures(),
                                            dose_measures(mill_case),
                                            regime_measures(mill_case),
                                            motion_measures(mill_case),
                                            bed_measures(mill_case),
                                            tangential_measures(),
                                            wear_measures(mill_case),
                                            heat_measures(mill_case),
                                            capture_measures(mill_case),
                                            grinding_measures(mill_case),
                                            kinetics_measures(mill_case),
                                            sensor_measures(mill_case),
                                            grain_measures(mill_case),
                                            check_measures()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mahlwerk::results

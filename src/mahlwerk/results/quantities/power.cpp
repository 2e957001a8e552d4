// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/groups.hpp"

namespace mahlwerk::results {

using scene::EnergyBalance;

namespace {

/// Energy that the collisions above the threshold dissipate along the normal, over all dissipated
/// energy (obs.13).
double impact_efficiency(const cases::Case&, const Replicate& r) {
  double lost = 0;
  for (int pair = 0; pair < r.tally.by_pair.pairs(); ++pair)
    lost += r.tally.by_pair[pair].above.lost_normal;
  return share(share(lost, r.time()), dissipated_power(r));
}

}  // namespace

std::vector<Measure> power_measures() {
  return {
      {"dissipated_power", "W", "power dissipated in collisions and sustained contacts together",
       [](const cases::Case&, const Replicate& r) { return dissipated_power(r); }},
      {"drawn_power", "W", "work of the jar on the balls per time",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::wall_work);
       }},
      {"impact_efficiency", "1",
       "energy that the collisions above the threshold dissipate along the normal, over all "
       "dissipated energy",
       impact_efficiency},
      {"contact_time_share", "1", "share of the balls' time spent in sustained contact",
       [](const cases::Case& c, const Replicate& r) {
         return per_time(r, &EnergyBalance::contact_time) / count_of_balls(c);
       }},
      {"lasting_contacts_rate", "1/s", "sustained contacts begun per second",
       [](const cases::Case&, const Replicate& r) {
         const auto begun = r.energy_balance.lasting_contacts - r.at_settled.lasting_contacts;
         return share(static_cast<double>(begun), r.time());
       }},
  };
}

std::vector<Measure> loss_measures(const cases::Case& mill_case) {
  std::vector<Measure> of_liquid;
  if (mill_case.liquid)
    of_liquid.push_back({"dissipated_power_liquid", "W",
                         "power dissipated by the flow of the liquid between and around balls",
                         [](const cases::Case&, const Replicate& r) {
                           return per_time(r, &EnergyBalance::lost_liquid);
                         }});
  if (mill_case.run.engine != cases::EngineName::soft) return of_liquid;
  std::vector<Measure> all{
      {"dissipated_power_normal", "W",
       "power dissipated along the normal: dampers, hysteresis, cohesion",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_normal);
       }},
      {"dissipated_power_tangential", "W",
       "power dissipated across the normal: sliding and dampers",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_tangential);
       }},
      {"dissipated_power_sliding", "W", "part of the tangential power: slip at the Coulomb limit",
       [](const cases::Case&, const Replicate& r) { return per_time(r, &EnergyBalance::slid); }},
      {"dissipated_power_rolling", "W", "power dissipated by rolling resistance",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_rolling);
       }},
  };
  all.insert(all.end(), of_liquid.begin(), of_liquid.end());
  return all;
}

std::vector<Measure> contact_time_measures(const cases::Case& mill_case) {
  const bool soft = cases::in_time_steps(mill_case.run.engine);  // has no TC rule
  if (soft || mill_case.contact.lasting != cases::SustainedContactModel::tc) return {};
  return {{"tc_collision_share", "1", "share of the collisions that the TC rule made more elastic",
           [](const cases::Case&, const Replicate& r) {
             return share(
                 static_cast<double>(r.energy_balance.tc_collisions - r.at_settled.tc_collisions),
                 static_cast<double>(r.energy_balance.collisions - r.at_settled.collisions));
           }},
          {"power_share_within_contact_time", "1",
           "share of the dissipated power in collisions within contact_time of another of the same "
           "body",
           [](const cases::Case&, const Replicate& r) {
             return share(r.energy_balance.lost_within - r.at_settled.lost_within,
                          r.energy_balance.lost() - r.at_settled.lost());
           }},
          {"hit_share_within_contact_time", "1",
           "share of the collisions above the threshold within contact_time of another of the same "
           "body",
           [](const cases::Case&, const Replicate& r) {
             return share(
                 static_cast<double>(r.energy_balance.hits_within - r.at_settled.hits_within),
                 static_cast<double>(r.tally.above.count));
           }},
          {"withheld_power_share", "1",
           "power that restitution would have dissipated without the TC rule, over the dissipated "
           "power",
           [](const cases::Case&, const Replicate& r) {
             return share(r.energy_balance.withheld - r.at_settled.withheld,
                          r.energy_balance.lost() - r.at_settled.lost());
           }}};
}

}  // namespace mahlwerk::results

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

Measures power_measures() {
  return {
      {"dissipated_power",
       "W",
       "power dissipated in collisions and sustained contacts together",
       [](const cases::Case&, const Replicate& r) { return dissipated_power(r); },
       {.symbol = "$P$",
        .heading = "Power and contacts",
        .key = 1,
        .column = 9,
        .column_head = "dissipated",
        .over_time = [](const Window& w) { return w.lost / w.length; }}},
      {"drawn_power",
       "W",
       "work of the jar on the balls per time",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::wall_work);
       },
       {.symbol = "$P$", .over_time = [](const Window& w) { return w.wall_work / w.length; }}},
      {"impact_efficiency",
       "1",
       "energy that the collisions above the threshold dissipate along the normal, over all "
       "dissipated energy",
       impact_efficiency,
       {.range = share_of_whole, .symbol = "$η$", .equation = "obs.13"}},
      {"contact_time_share",
       "1",
       "share of the balls' time spent in sustained contact",
       [](const cases::Case& c, const Replicate& r) {
         return per_time(r, &EnergyBalance::contact_time) / count_of_balls(c);
       },
       {.range = share_of_whole, .label = "share of time in contact"}},
      {"lasting_contacts_rate",
       "1/s",
       "sustained contacts begun per second",
       [](const cases::Case&, const Replicate& r) {
         const auto begun = r.energy_balance.lasting_contacts - r.at_settled.lasting_contacts;
         return share(static_cast<double>(begun), r.time());
       },
       {.label = "sustained contacts"}},
  };
}

Measures loss_measures() {
  const auto soft = [](std::string_view label) {
    return QuantityTraits{
        .label = label,
        .applies = [](const cases::Case& c) { return c.run.engine == cases::EngineName::soft; },
        .only = "with `engine = \"soft\"`"};
  };
  return {
      {"dissipated_power_normal", "W",
       "power dissipated along the normal: dampers, hysteresis, cohesion",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_normal);
       },
       soft("dissipated power, normal")},
      {"dissipated_power_tangential", "W",
       "power dissipated across the normal: sliding and dampers",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_tangential);
       },
       soft("dissipated power, tangential")},
      {"dissipated_power_sliding", "W", "part of the tangential power: slip at the Coulomb limit",
       [](const cases::Case&, const Replicate& r) { return per_time(r, &EnergyBalance::slid); },
       soft("dissipated power, sliding")},
      {"dissipated_power_rolling", "W", "power dissipated by rolling resistance",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_rolling);
       },
       soft("dissipated power, rolling")},
      {"dissipated_power_liquid",
       "W",
       "power dissipated by the flow of the liquid between and around balls",
       [](const cases::Case&, const Replicate& r) {
         return per_time(r, &EnergyBalance::lost_liquid);
       },
       {.label = "dissipated power, liquid",
        .applies = [](const cases::Case& c) { return c.liquid.has_value(); },
        .only = "with `[liquid]`"}},
  };
}

Measures contact_time_measures() {
  const auto by_tc_rule = [](const cases::Case& c) {
    return !cases::in_time_steps(c.run.engine) &&  // the soft engine has no TC rule
           c.contact.lasting == cases::SustainedContactModel::tc;
  };
  return where(
      by_tc_rule, "with `contact.lasting = \"tc\"`, not with `engine = \"soft\"`",
      {{"tc_collision_share",
        "1",
        "share of the collisions that the TC rule made more elastic",
        [](const cases::Case&, const Replicate& r) {
          return share(
              static_cast<double>(r.energy_balance.tc_collisions - r.at_settled.tc_collisions),
              static_cast<double>(r.energy_balance.collisions - r.at_settled.collisions));
        },
        {.range = share_of_whole, .label = "share of TC collisions"}},
       {"power_share_within_contact_time",
        "1",
        "share of the dissipated power in collisions within contact_time of another of the same "
        "body",
        [](const cases::Case&, const Replicate& r) {
          return share(r.energy_balance.lost_within - r.at_settled.lost_within,
                       r.energy_balance.lost() - r.at_settled.lost());
        },
        {.range = share_of_whole}},
       {"hit_share_within_contact_time",
        "1",
        "share of the collisions above the threshold within contact_time of another of the same "
        "body",
        [](const cases::Case&, const Replicate& r) {
          return share(static_cast<double>(r.energy_balance.hits_within - r.at_settled.hits_within),
                       static_cast<double>(r.tally.above.count));
        },
        {.range = share_of_whole}},
       {"withheld_power_share", "1",
        "power that restitution would have dissipated without the TC rule, over the dissipated "
        "power",
        [](const cases::Case&, const Replicate& r) {
          return share(r.energy_balance.withheld - r.at_settled.withheld,
                       r.energy_balance.lost() - r.at_settled.lost());
        }}});
}

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "mahlwerk/results/quantities/groups.hpp"

namespace mahlwerk::results {
namespace {

using observe::CollisionSums;

/// The mean over all collisions, or over those above the threshold.
template <double CollisionSums::*sum, CollisionSums observe::CollisionStatistics::*which>
double mean_per_collision(const cases::Case&, const Replicate& r) {
  constexpr double factor = sum == &CollisionSums::angle ? 180 / std::numbers::pi : 1;
  const CollisionSums& sums = r.tally.*which;
  return share(factor * sums.*sum, static_cast<double>(sums.count));
}

/// The mean over all collisions, and that over those above the threshold; `key` and `column` are
/// places of the second one.
template <double CollisionSums::*sum>
void add_means(Measures& list, const std::string& name, const char* unit, const std::string& about,
               const QuantityTraits& traits, const QuantityTraits& above = {}) {
  list.push_back(
      {name, unit, about, mean_per_collision<sum, &observe::CollisionStatistics::all>, traits});
  list.push_back({name + "_above_threshold", unit, about + "; collisions above the threshold",
                  mean_per_collision<sum, &observe::CollisionStatistics::above>, above});
}

double between_balls(const CollisionSums& sums, const Replicate& r) {
  return share(static_cast<double>(sums.between_balls), r.time());
}
double with_jar(const CollisionSums& sums, const Replicate& r) {
  return share(static_cast<double>(sums.count - sums.between_balls), r.time());
}

}  // namespace

Measures collision_rates() {
  return {
      {"collision_rate",
       "1/s",
       "collisions per second, all of them",
       [](const cases::Case&, const Replicate& r) {
         return share(static_cast<double>(r.tally.all.count), r.time());
       },
       {.symbol = "$n$",
        .heading = "Collisions",
        .over_time = [](const Window& w) { return w.collisions / w.length; }}},
      {"collision_rate_above_threshold",
       "1/s",
       "collisions per second with a normal speed u_n of at least the threshold",
       [](const cases::Case&, const Replicate& r) {
         return share(static_cast<double>(r.tally.above.count), r.time());
       },
       {.key = 2,
        .column = 6,
        .column_head = "hits above threshold",
        .over_time = [](const Window& w) { return w.above / w.length; }}},
      {"collision_rate_in_flight",
       "1/s",
       "collisions above the threshold per second of the balls' time outside sustained contact",
       [](const cases::Case& c, const Replicate& r) {
         const double contact = r.energy_balance.contact_time - r.at_settled.contact_time;
         return share(static_cast<double>(r.tally.above.count),
                      r.time() - contact / count_of_balls(c));
       },
       {.above_threshold = true}},
  };
}

Measures collision_rates_by_partner() {
  const auto several_balls = [](const cases::Case& c) { return count_of_balls(c) > 1; };
  return where(
      several_balls, "with several balls",
      {
          {"collision_rate_between_balls", "1/s",
           "collisions of balls with balls per second, each once",
           [](const cases::Case&, const Replicate& r) { return between_balls(r.tally.all, r); }},
          {"collision_rate_between_balls_above_threshold", "1/s",
           "collisions of balls with balls per second with a normal speed u_n of at least the "
           "threshold",
           [](const cases::Case&, const Replicate& r) { return between_balls(r.tally.above, r); }},
          {"collision_rate_with_jar", "1/s", "collisions of balls with the jar per second",
           [](const cases::Case&, const Replicate& r) { return with_jar(r.tally.all, r); }},
          {"collision_rate_with_jar_above_threshold", "1/s",
           "collisions of balls with the jar per second with a normal speed u_n of at least the "
           "threshold",
           [](const cases::Case&, const Replicate& r) { return with_jar(r.tally.above, r); }},
      });
}

Measures collision_means() {
  Measures list;
  add_means<&CollisionSums::energy_normal>(
      list, "energy_normal_mean", "J", "mean impact energy of the normal motion, m u_n^2/2",
      {.label = "mean normal energy",
       .symbol = "$E_{n}$",
       .over_time = [](const Window& w) { return w.energy_normal / w.collisions; }},
      {.key = 3, .column = 7, .column_head = "E normal"});
  add_means<&CollisionSums::energy_contact_point>(
      list, "energy_contact_point_mean", "J",
      "mean impact energy of the motion of the contact points, "
      "m (u_n^2 + u_t^2)/2, spin included",
      {.label = "mean contact-point energy",
       .symbol = "$E_{c}$",
       .over_time = [](const Window& w) { return w.energy_contact_point / w.collisions; }},
      {.column = 8, .column_head = "E contact point"});
  add_means<&CollisionSums::energy_centre>(
      list, "energy_centre_mean", "J",
      "mean impact energy of the motion of the centres, spin left out",
      {.label = "mean centre energy", .symbol = "$E_{m}$"});
  add_means<&CollisionSums::lost>(list, "energy_lost_mean", "J",
                                  "mean energy dissipated in one collision",
                                  {.label = "mean energy lost",
                                   .symbol = "$E_{l}$",
                                   .applies = knows_losses,
                                   .only = not_in_lammps},
                                  {.applies = knows_losses, .only = not_in_lammps});
  add_means<&CollisionSums::approach>(list, "impact_speed_normal_mean", "m/s",
                                      "mean normal speed u_n at first contact",
                                      {.label = "mean normal speed", .symbol = "$u_{n}$"});
  add_means<&CollisionSums::slip>(
      list, "impact_speed_tangential_mean", "m/s",
      "mean tangential speed |u_t| of the contact points at first contact, spin included",
      {.label = "mean tangential speed", .symbol = "$u_{t}$"});
  add_means<&CollisionSums::angle>(
      list, "impact_angle_mean", "deg",
      "mean angle of impact, atan2(|u_t|, u_n): 0 head-on, 90 grazing",
      {.range = {.least = 0, .most = 90}, .label = "mean impact angle"});
  return list;
}

}  // namespace mahlwerk::results

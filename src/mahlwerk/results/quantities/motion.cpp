// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/regime.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::Charge;
using observe::CollisionSums;
using observe::PlaneField;

double smallest_radius(const Case& c) {
  double least = INFINITY;
  for (const cases::BallSet& set : c.balls)
    for (const cases::SizeClass& size : set.sizes()) least = std::min(least, 0.5 * size.diameter);
  return least;
}

/// Share of the cells within reach of a ball's centre that hold more than `bound` times the density
/// of a uniformly spread charge (obs.9).
double occupied_share(const Case& c, const Replicate& r) {
  constexpr double bound = 0.1;
  const PlaneField& field = r.charge.in_carrier;
  const double reach = r.tally.wall_map.grid().radius - smallest_radius(c);
  const double width = 2 * field.half() / PlaneField::cells;
  const auto middle = [&](int i) { return (i + 0.5) * width - field.half(); };
  double mass = 0;
  std::vector<double> found;
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i) {
      mass += field.density(i, j);
      if (math::hypot(middle(i), middle(j)) < reach) found.push_back(field.density(i, j));
    }
  if (!(mass > 0) || found.empty()) return undefined;
  const double even = mass / static_cast<double>(found.size());
  const auto full = std::ranges::count_if(found, [&](double d) { return d > bound * even; });
  return static_cast<double>(full) / static_cast<double>(found.size());
}

double across(const CollisionSums& sums) {
  return sums.energy_contact_point - sums.energy_normal;
}
double mean_across(const CollisionSums& sums) {
  return share(across(sums), static_cast<double>(sums.count));
}

/// Share of the counts at angles from 80 to 90 degrees.
double grazing(const observe::Angles& angles, std::int64_t count) {
  constexpr std::ptrdiff_t from = 80;
  const auto those = std::accumulate(angles.begin() + from, angles.end(), std::int64_t{0});
  return share(static_cast<double>(those), static_cast<double>(count));
}

}  // namespace

double root_mean_square_speed(const PlaneField& field) {
  double mass = 0, energy = 0;
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i) {
      mass += field.density(i, j);
      energy += field.kinetic_energy(i, j);
    }
  return mass > 0 ? std::sqrt(2 * energy / mass) : undefined;
}

double speed_in_jar(const Replicate& r) {
  return r.read_before ? r.read_before->speed_in_jar : root_mean_square_speed(r.charge.in_jar);
}

double speed_in_carrier(const Replicate& r) {
  return r.read_before ? r.read_before->speed_in_carrier
                       : root_mean_square_speed(r.charge.in_carrier);
}

Measures motion_measures() {
  return {
      {"occupied_share",
       "1",
       "share of the jar's cross-section within reach of balls' centres whose mean density is more "
       "than a tenth of that of a uniformly spread charge, in the carrier's frame",
       occupied_share,
       {.range = share_of_whole,
        .equation = "obs.9",
        .applies = has_regime,
        .only = "drums and planetary mills"}},
      {"ball_speed_seen_from_carrier",
       "m/s",
       "root mean square speed of the balls by mass, in a frame that moves with the jar's centre "
       "and rotates with its carrier",
       [](const Case&, const Replicate& r) { return speed_in_carrier(r); },
       {.label = "ball speed in the frame of the carrier", .symbol = "$v$"}},
      {"ball_speed_seen_from_jar",
       "m/s",
       "root mean square speed of the balls by mass, in the jar's frame",
       [](const Case&, const Replicate& r) { return speed_in_jar(r); },
       {.label = "ball speed in the frame of the jar", .symbol = "$v$"}},
      {"ball_spin",
       "rad/s",
       "root mean square angular velocity of the balls by mass, in the laboratory",
       [](const Case&, const Replicate& r) {
         return std::sqrt(share(r.charge.spin_squared, r.charge.mass_total));
       },
       {.label = "angular velocity of the balls", .symbol = "$ω$"}},
  };
}

Measures tangential_measures() {
  return {
      {"energy_tangential_mean",
       "J",
       "mean impact energy of the motion across the normal, m u_t^2/2, spin included",
       [](const Case&, const Replicate& r) { return mean_across(r.tally.all); },
       {.label = "mean tangential energy", .symbol = "$E_{t}$"}},
      {"energy_tangential_mean_above_threshold", "J",
       "mean impact energy of the motion across the normal, m u_t^2/2, spin included; collisions "
       "above the threshold",
       [](const Case&, const Replicate& r) { return mean_across(r.tally.above); }},
      {"tangential_impact_power", "W", "m u_t^2/2 of all collisions per second",
       [](const Case&, const Replicate& r) { return share(across(r.tally.all), r.time()); }},
      {"grazing_share",
       "1",
       "share of the collisions at 80 to 90 degrees from head-on",
       [](const Case&, const Replicate& r) {
         return grazing(r.tally.total_spectra().angle_all, r.tally.all.count);
       },
       {.range = share_of_whole}},
      {"grazing_share_above_threshold", "1",
       "share of the collisions at 80 to 90 degrees from head-on; collisions above the threshold",
       [](const Case&, const Replicate& r) {
         return grazing(r.tally.total_spectra().angle_above, r.tally.above.count);
       }},
  };
}

}  // namespace mahlwerk::results

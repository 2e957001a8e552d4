// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/wear.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/wear.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::PairStatistics;
constexpr double zero_celsius = 273.15;  // [K]

double wear_rate(const Case& c, double slid, double erosion, double vickers) {
  const double hardness = powder::hardness(vickers);
  return c.wear->model == cases::Wear::Model::archard
             ? powder::archard(c.wear->coefficient, slid, hardness)
             : c.wear->coefficient * erosion / hardness;  // (wea.4)
}

/// [m3/s] Wear of the balls of one set. Grains are powder and do not wear.
double set_wear_rate(const Case& c, const Replicate& r, int set) {
  const cases::BallSet& balls = c.balls[static_cast<std::size_t>(set)];
  if (balls.grains) return 0;
  double slid = 0, erosion = 0;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto [one, other] = pairs.kinds_of(pair);
    const int times = (one == set ? 1 : 0) + (other == set ? 1 : 0);  // both balls wear
    slid += times * pairs[pair].load_distance;
    erosion += times * pairs[pair].erosion;
  }
  return wear_rate(c, slid, erosion, balls.substance.hardness) / r.time();
}

/// [m3/s] Wear of one face of the jar, or of all faces for -1.
double face_wear_rate(const Case& c, const Replicate& r, int face) {
  double slid = 0, erosion = 0;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    if (!kinds.with_jar() || (face >= 0 && kinds.face() != face)) continue;
    slid += pairs[pair].load_distance;
    erosion += pairs[pair].erosion;
  }
  return wall_wear_rate(c, slid / r.time(), erosion / r.time());
}

double balls_wear(const Case& c, const Replicate& r) {
  double mass = 0;
  for (int set = 0; set < std::ssize(c.balls); ++set)
    mass += set_wear_rate(c, r, set) * c.balls[static_cast<std::size_t>(set)].surface_density();
  return mass;
}
double jar_wear(const Case& c, const Replicate& r) {
  return face_wear_rate(c, r, -1) * c.jar.density;
}

/// Temperatures at the end of the last milling period, for the replicate's dissipated power.
powder::HeatPoint at_the_end(const Case& c, const Replicate& r) {
  const powder::HeatNodes nodes = cases::heat_nodes(c, wall_area(*c.jar.shape));
  const powder::MillCycles mill = cases::mill_cycles(c, dissipated_power(r));
  const double end = (mill.milling + mill.pause) * static_cast<double>(mill.cycles) - mill.pause;
  powder::HeatPoint last;
  for (const powder::HeatPoint& p : powder::temperature_history(nodes, mill))
    if (p.time <= end * (1 + 1e-12)) last = p;
  return last;
}

}  // namespace

double wall_wear_rate(const Case& mill_case, double slid, double erosion) {
  return wear_rate(mill_case, slid, erosion, mill_case.jar.substance.hardness);
}

Measures wear_measures() {
  const auto wears = [](const Case& c) { return c.wear.has_value(); };
  const auto weighed_powder = [](const Case& c) { return c.powder && c.powder->mass > 0; };
  return where(wears, "with `[wear]`",
               {{"wear_rate_balls",
                 "kg/s",
                 "mass worn off all balls per second",
                 balls_wear,
                 {.heading = "Wear"}},
                {"wear_rate_jar", "kg/s", "mass worn off the jar per second", jar_wear},
                {"contamination_rate",
                 "ug/g/h",
                 "worn mass of balls and jar per mass of powder and hour of milling",
                 [](const Case& c, const Replicate& r) {
                   constexpr double hour = 3600;
                   return 1e6 * hour * (balls_wear(c, r) + jar_wear(c, r)) / c.powder->mass;
                 },
                 {.key = 11, .applies = weighed_powder, .only = "with `[powder]`"}}});
}

Table wear(const Outcome& outcome) {
  Table table{{{"body", "1", "a ball set, the jar or a face of it"},
               {"volume_rate", "m3/s", "volume worn off it per second"},
               {"mass_rate", "kg/s", "mass worn off it per second"}},
              {}};
  const Case& c = outcome.mill_case;
  const auto chosen = averaged_replicates(outcome);
  if (!c.wear || chosen.empty()) return table;
  const auto add = [&](const std::string& name, double density, const auto& of) {
    double volume = 0;
    for (const Replicate* r : chosen) volume += of(*r) / static_cast<double>(chosen.size());
    table.rows.push_back({table.columns[0].number_of(name), volume, volume * density});
  };
  const observe::StatisticsByPair& pairs = chosen.front()->tally.by_pair;
  for (int set = 0; set < pairs.kinds(); ++set)
    if (const auto i = static_cast<std::size_t>(set); !c.balls[i].grains)
      add(cases::set_name(c, i), c.balls[i].surface_density(),
          [&](const Replicate& r) { return set_wear_rate(c, r, set); });
  for (int pair = 0; pair < pairs.pairs(); ++pair)
    if (const auto kinds = pairs.kinds_of(pair); kinds.one == 0 && kinds.with_jar())
      add(pair_names(c, pairs, pair)[1], c.jar.density,
          [&](const Replicate& r) { return face_wear_rate(c, r, kinds.face()); });
  return table;
}

Measures heat_measures() {
  const auto warms = [](const Case& c) { return c.heat.has_value(); };
  return where(
      warms, "with `[heat]`",
      {
          {"temperature_balls",
           "degC",
           "temperature of the balls at the end of the last milling",
           [](const Case& c, const Replicate& r) { return at_the_end(c, r).balls - zero_celsius; },
           {.range = any_value, .heading = "Temperatures", .key = 8}},
          {"temperature_jar",
           "degC",
           "temperature of the jar at the end of the last milling",
           [](const Case& c, const Replicate& r) { return at_the_end(c, r).jar - zero_celsius; },
           {.range = any_value}},
          {"flash_rise_mean", "K",
           "mean flash temperature rise at the contact of a collision, weighted by the energy "
           "lost; an "
           "upper estimate, as the heat that powder takes is neglected",
           [](const Case&, const Replicate& r) {
             double rise = 0, lost = 0;
             for (int pair = 0; pair < r.tally.by_pair.pairs(); ++pair) {
               rise += r.tally.by_pair[pair].flash;
               lost += r.tally.by_pair[pair].spectra.energy_lost.sum();
             }
             return share(rise, lost);
           }},
      });
}

Table temperatures(const Outcome& outcome) {
  Table table{{{"time", "s", "time since the mill was first switched on"},
               {"balls", "degC", "temperature of the balls"},
               {"jar", "degC", "temperature of the jar"}},
              {}};
  const auto chosen = averaged_replicates(outcome);
  if (!outcome.mill_case.heat || chosen.empty()) return table;
  double power = 0;
  for (const Replicate* r : chosen)
    power += dissipated_power(*r) / static_cast<double>(chosen.size());
  const powder::HeatNodes nodes =
      cases::heat_nodes(outcome.mill_case, wall_area(*outcome.mill_case.jar.shape));
  for (const powder::HeatPoint& p :
       powder::temperature_history(nodes, cases::mill_cycles(outcome.mill_case, power)))
    table.rows.push_back({p.time, p.balls - zero_celsius, p.jar - zero_celsius});
  return table;
}

}  // namespace mahlwerk::results

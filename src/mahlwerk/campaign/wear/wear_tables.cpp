// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/wear/wear_tables.hpp"

#include <numeric>

#include "mahlwerk/powder/ball_charge.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::campaign {
namespace {

double number_of_balls(const powder::BallCharge& charge) {
  return std::accumulate(charge.begin(), charge.end(), 0.0,
                         [](double sum, const powder::Cohort& c) { return sum + c.number; });
}

/// [m3] and [1] of the balls of all sets.
struct BallTotals {
  double volume = 0, number = 0;
};
BallTotals totals_of(const WornState& state) {
  BallTotals t;
  for (const powder::BallCharge& charge : state.charges)
    t.volume += powder::volume_of(charge), t.number += number_of_balls(charge);
  return t;
}

void add_interval(results::Table& table, const char* name, const char* unit, const char* about) {
  table.columns.push_back({name, unit, about});
  table.columns.push_back({std::string(name) + "_ci95", unit, "its 95 % half-width"});
}

}  // namespace

results::Table wear_evolution_table(const WearEvolution& all) {
  results::Table table{{{"stage", "1", "of the folder stage-000, ..."},
                        {"time", "s", "of operation, at the begin of the stage"},
                        {"duration", "s", "of operation with the shapes of the stage"}},
                       {}};
  add_interval(table, "dissipated_power", "W", "of the run of the stage");
  add_interval(table, "drawn_power", "W", "of the run of the stage");
  add_interval(table, "wear_rate_balls", "kg/s", "mass worn off all balls per second");
  add_interval(table, "wear_rate_jar", "kg/s", "mass worn off the jar per second");
  add_interval(table, "wear_rate_parts", "kg/s", "mass worn off the parts per second");
  add_interval(table, "contamination_rate", "ug/g/h", "worn mass per mass of powder and hour");
  for (const char* name : {"lost_jar", "lost_parts", "lost_balls", "scrapped_balls", "added_balls"})
    table.columns.push_back({name, "m3", "volume since the start"});
  table.columns.push_back({"ball_volume", "m3", "of all balls"});
  table.columns.push_back({"ball_number", "1", "of all balls; a fraction where cohorts have one"});
  table.columns.push_back({"jar_diameter", "m", "of a round jar; empty for others"});
  for (const std::string& name : all.profiles)
    table.columns.push_back({"height_" + name, "m", "by which it stands out from the shell"});
  double stage = 0;
  for (const WearStage& s : all.stages) {
    std::vector<double> row{stage++, s.state.time, s.duration};
    for (const WearNumber& n : {s.dissipated_power, s.drawn_power, s.wear_rate_balls,
                                s.wear_rate_jar, s.wear_rate_parts, s.contamination_rate})
      row.insert(row.end(), {n.value, n.ci95});
    const LostVolumes& lost = s.state.lost;
    const BallTotals balls = totals_of(s.state);
    row.insert(row.end(),
               {lost.jar, lost.parts, lost.balls, lost.scrapped, lost.added, balls.volume,
                balls.number, s.state.diameter > 0 ? s.state.diameter : results::undefined});
    row.insert(row.end(), s.heights.begin(), s.heights.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

results::Table wear_profile_table(const WearEvolution& all) {
  results::Table table{{{"stage", "1", "of wear_evolution.csv"},
                        {"time", "s", "of operation"},
                        {"part", "1", "name of the part"},
                        {"x", "m", "corner of its section, from its own axis"},
                        {"y", "m", "corner of its section, from its own axis"},
                        {"depth_rate", "m/s", "wear of the side from this corner to the next"}},
                       {}};
  for (std::size_t i = 0; i < all.stages.size(); ++i)
    for (std::size_t k = 0; k < all.profiles.size(); ++k) {
      const geometry::Section& section = all.stages[i].state.sections[k];
      for (std::size_t p = 0; p < section.size(); ++p)
        table.rows.push_back({static_cast<double>(i), all.stages[i].state.time,
                              table.columns[2].number_of(all.profiles[k]), section[p].x,
                              section[p].y, all.stages[i].depth_rates[k][p]});
    }
  return table;
}

results::Table ball_sizes_table(const WearEvolution& all) {
  results::Table table{
      {{"stage", "1", "of wear_evolution.csv"},
       {"time", "s", "of operation"},
       {"set", "1", "ball set of the case"},
       {"diameter", "m", "of the balls of a cohort"},
       {"number", "1", "of balls, a fraction of one included"},
       {"mass_not_above", "1", "share of the mass of the set that is not above this diameter"},
       {"diameter_rate", "m/s", "loss of diameter per second of operation"}},
      {}};
  for (std::size_t i = 0; i < all.stages.size(); ++i)
    for (std::size_t s = 0; s < all.sets.size(); ++s) {
      const powder::BallCharge& charge = all.stages[i].state.charges[s];
      const double volume = powder::volume_of(charge);
      double left = volume;
      for (std::size_t k = 0; k < charge.size(); ++k) {
        const double d = charge[k].diameter;
        table.rows.push_back({static_cast<double>(i), all.stages[i].state.time,
                              table.columns[2].number_of(all.sets[s]), d, charge[k].number,
                              left / volume,
                              all.stages[i].ball_rates[s][k] * d / (3 * powder::sphere_volume(d))});
        left -= charge[k].volume();
      }
    }
  return table;
}

results::Table wear_spectra_table(const WearEvolution& all) {
  results::Table table{{{"stage", "1", "of wear_evolution.csv"},
                        {"time", "s", "of operation"},
                        {"energy_low", "J", "lower edge of the bin of normal energy"},
                        {"energy_high", "J", "upper edge"},
                        {"rate", "1/s", "collisions in the bin"}},
                       {}};
  for (std::size_t i = 0; i < all.stages.size(); ++i)
    for (std::size_t b = 0; b < all.stages[i].spectrum_rates.size(); ++b)
      table.rows.push_back(
          {static_cast<double>(i), all.stages[i].state.time, all.stages[i].spectrum_energies[b],
           all.stages[i].spectrum_energies[b + 1], all.stages[i].spectrum_rates[b]});
  return table;
}

std::vector<results::NamedTable> wear_tables(const WearEvolution& all) {
  std::vector<results::NamedTable> made{
      {"wear_evolution", "wear over the time of operation", wear_evolution_table(all)},
      {"wear_profile", "sections of bars and lifters", wear_profile_table(all)},
      {"wear_ball_sizes", "ball sizes over the time of operation", ball_sizes_table(all)},
      {"wear_spectra", "impact energies of the stages", wear_spectra_table(all)}};
  std::erase_if(made, [](const results::NamedTable& one) { return one.table.rows.empty(); });
  return made;
}

}  // namespace mahlwerk::campaign

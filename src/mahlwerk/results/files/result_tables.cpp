// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/result_tables.hpp"

#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/quantities/bed.hpp"
#include "mahlwerk/results/quantities/bodies.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/part_loads.hpp"
#include "mahlwerk/results/quantities/part_map.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {

Table motion_samples(const kinematics::Tabulated& motion) {
  Table table{{{"time", "s", "time of the sample"},
               {"x", "m", "x of the jar's centre in the laboratory"},
               {"y", "m", "y of the jar's centre, likewise"},
               {"z", "m", "z of the jar's centre, likewise"},
               {"angle", "rad", "angle of rotation of the jar"}},
              {}};
  for (const kinematics::Sample& s : motion.samples())
    table.rows.push_back({s.time, s.centre.x, s.centre.y, s.centre.z, s.angle});
  return table;
}

std::vector<NamedTable> tables(const Outcome& outcome) {
  std::vector<NamedTable> all{
      {"spectrum", "collisions and power per bin of energy", spectrum(outcome)},
      {"speeds", "collisions per bin of normal speed", speeds(outcome)},
      {"angles", "collisions per degree of impact angle", angles(outcome)},
      {"normal_tangential", "collisions per bin of normal and of tangential energy",
       normal_tangential(outcome)},
      {"timeseries", "the run in equal windows of its counted time", time_series(outcome)},
      {"replicates", "the quantities of each replicate", replicates(outcome)}};
  if (!outcome.summary.pairs.empty())
    all.push_back({"collisions_by_pair", "quantities by kind of pair",
                   collisions_by_pair(outcome.summary.pairs)});
  if (!outcome.summary.parts.empty())
    all.push_back({"parts", "force, torque, power and hits of each part in the jar",
                   parts_table(outcome.summary.parts)});
  const auto unless_empty = [&](std::string name, std::string about, Table table) {
    if (!table.rows.empty()) all.push_back({std::move(name), std::move(about), std::move(table)});
  };
  unless_empty("spectra_by_pair", "collisions and power per bin of energy, by kind of pair",
               spectra_by_pair(outcome));
  unless_empty("durations", "contacts per bin of duration", durations(outcome));
  unless_empty("flashes", "collisions per bin of flash temperature rise", flashes(outcome));
  unless_empty("body_hits", "hits of bodies per bin of energy, by where on the body",
               body_hits(outcome));
  unless_empty("wall_map", "hits and wear by cell of the jar's wall", wall_map(outcome));
  unless_empty("part_map", "hits and wear by cell of the parts in the jar", part_map(outcome));
  unless_empty("fields", "density and velocity of the charge", fields(outcome));
  unless_empty("bed", "density and velocity along the line through the bed of a drum",
               bed_table(outcome));
  for (const cases::Part* part : cases::parts_of(outcome.mill_case))
    if (part->tables != nullptr)
      for (NamedTable& one : part->tables(outcome))
        unless_empty(std::move(one.name), std::move(one.about), std::move(one.table));
  unless_empty("sizes", "the sizes of balls of each set", sizes(outcome.mill_case));
  if (const auto* measured = kinematics::as<kinematics::Tabulated>(*outcome.mill_case.mill.motion))
    all.push_back({"motion", "the measured motion of the jar", motion_samples(*measured)});
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i)
    if (const Replicate& r = outcome.replicates[i]; !r.balls_at_stop.empty())
      all.push_back({stopped_name(static_cast<int>(i)),
                     "the balls of a replicate at the time when physics stopped it",
                     balls_at_stop(r)});
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i)
    if (const Replicate& r = outcome.replicates[i]; !r.balls_at_end.empty())
      all.push_back({final_name(static_cast<int>(i)),
                     "the balls of a replicate at its end, for run.start_from", balls_at_end(r)});
  return all;
}

}  // namespace mahlwerk::results

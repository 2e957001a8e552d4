// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

// An outcome made by hand. All its numbers can be computed on paper.
namespace mahlwerk::results {

/// `hits` collisions of 2 g: every second one at u_n = 2 m/s and slip 2 m/s, the others at u_n =
/// 0.05 m/s without slip. Each loses 1 mJ.
inline std::vector<scene::Collision> fake_collisions(int hits) {
  std::vector<scene::Collision> list;
  for (int i = 0; i < hits; ++i) {
    const bool hard = i % 2 == 0;
    scene::Collision c;
    c.time = 0.01 * i;
    c.ball = 0;
    c.other = -1;
    c.where = {0.001 * i, -0.002, 0.003};
    c.normal = {0, 0, 1};
    c.mass = 0.002;
    c.approach = hard ? 2 : 0.05;
    c.slip = hard ? 2 : 0;
    c.glide = hard ? 1 : 0;
    c.impulse = 0.0038 * c.approach;
    c.lost_normal = 0.00075;
    c.lost_tangential = 0.00025;
    list.push_back(c);
  }
  return list;
}

/// Ten seconds with `hits` collisions, in two windows.
inline Replicate fake_replicate(int hits) {
  Replicate r(0.1);
  r.tally.collisions(fake_collisions(hits));
  const double lost = 0.001 * hits;
  r.at_settled.time = 1;
  r.at_settled.lost_normal = 5;
  r.energy_balance = r.at_settled;
  r.energy_balance.time = 11;
  r.energy_balance.lost_normal += lost;
  r.energy_balance.wall_work = 5 + lost;
  r.energy_balance.contact_time = 2;
  r.energy_balance.lasting_contacts = 4;
  r.energy_balance.collisions = hits;
  r.energy_balance.worst_collision = 1e-15 * hits;
  for (const double end : {5.0, 10.0})
    r.windows.push_back({.time = end,
                         .length = 5,
                         .collisions = 0.5 * hits,
                         .above = 0.25 * hits,
                         .energy_normal = 0.001 * hits,
                         .energy_contact_point = 0.002 * hits,
                         .lost = 0.5 * lost,
                         .wall_work = 0.5 * lost,
                         .contact_time = 1,
                         .kinetic = 0.003});
  return r;
}

/// The outcome of a run that has ended, with its summary.
inline Outcome ended(Outcome outcome) {
  outcome.summary = summarise(outcome);
  return outcome;
}

inline Outcome fake_outcome(const std::vector<int>& hits = {100, 120, 140}) {
  Outcome o;
  o.mill_case.title = "A <fake> case & more";
  o.mill_case.seed = 7;
  o.mill_case.mill.motion = kinematics::Vibration{};
  std::get<kinematics::Vibration>(*o.mill_case.mill.motion).frequency = 10;
  std::get<kinematics::Vibration>(*o.mill_case.mill.motion).amplitude = 0.025;
  o.mill_case.jar.shape = geometry::Capsule{0.012, 0.036};
  o.mill_case.balls = {{1, 0.008, 7850, ""}};
  o.mill_case.run.time = 10;
  o.mill_case.run.replicates = static_cast<std::int64_t>(hits.size());
  o.mill_case.observe.threshold = 0.1;
  o.mill_case.origins = {{"gravity", "9.81 m/s2", "default: on Earth", true, false},
                         {"jar.diameter", "12 mm", "catalogue jars/some", false, true}};
  for (const int n : hits) o.replicates.push_back(fake_replicate(n));
  o.cpu_seconds = 0.5;
  return ended(std::move(o));
}

}  // namespace mahlwerk::results

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

// Charges with sustained contacts, under the TC rule.
namespace mahlwerk::tests {

constexpr double t_c = 1e-4;  // [s]

inline std::unique_ptr<scene::Engine> lasting_engine(const scene::Chamber& mill,
                                                     const std::vector<scene::Ball>& balls,
                                                     const contact::BounceRule& rule,
                                                     double contact_time = t_c) {
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  rules.contact_time = contact_time;
  return event::many_balls(mill, balls, rules, {1, 6, rule});
}

/// n^3 balls of 1 mm fall in a box and come to rest. In other event-driven programs time stops
/// advancing here (inelastic collapse).
inline void check_settling(int n, double packing) {
  constexpr double d = 0.001;
  std::vector<scene::Ball> balls = lattice(n, packing);
  const double side = d * side_of(n, packing);
  for (scene::Ball& b : balls) b = {d / 2, 7850, d * b.position, 0.1 * b.velocity, {}};
  const scene::Chamber box{
      geometry::Box{side, side, side}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const auto run = lasting_engine(box, balls, {0.9, 0, 0.3});
  Counter counter;
  const double fall = run->energy_balance().potential;
  run->advance(0.15, counter);
  const std::int64_t falling = counter.count;
  run->advance(0.20, counter);
  const std::int64_t settled = counter.count - falling;
  run->advance(0.25, counter);
  const std::int64_t resting = counter.count - falling - settled;
  const scene::EnergyBalance a = run->energy_balance();
  const double rate = static_cast<double>(resting) / 0.05;
  stays_below("collisions of a ball in t_c", 2 * rate / n / n / n * t_c, 20,
              "man.4: bounces do not follow each other ever faster");
  stays_below("bounces at rest, later over earlier",
              static_cast<double>(resting) / static_cast<double>(settled), 1.5, "a steady state");
  stays_below("kinetic energy over that of the fall", a.kinetic / (fall - a.potential), 1e-3,
              "they have come to rest");
  stays_below("deepest overlap over R", deepest_overlap(run->balls()), 1e-12, "hard spheres");
  stays_below("balance", std::abs(a.residual()) / a.lost(), 1e-10,
              "man.5: no collision gains energy");
}

}  // namespace mahlwerk::tests

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/peers_physics.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "bench/peers.hpp"

namespace mahlwerk::bench::peers_physics_test {
namespace {

constexpr double step = 1e-6, disc = planetary_case.mill.speed, orbit = 0.07;

/// One dump frame in laboratory coordinates as LAMMPS writes it, with the balls in no order.
std::string moment(int at, const std::string& balls) {
  return fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\n"
      "ITEM: ATOMS id x y z vx vy vz fx fy fz omegax omegay omegaz tqx tqy tqz\n{}",
      at, balls);
}

Physics analysed(const std::string& dump, double from, double to) {
  Analysis analysis(from, to);
  DumpReader reader(2, step, analysis);
  std::istringstream in(dump);
  for (std::string line; std::getline(in, line);) reader.line(line);
  return analysis.physics();
}

TEST(PeersPhysics, two_balls_that_meet_touch_once_at_the_speed_their_gap_shrinks) {
  // At time 0 the vial is at (0.07, 0). The gap is 2 um, -1 um, 0.2 um and -0.4 um at successive
  // frames. The balls touch at 0.3 m/s and at 0.06 m/s; the second touch is too slow to be an
  // impact.
  const auto with_gap = [](int at, double gap) {
    const double t = at * step, x = orbit * std::cos(disc * t), y = orbit * std::sin(disc * t);
    const std::string rest = "0.01624 0 0 0 0 0 0 0 0 0 0 0 0";
    return moment(at, fmt::format("2 {:.9f} {:.9f} {}\n1 {:.9f} {:.9f} {}\n", x + 0.015 + gap, y,
                                  rest, x, y, rest));
  };
  const Physics found = analysed(
      with_gap(0, 2e-6) + with_gap(10, -1e-6) + with_gap(20, 0.2e-6) + with_gap(30, -0.4e-6), 0, 1);
  EXPECT_NEAR(found.ball_ball.all_rate, 2 / 30e-6, 1e-6);
  EXPECT_NEAR(found.ball_ball.rate, 1 / 30e-6, 1e-6);
  EXPECT_NEAR(found.ball_ball.speed, 0.3, 1e-3);
  // The outer ball's centre is 15 mm from the axis, but only 13.5 mm are free: it is always in
  // contact.
  EXPECT_EQ(found.ball_side.all_rate, 0);
}

TEST(PeersPhysics, a_ball_that_runs_into_the_side_is_an_impact_on_the_side) {
  const auto at_radius = [](int at, double radius) {
    const double t = at * step, x = orbit * std::cos(disc * t), y = orbit * std::sin(disc * t);
    const std::string rest = "0.01624 0 0 0 0 0 0 0 0 0 0 0 0";
    return moment(at, fmt::format("1 {:.9f} {:.9f} {}\n2 {:.9f} {:.9f} {}\n", x, y + radius, rest,
                                  x, y - 0.005, rest));
  };
  const Physics found = analysed(at_radius(0, 0.013495) + at_radius(10, 0.013505), 0, 1);
  EXPECT_NEAR(found.ball_side.rate, 1 / 10e-6, 1e-6);
  EXPECT_NEAR(found.ball_side.speed, 1.0, 1e-3);
  EXPECT_EQ(found.ball_ball.all_rate, 0);
}

TEST(PeersPhysics, power_is_what_force_and_torque_do_at_the_walls_own_motion) {
  // At time 0 the vial moves along y with disc * orbit and turns with -disc.
  const std::string dump =
      moment(0,
             "1 0.08 0 0.01624 0 3 0 2 5 0 0 0 100 0 0 0.01\n2 0.06 0 0.01624 0 0 0 0 0 0 0 0 0 "
             "0 0 0\n");
  const Physics found = analysed(dump, 0, 1);
  EXPECT_NEAR(found.power, disc * orbit * 5 - disc * (0.01 * 5 + 0.01), 1e-9);
  const double mass = 7700 * std::numbers::pi / 6 * std::pow(0.015, 3);
  EXPECT_NEAR(found.kinetic, 0.5 * mass * 9, 1e-12);
  EXPECT_NEAR(found.rotational, 0.5 * 0.4 * mass * 0.0075 * 0.0075 * 1e4, 1e-12);
  // Relative to the disc the first ball moves with 3 m/s less disc * 0.08 m, the second with
  // disc * 0.06 m.
  EXPECT_NEAR(found.kinetic_on_plate,
              0.5 * mass * (std::pow(3 - disc * 0.08, 2) + std::pow(disc * 0.06, 2)), 1e-12);
}

TEST(PeersPhysics, moments_outside_the_window_and_lines_that_break_off_do_not_count) {
  const auto moving = [](int at, double speed) {
    return moment(at, fmt::format("1 0 0 0 0 {} 0 0 0 0 0 0 0 0 0 0\n2 1 0 0 0 0 0 0 0 0 0 0 0 0 0 "
                                  "0\n",
                                  speed));
  };
  const std::string broken =
      "ITEM: TIMESTEP\n100010\nITEM: ATOMS id x\n1 0 0 0 0 9 0 0 0 0 0 0 0\n";
  const Physics found =
      analysed(moving(99990, 7) + moving(100000, 2) + broken + moving(200000, 7), 0.1, 0.15);
  const double mass = 7700 * std::numbers::pi / 6 * std::pow(0.015, 3);
  EXPECT_NEAR(found.kinetic, 0.5 * mass * 4, 1e-12);
}

}  // namespace
}  // namespace mahlwerk::bench::peers_physics_test

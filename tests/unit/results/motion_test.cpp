// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Spread and speed of charges made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::motion_test {
namespace {

constexpr double radius = 0.1, ball = 0.005;

Outcome drum() {
  Outcome outcome;
  cases::Case& c = outcome.mill_case;
  c.mill.motion = kinematics::Tumbling{2.0};
  c.mill.jar_axis = kinematics::Tumbling::jar_axis;
  c.jar.shape = geometry::Cylinder{2 * radius, 0.1};
  c.balls = {{1, 2 * ball, 7850, ""}};
  outcome.replicates.emplace_back(0.1, observe::BallKinds{},
                                  observe::WallGrid{.radius = radius, .bottom = -1, .top = 1});
  outcome.replicates[0].charge = observe::Charge(cases::chamber(c), radius);
  return outcome;
}

double value(const Outcome& outcome, const std::string& name) {
  std::vector<Measure> list = applying(motion_measures(), outcome.mill_case);
  for (const Measure& m : tangential_measures()) list.push_back(m);
  for (const Measure& m : list)
    if (m.name == name) return m.compute(outcome.mill_case, outcome.replicates[0]);
  throw std::out_of_range(name);
}

/// Samples a ball at `r` and `angle` in the drum's plane, at rest in the laboratory by default.
void look(Outcome& outcome, double time, double r, double angle, const Vec3& velocity = {}) {
  scene::Ball b = cases::starting_balls(outcome.mill_case, 0).front();
  const observe::Charge& charge = outcome.replicates[0].charge;
  b.position = r * (std::cos(angle) * charge.right() + std::sin(angle) * charge.up());
  b.velocity = velocity;
  outcome.replicates[0].charge.sample(time, {b}, 1);
}

TEST(Motion, an_even_charge_occupies_all_and_half_a_circle_of_it_half) {
  Outcome whole = drum(), half = drum();
  constexpr int rings = 200, around = 600;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double r = (radius - ball) * std::sqrt((i + 0.5) / rings);
      const double angle = 2 * std::numbers::pi * (k + 0.5) / around;
      look(whole, 0, r, angle);
      if (k < around / 2) look(half, 0, r, angle);
    }
  // Cells at the edge hold less: a ring a cell wide is 2 (200/48)/95 = 9 % of the area, and half of
  // it along a half. Cells cut by the edge hold only a part of what the others hold.
  EXPECT_NEAR(value(whole, "occupied_share"), 1, 0.01);
  EXPECT_NEAR(value(half, "occupied_share"), 0.5, 0.05);
}

TEST(Motion, a_ball_at_one_place_occupies_the_cells_it_is_shared_among) {
  Outcome outcome = drum();
  for (int i = 0; i < 10; ++i) look(outcome, i, 0.03, 1.0);
  // Cells with their middle within 95 mm: pi 95^2/(200/48)^2 = 1633, to a few per cent because the
  // rim cuts cells. The mass of the ball is distributed among four cells, each with more than a
  // tenth of 1/1633.
  const double share = value(outcome, "occupied_share");
  EXPECT_NEAR(share * 1633, 4, 0.2);
}

TEST(Motion, speeds_are_root_mean_squares_in_each_frame) {
  Outcome outcome = drum();
  look(outcome, 0, 0.05, 0, {0, 0, 3});
  look(outcome, 0, 0.05, 0, {0, 0, 4});
  EXPECT_NEAR(value(outcome, "ball_speed_seen_from_carrier"), std::sqrt(12.5), 1e-12);
  Outcome at_rest = drum();
  look(at_rest, 0, 0.05, 0.3);
  EXPECT_NEAR(value(at_rest, "ball_speed_seen_from_carrier"), 0, 1e-12);
  EXPECT_NEAR(value(at_rest, "ball_speed_seen_from_jar"), 2.0 * 0.05, 1e-12);
}

TEST(Motion, spin_is_the_root_mean_square_by_mass) {
  Outcome outcome = drum();
  scene::Ball b = cases::starting_balls(outcome.mill_case, 0).front();
  for (const double spin : {3.0, 4.0}) {
    b.spin = {0, spin, 0};
    outcome.replicates[0].charge.sample(0, {b}, 1);
  }
  EXPECT_NEAR(value(outcome, "ball_spin"), std::sqrt(12.5), 1e-12);
}

TEST(Motion, tangential_energy_and_grazing_are_those_of_the_collisions) {
  // Half of 100 collisions of 2 g have a slip of 2 m/s: 4 mJ each, at 45 degrees, in 10 s.
  const Outcome outcome = fake_outcome({100});
  EXPECT_NEAR(value(outcome, "energy_tangential_mean"), 0.002, 1e-15);
  EXPECT_NEAR(value(outcome, "energy_tangential_mean_above_threshold"), 0.004, 1e-15);
  EXPECT_NEAR(value(outcome, "tangential_impact_power"), 0.02, 1e-15);
  EXPECT_EQ(value(outcome, "grazing_share"), 0);
  Outcome grazing = fake_outcome({100});
  std::vector<scene::Collision> hits = fake_collisions(100);
  for (scene::Collision& c : hits) c.approach = 0.2, c.slip = 2;  // 84.3 degrees
  grazing.replicates[0] = Replicate(0.1);
  grazing.replicates[0].tally.collisions(hits);
  EXPECT_EQ(value(grazing, "grazing_share"), 1);
  EXPECT_EQ(value(grazing, "grazing_share_above_threshold"), 1);
}

TEST(Motion, nothing_was_seen_gives_no_number) {
  const Outcome outcome = drum();
  EXPECT_TRUE(std::isnan(value(outcome, "occupied_share")));
  EXPECT_TRUE(std::isnan(value(outcome, "ball_speed_seen_from_jar")));
  EXPECT_TRUE(std::isnan(value(outcome, "grazing_share")));
}

TEST(Motion, only_mills_with_a_regime_have_an_occupied_share) {
  for (const Measure& m : applying(motion_measures(), fake_outcome().mill_case))
    EXPECT_NE(m.name, "occupied_share");
}

}  // namespace
}  // namespace mahlwerk::results::motion_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Slope and profile of beds made by hand.
#include "mahlwerk/results/quantities/bed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

namespace mahlwerk::results::bed_test {
namespace {

using tests::states;

constexpr double radius = 0.12, surface = 0.03, still = 0.06, rate = 12, slope = 27;
constexpr double cell = 2 * radius / observe::PlaneField::cells;

/// A drum with a bed whose surface is `surface` below the axis and slopes by `slope` degrees. The
/// velocity along the surface is linear: zero at `still`, `rate` in each metre.
Outcome bed(double speed) {
  Outcome outcome;
  cases::Case& c = outcome.mill_case;
  c.mill.motion = kinematics::Tumbling{speed};
  c.mill.jar_axis = kinematics::Tumbling::jar_axis;
  c.jar.shape = geometry::Cylinder{2 * radius, 0.1};
  c.balls = {{1, 0.003, 2500, ""}};
  outcome.replicates.emplace_back(0.1, observe::BallKinds{},
                                  observe::WallGrid{.radius = radius, .bottom = -1, .top = 1});
  observe::Charge charge(cases::chamber(c), radius);
  const double sense = speed < 0 ? -1 : 1, angle = sense * slope * std::numbers::pi / 180;
  const Vec3 down = -std::cos(angle) * charge.up() + std::sin(angle) * charge.right();
  const Vec3 along = sense * (std::cos(angle) * charge.right() + std::sin(angle) * charge.up());
  std::vector<scene::Ball> balls;
  constexpr int fine = 300;
  for (int i = 0; i < fine; ++i)
    for (int k = -fine; k < fine; ++k) {
      const double s = surface + (radius - surface) * (i + 0.5) / fine;
      const double t = radius * (k + 0.5) / fine;
      if (std::hypot(s, t) > radius) continue;
      scene::Ball b = cases::starting_balls(c, 0).front();
      b.position = s * down + t * along;
      b.velocity = rate * (s - still) * along;
      balls.push_back(b);
    }
  charge.sample(0, balls, 1);
  outcome.replicates[0].charge = charge;
  return outcome;
}

double value(const Outcome& outcome, const std::string& name) {
  for (const Measure& m : applying(bed_measures(), outcome.mill_case))
    if (m.name == name) return m.compute(outcome.mill_case, outcome.replicates[0]);
  throw std::out_of_range(name);
}

TEST(Bed, angle_and_distance_are_those_of_the_segment_for_both_senses_of_rotation) {
  // Centroid of a circular segment: (2/3) R^3 sin^3(a) over its area R^2 (a - sin a cos a).
  const double a = std::acos(surface / radius);
  const double centroid =
      2.0 / 3 * radius * std::pow(std::sin(a), 3) / (a - std::sin(a) * std::cos(a));
  for (const double speed : {1.2, -1.2}) {
    const Outcome outcome = bed(speed);
    states("slope of the surface", value(outcome, "bed_angle"), slope, 0.05,
           "a lattice of 300 steps, cells at the wall clamped");
    states("centroid of the segment", value(outcome, "charge_distance"), centroid, 2e-4,
           "the same");
    states("lever arm", value(outcome, "charge_lever_arm"),
           centroid * std::sin(slope * std::numbers::pi / 180), 2e-4, "the same");
  }
}

TEST(Bed, the_surface_layer_ends_where_the_velocity_vanishes) {
  for (const double speed : {1.2, -1.2}) {
    const Outcome outcome = bed(speed);
    states("bottom of the layer", value(outcome, "surface_layer_bottom"), still, 1e-5,
           "a linear profile is interpolated exactly");
    states("surface", value(outcome, "surface_distance"), surface, 0.5 * cell, "half a cell");
    states("shear rate", value(outcome, "surface_shear_rate"), rate, 0.02 * rate,
           "a point uses masses up to two cells away: two of ten points know the surface");
    states("surface speed", value(outcome, "surface_speed"), rate * (still - surface), rate * cell,
           "one cell");
  }
}

TEST(Bed, a_charge_in_rigid_rotation_has_no_layer) {
  Outcome outcome = bed(1.2);
  std::vector<scene::Ball> balls = cases::starting_balls(outcome.mill_case, 0);
  observe::Charge charge(cases::chamber(outcome.mill_case), radius);
  balls.front().position = 0.08 * -charge.up();
  balls.front().velocity = 0.1 * charge.right();
  charge.sample(0, balls, 1);
  outcome.replicates[0].charge = charge;
  EXPECT_TRUE(std::isnan(value(outcome, "surface_layer_bottom")));
  EXPECT_TRUE(std::isnan(value(outcome, "surface_shear_rate")));
  EXPECT_NEAR(value(outcome, "bed_angle"), 0, 1e-9);
}

TEST(Bed, other_mills_have_the_height_of_their_charge) {
  Outcome outcome = bed(1.2);
  outcome.mill_case.mill.motion = kinematics::Vibration{};
  outcome.mill_case.mill.jar_axis = {0, 0, 1};
  outcome.mill_case.balls[0].count = 1000;
  ASSERT_EQ(applying(bed_measures(), outcome.mill_case).size(), 2U);
  EXPECT_LT(value(outcome, "charge_height"), 0);
  // Bottom at -1 m, 2 m above the top; a jar of 0.1 m height between them counts as that much
  // wider.
  const double half_depth = 0.5 * 1000 * std::numbers::pi / 6 * 27e-9 /
                            (0.6 * std::numbers::pi * radius * radius * 0.1 / 2);
  EXPECT_NEAR(value(outcome, "charge_rise"), value(outcome, "charge_height") + 1 - half_depth,
              1e-9);
  outcome.mill_case.mill.motion = kinematics::Planetary{};
  EXPECT_TRUE(applying(bed_measures(), outcome.mill_case).empty());
}

TEST(Bed, the_table_has_the_profile_of_the_replicates_with_intervals) {
  Outcome outcome = bed(1.2);
  outcome.replicates[0].energy_balance.time = 1;
  outcome.replicates.push_back(outcome.replicates[0]);
  const Table table = bed_table(outcome);
  ASSERT_EQ(table.rows.size(), 2U * observe::PlaneField::cells + 1);
  EXPECT_DOUBLE_EQ(table.rows.front()[0], -radius);
  EXPECT_DOUBLE_EQ(table.rows.back()[0], radius);
  EXPECT_NEAR(table.rows[68][2], rate * (table.rows[68][0] - still), 1e-6);
  EXPECT_NEAR(table.rows[68][3], 0, 1e-12);
}

}  // namespace
}  // namespace mahlwerk::results::bed_test

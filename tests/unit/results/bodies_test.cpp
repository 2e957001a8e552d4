// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Hits and axes of bodies that are no spheres, made by hand.
#include "mahlwerk/results/quantities/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::bodies_test {
namespace {

using scene::BodyFeature;

cases::BallSet set_of(cases::BallShape::Kind kind) {
  cases::BallSet set{1, 0.01, 7850, ""};
  set.body = {.kind = kind, .diameter = 0.01, .length = 0.01, .edge = 0.01, .rounding = 0.002};
  return set;
}

Outcome drum(const std::vector<cases::BallSet>& balls) {
  Outcome outcome;
  cases::Case& c = outcome.mill_case;
  c.mill.motion = kinematics::Tumbling{2.0};
  c.mill.jar_axis = kinematics::Tumbling::jar_axis;
  c.jar.shape = geometry::Cylinder{0.2, 0.1};
  c.balls = balls;
  outcome.replicates.push_back(fake_replicate(0));
  outcome.replicates[0].charge = observe::Charge(cases::chamber(c), 0.1, cases::sets_with_axis(c));
  return outcome;
}

double value(const Outcome& outcome, const std::string& name) {
  for (const Measure& m : applying(body_measures(), outcome.mill_case))
    if (m.name == name) return m.compute(outcome.mill_case, outcome.replicates[0]);
  throw std::out_of_range(name);
}

/// A cube falls on its edge, on its corner, and twice against the face of another by its edge.
std::vector<scene::Collision> hits() {
  std::vector<scene::Collision> list = fake_collisions(4);
  for (scene::Collision& c : list) c.approach = 1;
  list[0].mass = 0.002, list[0].feature = BodyFeature::edge;
  list[1].mass = 0.004, list[1].feature = BodyFeature::corner;
  for (const std::size_t k : {2U, 3U}) {
    list[k].other = 1, list[k].mass = 0.006;
    list[k].feature = BodyFeature::face, list[k].other_feature = BodyFeature::edge;
  }
  return list;
}

TEST(Bodies, shares_count_a_collision_of_two_bodies_for_each) {
  Outcome outcome = drum({set_of(cases::BallShape::Kind::cube)});
  outcome.replicates[0].tally.collisions(hits());
  // Six hits of 1, 2, 3, 3, 3, 3 mJ.
  EXPECT_DOUBLE_EQ(value(outcome, "face_hit_share"), 2.0 / 6);
  EXPECT_DOUBLE_EQ(value(outcome, "edge_hit_share"), 3.0 / 6);
  EXPECT_DOUBLE_EQ(value(outcome, "corner_hit_share"), 1.0 / 6);
  EXPECT_DOUBLE_EQ(value(outcome, "face_energy_share"), 6.0 / 15);
  EXPECT_DOUBLE_EQ(value(outcome, "edge_energy_share"), 7.0 / 15);
  EXPECT_DOUBLE_EQ(value(outcome, "corner_energy_share"), 2.0 / 15);
  EXPECT_THROW(value(outcome, "side_hit_share"), std::out_of_range) << "a cube has none";
}

TEST(Bodies, table_has_the_rates_and_powers_of_all_hits) {
  Outcome outcome = drum({set_of(cases::BallShape::Kind::cube)});
  outcome.replicates[0].tally.collisions(hits());
  const Table table = body_hits(outcome);
  std::vector<double> sums(table.columns.size());
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k) sums[k] += row[k];
  const std::vector<std::string> names{"energy_low", "energy_high", "rate_face",   "power_face",
                                       "rate_edge",  "power_edge",  "rate_corner", "power_corner"};
  ASSERT_EQ(table.columns.size(), names.size());
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(table.columns[k].name, names[k]);
  // Over ten seconds.
  const std::vector<double> expected{0.2, 6e-4, 0.3, 7e-4, 0.1, 2e-4};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(sums[k + 2], expected[k], 1e-15);
  EXPECT_TRUE(body_hits(drum({set_of(cases::BallShape::Kind::cube)})).rows.empty());
}

TEST(Bodies, shares_of_rods_are_those_of_side_and_cap) {
  Outcome outcome = drum({set_of(cases::BallShape::Kind::rod)});
  std::vector<scene::Collision> list = fake_collisions(4);
  for (scene::Collision& c : list) c.approach = 1, c.feature = BodyFeature::side;
  list[3].feature = BodyFeature::cap, list[3].mass *= 2;
  outcome.replicates[0].tally.collisions(list);
  EXPECT_DOUBLE_EQ(value(outcome, "side_hit_share"), 0.75);
  EXPECT_DOUBLE_EQ(value(outcome, "cap_hit_share"), 0.25);
  EXPECT_DOUBLE_EQ(value(outcome, "side_energy_share"), 0.6);
  EXPECT_DOUBLE_EQ(value(outcome, "cap_energy_share"), 0.4);
}

/// Rods along the axis of a drum, across it, and balls among them, which have no axis.
TEST(Bodies, axes_are_those_of_sets_with_an_axis) {
  Outcome outcome = drum({cases::BallSet{1, 0.01, 7850, ""}, set_of(cases::BallShape::Kind::rod)});
  const auto sample = [&](int along, int across) {
    std::vector<scene::Ball> balls(3, {0.005, 7850, {}, {}, {}});  // kind 0
    const Vec3 axis = outcome.mill_case.mill.jar_axis;
    for (int k = 0; k < along + across; ++k) {
      scene::Ball rod{0.005, 7850, {}, {}, {}, 1};
      const Vec3 z = k < along ? axis : Vec3{0, 0, 1};
      const Vec3 x = cross(Vec3{0.3, 0.8, 0.1}, z) / norm(cross(Vec3{0.3, 0.8, 0.1}, z));
      rod.orientation = quaternion_of({x, cross(z, x), z});
      balls.push_back(rod);
    }
    outcome.replicates[0].charge.sample(0, balls, 0.5);
  };
  sample(4, 0);
  EXPECT_NEAR(value(outcome, "nematic_order"), 1, 1e-12);
  EXPECT_NEAR(value(outcome, "body_axis_angle"), 0, 1e-5);
  sample(0, 4);  // half along x, half along another axis: <x^2> = 1/2
  EXPECT_NEAR(value(outcome, "nematic_order"), 0.25, 1e-12);
  EXPECT_NEAR(value(outcome, "body_axis_angle"), 45, 1e-5);
  EXPECT_TRUE(std::isnan(value(drum({set_of(cases::BallShape::Kind::rod)}), "nematic_order")));
}

}  // namespace
}  // namespace mahlwerk::results::bodies_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/collision_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "statement.hpp"

namespace mahlwerk::observe::collision_statistics_test {
namespace {

scene::Collision collision(double approach, double slip) {
  scene::Collision c;
  c.mass = 0.002;
  c.approach = approach;
  c.slip = slip;
  c.glide = 0.5 * slip;
  c.lost_normal = 1e-4;
  c.lost_tangential = 2e-4;
  return c;
}

TEST(ImpactAngle, is_the_arc_tangent) {
  double worst = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / 20000;
    const double approach = 3 * std::cos(angle), slip = 3 * std::sin(angle);
    worst = tests::max_or_nan(worst,
                              std::abs(impact_angle(approach, slip) - std::atan2(slip, approach)));
  }
  EXPECT_LT(worst, 2.1e-8);
  EXPECT_GT(worst, 0);
}

TEST(ImpactAngle, is_zero_head_on_and_a_right_angle_grazing) {
  EXPECT_EQ(impact_angle(1, 0), 0);
  EXPECT_EQ(impact_angle(0, 0), 0);
  EXPECT_DOUBLE_EQ(impact_angle(0, 1), std::numbers::pi / 2);
  EXPECT_NEAR(impact_angle(2, 2), std::numbers::pi / 4, 2e-8);
}

TEST(CollisionStatistics, adds_up_what_it_sees) {
  CollisionStatistics tally(0.1);
  const std::vector<scene::Collision> seen{collision(2, 0), collision(1, 1), collision(0.05, 0.1)};
  tally.collisions(seen);
  EXPECT_EQ(tally.all.count, 3);
  EXPECT_EQ(tally.above.count, 2);
  EXPECT_DOUBLE_EQ(tally.all.approach, 3.05);
  EXPECT_DOUBLE_EQ(tally.above.approach, 3);
  EXPECT_DOUBLE_EQ(tally.above.slip, 1);
  EXPECT_DOUBLE_EQ(tally.above.energy_normal, 0.001 * (4 + 1));
  EXPECT_DOUBLE_EQ(tally.above.energy_contact_point, 0.001 * (4 + 2));
  EXPECT_DOUBLE_EQ(tally.above.energy_centre, 0.001 * (4 + 1.25));
  EXPECT_DOUBLE_EQ(tally.all.lost, 9e-4);
  EXPECT_NEAR(tally.above.angle, std::numbers::pi / 4, 2e-8);
  EXPECT_EQ(tally.total_spectra().energy_normal.total(), 3);
  EXPECT_EQ(tally.total_spectra().approach.total(), 3);
  EXPECT_EQ(tally.total_spectra().angle_all[0], 1);
  EXPECT_EQ(tally.total_spectra().angle_all[63], 1);  // atan 2 is 63.4 degrees
  EXPECT_EQ(tally.total_spectra().angle_above[63], 0);
}

TEST(CollisionStatistics, the_threshold_itself_counts) {
  CollisionStatistics tally(0.1);
  tally.collisions(std::vector{collision(0.1, 0), collision(std::nextafter(0.1, 0), 0)});
  EXPECT_EQ(tally.above.count, 1);
}

TEST(CollisionStatistics, a_grazing_hit_is_in_the_last_degree) {
  CollisionStatistics tally(0);
  tally.collisions(std::vector{collision(0, 1)});
  EXPECT_EQ(tally.total_spectra().angle_all[angle_bins - 1], 1);
}

TEST(CollisionStatistics, chunks_do_not_matter) {
  std::vector<scene::Collision> seen;
  for (int i = 1; i < 500; ++i) seen.push_back(collision(0.003 * i, 0.7 / i));
  CollisionStatistics whole(0.1), pieces(0.1);
  whole.collisions(seen);
  for (const auto& c : seen) pieces.collisions(std::span(&c, 1));
  EXPECT_EQ(whole.above.count, pieces.above.count);
  EXPECT_EQ(whole.all.energy_centre, pieces.all.energy_centre);
  EXPECT_EQ(whole.total_spectra().angle_all, pieces.total_spectra().angle_all);
}

}  // namespace
}  // namespace mahlwerk::observe::collision_statistics_test

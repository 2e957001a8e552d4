// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Rows of the table in docs/theory/regimes.md: the word of a drum is that of Mellmann's map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/regime.hpp"

namespace mahlwerk::tests::regimes_test {
namespace {

constexpr double radius = 0.05, ball = 0.008, g = 9.81;  // [m], [m/s2]

/// A slice of a drum that turns at `share` of its critical speed, filled to J = 30 %, for a turn
/// (at most 2 s) and then for the counted time.
cases::Case drum(double share, double friction, double counted) {
  cases::Case c;
  const double speed = share * std::sqrt(g / (radius - 0.5 * ball));
  c.mill.motion = kinematics::Tumbling{speed};
  c.mill.jar_axis = kinematics::Tumbling::jar_axis;
  c.jar.shape = geometry::PeriodicCylinder{2 * radius, 0.018};
  c.jar.elastic = {20e6, 0.3};
  c.balls = {{95, ball, 7850, "", {20e6, 0.3}}};
  c.contact.rule = {.restitution = 0.5, .tangential_restitution = 0, .friction = friction};
  c.contact.rolling_friction = 0.01;
  c.run.engine = cases::EngineName::soft;
  c.run.settle_at_rest = 0.3;
  c.run.settle = std::min(2.0, 6.3 / speed);
  c.run.time = counted;
  c.run.replicates = 1;
  return c;
}

std::string word(const cases::Case& mill_case) {
  const results::Outcome outcome = campaign::run(mill_case);
  std::printf("    %s: %s\n", results::regime(outcome).c_str(),
              results::regime_reason(outcome).c_str());
  return results::regime(outcome);
}

TEST(Regimes, of_drums_are_those_of_mellmanns_map) {
  EXPECT_EQ(word(drum(0.2, 0.5, 2)), "cascading") << "F = 0.04, below 0.1";
  EXPECT_EQ(word(drum(0.8, 0.8, 1)), "cataracting") << "F = 0.64, between 0.1 and 1";
}

TEST(Regimes, of_a_drum_whose_wall_is_too_smooth_to_lift_the_bed_is_sliding_at_any_speed) {
  EXPECT_EQ(word(drum(0.2, 0.05, 2)), "sliding");
  EXPECT_EQ(word(drum(0.9, 0.05, 1)), "sliding");
}

TEST(Regimes, of_a_drum_that_turns_by_less_than_the_angle_of_repose_is_rigid) {
  cases::Case slow = drum(0.002, 0.6, 1);  // 1.7 degrees in the counted time
  slow.run.settle_at_rest = 0;
  slow.run.settle = 1;  // the balls fall and come to rest in the drum that turns
  EXPECT_EQ(word(slow), "rigid");
}

}  // namespace
}  // namespace mahlwerk::tests::regimes_test

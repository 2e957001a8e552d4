// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The replicates that stand for all in pictures.
#include "mahlwerk/report/representatives.hpp"

#include <gtest/gtest.h>

#include "unit/results/fake.hpp"

namespace mahlwerk::report::representatives_test {
namespace {

/// Replicates of one ball in a drum with F = 1.2, of whose mass these shares fly outside the bed,
/// with these powers.
results::Outcome drum(const std::vector<double>& flights, const std::vector<int>& powers) {
  results::Outcome o = results::fake_outcome(powers);
  kinematics::Tumbling motion;
  motion.speed = 15;
  o.mill_case.mill.motion = motion;
  o.mill_case.mill.jar_axis = kinematics::Tumbling::jar_axis;
  o.mill_case.jar.shape = geometry::Cylinder{0.116, 0.1};
  for (std::size_t i = 0; i < flights.size(); ++i) {
    results::Replicate& r = o.replicates[i];
    r.energy_balance.contact_time = r.at_settled.contact_time + 10 * (1 - flights[i]);
    r.tally.wall_map = observe::WallMap({.radius = 0.058, .bottom = -0.05, .top = 0.05});
    r.charge.mass_sought = 1;
    r.charge.mass_outside = flights[i];
  }
  o.summary = results::summarise(o);
  return o;
}

TEST(Representatives, of_one_state_are_the_median_replicate) {
  // Powers 140, 100, 120, 160: of an even number the lower of the middle two, the third replicate.
  const auto shown = representatives(drum({0.5, 0.5, 0.5, 0.5}, {140, 100, 120, 160}));
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].replicate, 2U);
  EXPECT_EQ(shown[0].words, "cataracting, replicate 3 of 4");
}

TEST(Representatives, of_two_regimes_are_one_of_each_the_frequent_one_first) {
  const auto shown = representatives(drum({0.01, 0.5, 0.01, 0.5, 0.5}, {100, 300, 101, 100, 200}));
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].words, "cataracting, 3 of 5 replicates");
  EXPECT_EQ(shown[0].replicate, 4U);  // 200 of 100, 200, 300
  EXPECT_EQ(shown[1].words, "cascading, 2 of 5 replicates");
  EXPECT_EQ(shown[1].replicate, 0U);
}

TEST(Representatives, of_two_groups_by_power_are_one_of_each_in_a_mill_without_regimes) {
  const auto shown = representatives(results::fake_outcome({101, 100, 300, 102, 301, 100, 299}));
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].words, "low power, 4 of 7 replicates");
  EXPECT_EQ(shown[0].replicate, 5U);  // 100, 100, 101, 102: the second
  EXPECT_EQ(shown[1].words, "high power, 3 of 7 replicates");
  EXPECT_EQ(shown[1].replicate, 2U);  // 300 of 299, 300, 301
}

TEST(Representatives, groups_that_differ_by_less_than_a_fifth_are_one) {
  EXPECT_EQ(
      representatives(results::fake_outcome({1010, 1000, 1150, 1020, 1151, 1005, 1149})).size(),
      1U);
}

TEST(Representatives, of_a_single_replicate_need_no_number) {
  const auto shown = representatives(results::fake_outcome({100}));
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].words, "");
}

}  // namespace
}  // namespace mahlwerk::report::representatives_test

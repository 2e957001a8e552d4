// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "noise.hpp"

namespace mahlwerk::measure::restitution_test {
namespace {

/// Times of the impacts of a ball that falls from `height` [m], first at `begin` [s].
std::vector<double> impacts(double height, double e, int count, double begin = 0.5) {
  std::vector<double> times{begin};
  double speed = std::sqrt(2 * standard_gravity * height);
  for (int i = 1; i < count; ++i) {
    speed *= e;
    times.push_back(times.back() + 2 * speed / standard_gravity);
  }
  return times;
}

TEST(Restitution, of_heights_is_the_root_of_their_ratio) {
  const Bounce bounce = bounce_of_heights(0.4, 0.1);
  EXPECT_DOUBLE_EQ(bounce.restitution, 0.5);
  EXPECT_DOUBLE_EQ(bounce.speed, std::sqrt(2 * standard_gravity * 0.4));
}

TEST(Restitution, of_times_is_the_ratio_of_flights) {
  const std::vector<Bounce> bounces = bounces_of_times(impacts(0.3, 0.7, 6), 0.3);
  ASSERT_EQ(bounces.size(), 5U);
  EXPECT_TRUE(bounces[0].first);
  for (const Bounce& one : bounces) EXPECT_NEAR(one.restitution, 0.7, 1e-12);
  EXPECT_NEAR(bounces[0].speed, std::sqrt(2 * standard_gravity * 0.3), 1e-12);
  EXPECT_NEAR(bounces[1].speed, 0.7 * bounces[0].speed, 1e-12);
  EXPECT_EQ(bounces_of_times(impacts(0.3, 0.7, 6)).size(), 4U) << "the first speed is not known";
}

TEST(Restitution, of_several_drops_in_one_recording_tells_them_apart) {
  std::vector<double> times = impacts(0.3, 0.6, 5);
  for (const double begin : {4.0, 8.0})
    for (const double t : impacts(0.3, 0.6, 5, begin)) times.push_back(t);
  const std::vector<Bounce> bounces = bounces_of_times(times, 0.3);
  EXPECT_EQ(bounces.size(), 12U);
  for (const Bounce& one : bounces) EXPECT_NEAR(one.restitution, 0.6, 1e-12);
  EXPECT_NEAR(restitution_of(bounces).list[0].value.mean, 0.6, 1e-12);
}

TEST(Restitution, leaves_out_the_last_flights_too_short_to_time) {
  for (const Bounce& one : bounces_of_times(impacts(0.01, 0.5, 20), 0.01))
    EXPECT_GT(one.restitution * one.speed * 2 / standard_gravity, 0.0199);
}

TEST(Restitution, has_an_interval_that_holds_the_truth_in_95_of_100_tests) {
  int held = 0;
  constexpr int tests = 400;
  for (int i = 0; i < tests; ++i) {
    mahlwerk::tests::Noise noise(static_cast<std::uint64_t>(i + 1), 0.03);
    std::vector<Bounce> bounces;
    for (int k = 0; k < 6; ++k) {
      const double e = 0.6 + noise();
      bounces.push_back(bounce_of_heights(0.3, e * e * 0.3));
    }
    const observe::Estimate found = restitution_of(bounces).list[0].value;
    held += std::abs(found.mean - 0.6) <= found.ci95;
  }
  EXPECT_GT(held, 0.92 * tests);
  EXPECT_LT(held, 0.98 * tests);
}

TEST(Restitution, that_depends_on_the_speed_is_remarked) {
  std::vector<Bounce> bounces;
  for (int i = 0; i < 10; ++i) bounces.push_back({i < 5 ? 1.0 : 3.0, i < 5 ? 0.8 : 0.7, false});
  for (int i = 0; i < 10; ++i) bounces[static_cast<std::size_t>(i)].restitution += 1e-3 * (i % 3);
  const Findings found = restitution_of(bounces);
  EXPECT_NE(found.remarks[1].find("depends on the speed"), std::string::npos);
}

TEST(Restitution, of_a_wrong_height_is_remarked) {
  std::vector<Bounce> bounces = bounces_of_times(impacts(0.3, 0.6, 6), 3);
  EXPECT_NE(restitution_of(bounces).remarks.back().find("check --height"), std::string::npos);
}

TEST(Restitution, that_cannot_be_is_refused) {
  EXPECT_THROW(restitution_of({{1, 0.5, false}, {1, 0.5, false}}), InputError);
  EXPECT_THROW(restitution_of({{1, 0.5, true}, {1, 1.2, true}, {1, 0.5, true}}), InputError);
  EXPECT_THROW(bounces_of_times({1, 2}), InputError);
  EXPECT_THROW(bounces_of_times({1, 1, 1}), InputError);
}

}  // namespace
}  // namespace mahlwerk::measure::restitution_test

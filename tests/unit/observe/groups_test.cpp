// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::groups_test {
namespace {

/// Normal numbers with standard deviation 1; the first `shifted` of them are increased by `by`.
std::vector<double> sample(std::uint32_t number, std::size_t size, std::size_t shifted = 0,
                           double by = 0) {
  Random random(77, number);
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i)
    values.push_back(std::sqrt(-2 * std::log(random.uniform())) *
                         std::cos(2 * std::numbers::pi * random.uniform()) +
                     (i < shifted ? by : 0));
  return values;
}

/// Number of `trials` samples in which two groups are found.
int seen(int trials, std::size_t size, std::size_t shifted, double by) {
  int count = 0;
  for (int i = 0; i < trials; ++i)
    count += two_groups(sample(static_cast<std::uint32_t>(i), size, shifted, by)) ? 1 : 0;
  return count;
}

TEST(TwoGroups, one_normal_distribution_is_split_as_often_as_the_level_says) {
  // 2000 samples at a level of 0.01: 20 expected, with a standard deviation of 4.45. The 1999
  // reference samples of the test add as large a deviation, the same for all samples of one size.
  constexpr int trials = 2000;
  constexpr double level = 0.01;
  const double deviation = std::sqrt(2 * trials * level * (1 - level));
  for (const std::size_t size : {4U, 5U, 10U, 20U})
    tests::states(
        "false alarms among " + std::to_string(trials) + " samples of " + std::to_string(size),
        seen(trials, size, 0, 0), trials * level, 3 * deviation,
        "level 0.01, three standard deviations");
}

TEST(TwoGroups, ten_standard_deviations_apart_are_found) {
  for (const std::size_t size : {10U, 20U}) {
    EXPECT_GE(seen(200, size, size / 2, 10), 195) << size;
    EXPECT_GE(seen(200, size, 3, 10), 180) << size;
  }
}

TEST(TwoGroups, their_bound_lies_between_them) {
  const std::vector<double> values = sample(1, 10, 4, 30);
  const auto found = two_groups(values);
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(values[i] > found->between, i < 4) << values[i];
  EXPECT_LE(found->p_value, 0.01);
  EXPECT_GE(found->p_value, 1.0 / 2000);
}

TEST(TwoGroups, unit_origin_and_order_do_not_matter) {
  std::vector<double> values = sample(1, 10, 4, 30);
  const auto found = two_groups(values);
  ASSERT_TRUE(found);
  for (double& v : values) v = 1e3 + 1e-3 * v;
  std::ranges::reverse(values);
  const auto other = two_groups(values);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->p_value, found->p_value);
  EXPECT_NEAR(other->between, 1e3 + 1e-3 * found->between, 1e-9);
}

TEST(TwoGroups, fewer_than_four_values_show_nothing) {
  EXPECT_FALSE(two_groups({}));
  EXPECT_FALSE(two_groups({1}));
  EXPECT_FALSE(two_groups({1, 100}));
  EXPECT_FALSE(two_groups({1, 1, 100}));
  EXPECT_TRUE(two_groups({1, 1, 100, 100})) << "equal within each group";
}

TEST(TwoGroups, equal_values_are_one_group) {
  EXPECT_FALSE(two_groups({3, 3, 3, 3, 3}));
  EXPECT_FALSE(two_groups({1, 1 + 1e-15, 1 - 1e-15, 1 + 2e-15})) << "equal except for rounding";
  EXPECT_FALSE(two_groups({0, 0, 0, 0}));
}

}  // namespace
}  // namespace mahlwerk::observe::groups_test

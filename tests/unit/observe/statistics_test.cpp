// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace mahlwerk::observe {
namespace {

TEST(Student95, IsThatOfThePrintedTables) {
  // Abramowitz & Stegun, table 26.10, and the same to more digits.
  const std::pair<int, double> printed[] = {
      {1, 12.70620474}, {2, 4.30265273},  {3, 3.18244631},  {4, 2.77644511},  {5, 2.57058184},
      {9, 2.26215716},  {10, 2.22813885}, {29, 2.04522964}, {30, 2.04227246}, {31, 2.03951345},
      {40, 2.02107539}, {60, 2.00029782}, {120, 1.97993041}};
  for (const auto& [freedom, t] : printed) EXPECT_NEAR(student95(freedom), t, 1e-6) << freedom;
  EXPECT_NEAR(student95(1000000), 1.95996636, 1e-7);
}

TEST(Student95, FallsAllTheWay) {
  for (int n = 1; n < 200; ++n) EXPECT_GT(student95(n), student95(n + 1)) << n;
}

TEST(Estimate, IsMeanAndStudentHalfWidth) {
  const Estimate e = estimate({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(e.mean, 3);
  EXPECT_NEAR(e.ci95, 2.77644511 * std::sqrt(2.5 / 5), 1e-7);
}

TEST(Estimate, OfOneReplicateKnowsNoWidth) {
  const Estimate e = estimate({7});
  EXPECT_EQ(e.mean, 7);
  EXPECT_TRUE(std::isnan(e.ci95));
}

TEST(Estimate, OfEqualValuesIsSharp) {
  const Estimate e = estimate({0.5, 0.5, 0.5, 0.5});
  EXPECT_EQ(e.mean, 0.5);
  EXPECT_EQ(e.ci95, 0);
  EXPECT_EQ(estimate({0.1, 0.1, 0.1}).ci95, 0) << "though a third of 0.1 is not exact";
}

}  // namespace
}  // namespace mahlwerk::observe

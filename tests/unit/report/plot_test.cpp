// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mahlwerk::report::plot_test {
namespace {

TEST(Interval, is_cut_at_the_range_of_the_axis_but_not_at_the_value) {
  const Axis share{.label = "", .range_least = 0, .range_most = 1};
  const Series errors{.name = "", .x = {1, 2, 3}, .y = {0.2, 0.9, -0.1}, .error = {0.3, 0.3, 0.3}};
  EXPECT_EQ(interval_at(errors, 0, share).low, 0);
  EXPECT_DOUBLE_EQ(interval_at(errors, 0, share).high, 0.5);
  EXPECT_EQ(interval_at(errors, 1, share).high, 1);
  EXPECT_EQ(interval_at(errors, 2, share).low, -0.1);  // the value itself is outside
  const Series ends{.name = "", .x = {1}, .y = {NAN}, .low = {-1}, .high = {2}};
  EXPECT_EQ(interval_at(ends, 0, share).low, 0);
  EXPECT_EQ(interval_at(ends, 0, share).high, 1);
  EXPECT_FALSE(interval_at(errors, 3, share).known());
}

}  // namespace
}  // namespace mahlwerk::report::plot_test

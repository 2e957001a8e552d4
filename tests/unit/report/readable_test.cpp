// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/text/readable.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mahlwerk::report::readable_test {
namespace {

TEST(Readable, an_interval_that_leaves_the_range_is_written_by_its_ends) {
  const results::Range positive{.least = 0}, share{0, 1};
  EXPECT_EQ(readable_within(0.23, 0.25, "m/s", positive).text(), "0.23 (0 to 0.48) m/s");
  EXPECT_EQ(readable_within(0.23, 0.25, "m/s", {}).text(), "0.23 ± 0.25 m/s");
  EXPECT_EQ(readable_within(0.167, 0.077, "1", share).text(), "0.167 ± 0.077");
  EXPECT_EQ(readable_within(0.95, 0.12, "1", share).text(), "0.95 (0.83 to 1)");
  EXPECT_EQ(readable_within(2e-3, 3e-3, "J", positive).text(), "2.0 (0 to 5.0) mJ");
  EXPECT_EQ(readable_within(1e-5, 1.8e-4, "1", share).text(), "[0.1 (0 to 1.9)] × 10⁻⁴");
  EXPECT_EQ(readable_within(0.5, NAN, "1", share).text(), readable(0.5, NAN, "1").text());
}

}  // namespace
}  // namespace mahlwerk::report::readable_test

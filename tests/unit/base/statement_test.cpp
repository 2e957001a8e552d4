// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "statement.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mahlwerk::tests::statement_test {
namespace {

TEST(Statement, the_larger_of_two_is_not_a_number_if_one_is) {
  EXPECT_EQ(max_or_nan(1.0, 2.0), 2);
  EXPECT_EQ(max_or_nan(2.0, 1.0), 2);
  EXPECT_TRUE(std::isnan(max_or_nan(0.0, std::nan(""))));
  EXPECT_TRUE(std::isnan(max_or_nan(std::nan(""), 0.0)));
}

}  // namespace
}  // namespace mahlwerk::tests::statement_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/trig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::trig_test {
namespace {

/// Largest error for |x| from 10^low to 10^high.
double largest_error(double low, double high) {
  Random random(1, 1);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = std::copysign(std::pow(10, random.uniform(low, high)), random.uniform(-1, 1));
    const SinCos found = sin_cos(x);
    const auto exact = static_cast<long double>(x);
    worst = std::max({worst, static_cast<double>(std::abs(found.sin - std::sin(exact))),
                      static_cast<double>(std::abs(found.cos - std::cos(exact)))});
  }
  return worst;
}

TEST(SinCos, is_within_a_rounding_of_one_of_the_true_values) {
  EXPECT_LT(largest_error(-8, 4), 2.3e-16) << "80-bit functions as reference";
}

TEST(SinCos, keeps_its_error_after_a_million_revolutions) {
  EXPECT_LT(largest_error(4, 9.33), 4e-16) << "80-bit functions as reference";
}

TEST(SinCos, keeps_the_corners_and_what_is_no_number) {
  EXPECT_EQ(sin_cos(0).sin, 0);
  EXPECT_EQ(sin_cos(0).cos, 1);
  EXPECT_EQ(sin_cos(1e10).sin, std::sin(1e10));
  EXPECT_TRUE(std::isnan(sin_cos(NAN).sin));
  EXPECT_TRUE(std::isnan(sin_cos(INFINITY).cos));
}

}  // namespace
}  // namespace mahlwerk::trig_test

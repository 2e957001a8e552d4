// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::observe::histogram_test {
namespace {

TEST(LogHistogram, every_edge_opens_its_own_bin) {
  for (int bin = 1; bin < LogHistogram::bins; ++bin) {
    const double edge = LogHistogram::lower(bin);
    EXPECT_EQ(LogHistogram::bin_of(edge), bin);
    EXPECT_EQ(LogHistogram::bin_of(std::nextafter(edge, 0)), bin - 1);
  }
}

TEST(LogHistogram, edges_are_quarters_of_an_octave) {
  for (int bin = 0; bin < LogHistogram::bins; ++bin)
    EXPECT_NEAR(std::log2(LogHistogram::lower(bin)), 0.25 * bin + LogHistogram::lowest_octave,
                1e-13);
}

TEST(LogHistogram, what_lies_beyond_the_ends_is_not_lost) {
  EXPECT_EQ(LogHistogram::bin_of(0), 0);
  EXPECT_EQ(LogHistogram::bin_of(-0.0), 0);
  EXPECT_EQ(LogHistogram::bin_of(-1e-20), 0);  // a loss that rounding made negative
  EXPECT_EQ(LogHistogram::bin_of(5e-324), 0);
  EXPECT_EQ(LogHistogram::bin_of(1e300), LogHistogram::bins - 1);
  EXPECT_EQ(LogHistogram::bin_of(INFINITY), LogHistogram::bins - 1);
}

/// Losses of a contact law that gains energy are negative, and as large as others.
TEST(LogHistogram, the_first_bin_sums_what_is_not_above_zero) {
  LogHistogram h;
  for (const double value : {-100.0, -3.5, 0.0, 0.25}) h.add(value);
  h.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(h.count(0), 3);
  EXPECT_EQ(h.sum(0), -103.5);
  EXPECT_EQ(h.total(), 5);
  EXPECT_EQ(h.sum(), -103.25);
}

TEST(LogHistogram, bins_are_those_of_the_logarithm) {
  Random random(1, 0);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::exp2(random.uniform(-70, 30));
    const double place = 4 * (std::log2(value) - LogHistogram::lowest_octave);
    if (std::abs(place - std::round(place)) < 1e-9) continue;
    ASSERT_EQ(LogHistogram::bin_of(value), static_cast<int>(std::floor(place))) << value;
  }
}

TEST(LogHistogram, merging_is_exact) {
  LogHistogram one, two, both;
  Random random(2, 0);
  for (int i = 0; i < 10000; ++i) {
    const double value =
        std::ldexp(std::floor(random.uniform(0, 1024)), -12);  // sums without rounding
    (i % 3 == 0 ? one : two).add(value);
    both.add(value);
  }
  one.merge(two);
  EXPECT_EQ(one.total(), 10000);
  for (int bin = 0; bin < LogHistogram::bins; ++bin) {
    EXPECT_EQ(one.count(bin), both.count(bin));
    EXPECT_EQ(one.sum(bin), both.sum(bin));
  }
}

TEST(LogHistogram, knows_which_bins_are_filled) {
  LogHistogram h;
  EXPECT_EQ(h.occupied_range(), (std::array<int, 2>{0, 0}));
  h.add(1);
  h.add(4.1);
  const int of_one = -LogHistogram::lowest_octave * LogHistogram::per_octave;
  EXPECT_EQ(h.occupied_range(), (std::array<int, 2>{of_one, of_one + 9}));
  EXPECT_EQ(h.count(of_one + 8), 1);
  EXPECT_EQ(h.sum(of_one + 8), 4.1);
}

}  // namespace
}  // namespace mahlwerk::observe::histogram_test

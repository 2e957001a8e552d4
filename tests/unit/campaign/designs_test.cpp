// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/points/designs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::designs_test {
namespace {

using tests::states;
using tests::stays_below;

/// Number of rows with `key` in each of `parts` equal parts of its range.
std::vector<int> met(const DesignMatrix& rows, std::size_t key, std::size_t parts) {
  std::vector<int> count(parts);
  for (const auto& row : rows)
    ++count[static_cast<std::size_t>(row[key] * static_cast<double>(parts))];
  return count;
}

/// Squared L2 star discrepancy: the mean square difference between the share of rows in a box at
/// the corner 0 and the volume of the box (Warnock 1972).
double unevenness(const DesignMatrix& rows) {
  const auto n = static_cast<double>(rows.size());
  const auto keys = static_cast<double>(rows.front().size());
  double volumes = 0, pairs = 0;
  for (const auto& a : rows) {
    double volume = 1;
    for (const double x : a) volume *= (1 - x * x) / 2;
    volumes += volume;
    for (const auto& b : rows) {
      double shared = 1;
      for (std::size_t i = 0; i < a.size(); ++i) shared *= 1 - std::max(a[i], b[i]);
      pairs += shared;
    }
  }
  return std::pow(3, -keys) - 2 * volumes / n + pairs / n / n;
}

/// Mean squared discrepancy of random rows: (2^-k - 3^-k)/n, from the integral over one row.
double random_unevenness(std::size_t keys, std::size_t n) {
  const auto k = static_cast<double>(keys);
  return (std::pow(2, -k) - std::pow(3, -k)) / static_cast<double>(n);
}

template <class Design>
void begins_alike(const Design& design, std::size_t few, std::size_t many, std::size_t rows_each) {
  const DesignMatrix short_one = design(few), long_one = design(many);
  ASSERT_EQ(short_one.size(), few * rows_each);
  ASSERT_EQ(long_one.size(), many * rows_each);
  EXPECT_TRUE(std::equal(short_one.begin(), short_one.end(), long_one.begin()));
}

TEST(LatinHypercube, meets_each_part_of_each_range_once) {
  for (const std::size_t samples : {1U, 2U, 7U, 100U}) {
    const DesignMatrix rows = latin_hypercube(5, samples, 3);
    ASSERT_EQ(rows.size(), samples);
    for (std::size_t key = 0; key < 5; ++key)
      EXPECT_EQ(met(rows, key, samples), std::vector<int>(samples, 1));
  }
}

TEST(LatinHypercube, pairs_parts_of_two_keys_at_random) {
  // The correlation of two independent orders of n has the variance 1/(n - 1).
  constexpr std::size_t n = 1000;
  const DesignMatrix rows = latin_hypercube(3, n, 1);
  for (const auto& [i, k] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    double sum = 0;
    for (const auto& row : rows)
      sum +=
          12 * (row[static_cast<std::size_t>(i)] - 0.5) * (row[static_cast<std::size_t>(k)] - 0.5);
    states("correlation", sum / n, 0, 3.3 / std::sqrt(n - 1), "3.3 standard deviations");
  }
  EXPECT_NE(latin_hypercube(3, n, 1), latin_hypercube(3, n, 2));
  EXPECT_EQ(latin_hypercube(3, n, 1), latin_hypercube(3, n, 1));
}

TEST(SobolPoints, are_those_of_joe_and_kuo) {
  // The first rows of new-joe-kuo-6.21201, in Gray-code order.
  const DesignMatrix expected{{0.5, 0.5, 0.5},       {0.75, 0.25, 0.25},    {0.25, 0.75, 0.75},
                              {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125}, {0.625, 0.125, 0.875},
                              {0.125, 0.625, 0.375}};
  EXPECT_EQ(sobol_points(3, 7), expected);
}

TEST(SobolPoints, leave_out_only_the_part_of_the_corner) {
  const DesignMatrix rows = sobol_points(40, 255);
  std::vector<int> once(256, 1);
  once.front() = 0;
  for (std::size_t key = 0; key < 40; ++key) EXPECT_EQ(met(rows, key, 256), once);
}

TEST(SobolPoints, lie_more_evenly_than_random_ones) {
  for (const std::size_t keys : {1U, 2U, 5U, 8U})
    for (const std::size_t n : {16U, 40U, 256U})
      stays_below("unevenness, share of that of random rows",
                  unevenness(sobol_points(keys, n)) / random_unevenness(keys, n), 0.6,
                  "Warnock's sum");
}

TEST(RandomPoints, are_as_uneven_as_they_should) {  // checks the reference above
  double sum = 0, square = 0;
  constexpr int times = 200;
  for (std::uint32_t t = 0; t < times; ++t) {
    Random random(7, t);
    DesignMatrix rows(40, std::vector<double>(3));
    for (auto& row : rows)
      for (double& x : row) x = random.uniform();
    const double u = unevenness(rows);
    sum += u;
    square += u * u;
  }
  const double mean = sum / times, spread = std::sqrt((square / times - mean * mean) / times);
  states("unevenness", mean, random_unevenness(3, 40), 3.3 * spread, "3.3 standard deviations");
}

TEST(OneAtATime, moves_one_key_to_both_ends) {
  const DesignMatrix expected{{0.5, 0.5}, {0, 0.5}, {1, 0.5}, {0.5, 0}, {0.5, 1}};
  EXPECT_EQ(one_at_a_time_design(2), expected);
  EXPECT_EQ(one_at_a_time_design(2, 0.25).front(), (std::vector{0.25, 0.25}));
}

TEST(MorrisDesign, moves_each_key_once_a_way_by_two_thirds) {
  constexpr std::size_t keys = 6, ways = 50;
  const DesignMatrix rows = morris_design(keys, ways, 5);
  ASSERT_EQ(rows.size(), ways * (keys + 1));
  for (std::size_t way = 0; way < ways; ++way) {
    std::vector<int> moved(keys);
    for (std::size_t i = way * (keys + 1); i + 1 < (way + 1) * (keys + 1); ++i)
      for (std::size_t key = 0; key < keys; ++key) {
        const double step = std::abs(rows[i + 1][key] - rows[i][key]);
        if (step == 0) continue;
        ++moved[key];
        EXPECT_NEAR(step, 2.0 / 3, 1e-15);
      }
    EXPECT_EQ(moved, std::vector<int>(keys, 1));
  }
  for (const auto& row : rows)
    for (const double x : row) EXPECT_EQ(x, std::round(3 * x) / 3);
}

TEST(MorrisDesign, begins_at_all_levels_and_moves_keys_in_any_order) {
  constexpr std::size_t keys = 4, ways = 2000;
  const DesignMatrix rows = morris_design(keys, ways, 1);
  const double tolerance =
      3.5 * std::sqrt(ways * 0.25 * 0.75);  // 32 counts: 1.5 % chance of a false alarm
  for (std::size_t key = 0; key < keys; ++key) {
    std::vector<int> level(4), turn(keys);
    for (std::size_t i = 0; i < rows.size(); i += keys + 1) {
      ++level[static_cast<std::size_t>(std::lround(3 * rows[i][key]))];
      std::size_t step = 0;
      while (rows[i + step][key] == rows[i + step + 1][key]) ++step;
      ++turn[step];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      states("ways that begin at a level", level[k], ways / 4.0, tolerance, "binomial");
      states("ways that move a key at a turn", turn[k], ways / 4.0, tolerance, "binomial");
    }
  }
}

TEST(SaltelliDesign, takes_one_key_from_the_other_half) {
  constexpr std::size_t keys = 3, base = 16;
  const DesignMatrix rows = saltelli_design(keys, base);
  ASSERT_EQ(rows.size(), base * (keys + 2));
  for (std::size_t j = 0; j < base; ++j) {
    const auto group = rows.begin() + static_cast<std::ptrdiff_t>(j * (keys + 2));
    const auto &a = group[0], &b = group[keys + 1];
    for (std::size_t key = 0; key < keys; ++key) {
      std::vector<double> mixed = a;
      mixed[key] = b[key];
      EXPECT_EQ(group[static_cast<std::ptrdiff_t>(key) + 1], mixed);
      EXPECT_NE(a[key], b[key]);
    }
  }
}

TEST(SaltelliDesign, spreads_both_halves_evenly) {
  constexpr std::size_t keys = 20, base = 64;
  const DesignMatrix rows = saltelli_design(keys, base, 9);
  DesignMatrix a, b;
  for (std::size_t i = 0; i < rows.size(); i += keys + 2) {
    a.push_back(rows[i]);
    b.push_back(rows[i + keys + 1]);
  }
  for (std::size_t key = 0; key < keys; ++key) {
    EXPECT_EQ(met(a, key, base), std::vector<int>(base, 1));
    EXPECT_EQ(met(b, key, base), std::vector<int>(base, 1));
  }
  EXPECT_NE(rows, saltelli_design(keys, base, 10));
}

TEST(Designs, begin_alike_when_they_are_made_longer) {
  begins_alike([](std::size_t n) { return sobol_points(4, n); }, 5, 50, 1);
  begins_alike([](std::size_t n) { return morris_design(4, n, 2); }, 5, 50, 5);
  begins_alike([](std::size_t n) { return saltelli_design(4, n); }, 5, 50, 6);
}

TEST(Designs, say_when_there_are_too_many_keys) {
  EXPECT_THROW(sobol_points(3668, 1), std::invalid_argument);
  EXPECT_THROW(saltelli_design(1834, 1), std::invalid_argument);
  EXPECT_EQ(sobol_points(3667, 1).front().size(), 3667U);
}

}  // namespace
}  // namespace mahlwerk::campaign::designs_test

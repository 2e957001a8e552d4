// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities over time.
#include "mahlwerk/results/quantities/series.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/results/quantities/tables.hpp"
#include "statement.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::series_test {
namespace {

using tests::states;

TEST(Series, the_settling_time_is_that_of_the_windows_before_the_power_is_even) {
  constexpr int begin = 20, all = 100;
  Outcome o = fake_outcome({100, 120});
  for (Replicate& r : o.replicates) {
    r.windows.clear();
    for (int i = 0; i < all; ++i) {
      const double even = i % 2 == 0 ? 1.01 : 0.99;
      r.windows.push_back(
          {.time = 0.1 * (i + 1), .length = 0.1, .lost = 0.1 * (i < begin ? 5 : even)});
    }
  }
  states("settling time [s]", named(summarise(o).quantities, "settling_time").value, 0.1 * begin,
         1e-12, "MSER-5 leaves out whole batches of five: four of them");
}

TEST(Series, of_replicates_that_end_at_different_times_are_means_over_those_that_still_run) {
  Outcome o = fake_outcome({100, 120});
  o.replicates[1].windows.push_back({.time = 15,
                                     .length = 5,
                                     .collisions = 50,
                                     .above = 20,
                                     .energy_normal = 2,
                                     .lost = 3,
                                     .wall_work = 4,
                                     .contact_time = 0.5,
                                     .kinetic = 7});
  const Table table = time_series(o);
  ASSERT_EQ(table.rows.size(), 3U);
  const std::vector<double> second{10, (50 + 60) / 2.0 / 5, (25 + 30) / 2.0 / 5},
      third{15, 10, 4, 2.0 / 50, 0.6, 0.8, 0.1, 7};
  for (std::size_t i = 0; i < second.size(); ++i) EXPECT_NEAR(table.rows[1][i], second[i], 1e-12);
  for (std::size_t i = 0; i < third.size(); ++i) EXPECT_NEAR(table.rows[2][i], third[i], 1e-12);
}

TEST(Series, have_the_value_of_each_window) {
  const std::vector<Window> windows{
      {.length = 2, .collisions = 8, .above = 4, .energy_normal = 24, .lost = 6, .wall_work = 10}};
  EXPECT_EQ(series(windows, "dissipated_power"), std::vector<double>{3});
  EXPECT_EQ(series(windows, "drawn_power"), std::vector<double>{5});
  EXPECT_EQ(series(windows, "collision_rate"), std::vector<double>{4});
  EXPECT_EQ(series(windows, "collision_rate_above_threshold"), std::vector<double>{2});
  EXPECT_EQ(series(windows, "energy_normal_mean"), std::vector<double>{3});
  EXPECT_TRUE(series(windows, "flight_share").empty());
}

}  // namespace
}  // namespace mahlwerk::results::series_test

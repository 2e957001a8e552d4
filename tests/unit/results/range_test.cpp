// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Ranges of quantities.
#include "mahlwerk/results/quantities/range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace mahlwerk::results::range_test {
namespace {

/// Names in backticks in the first column of the table of summary.json in docs/formats.md.
std::set<std::string> documented_quantities() {
  std::ifstream docs(std::filesystem::path(MAHLWERK_HOME) / "docs" / "formats.md");
  std::set<std::string> names;
  std::string line, first;
  for (bool inside = false; std::getline(docs, line);) {
    if (line.starts_with("| name | unit")) inside = true;
    if (inside && line.empty()) break;
    if (!inside || !line.starts_with("| `")) continue;
    const std::string cell = line.substr(0, line.find('|', 1));
    for (std::size_t at = cell.find('`'); at != std::string::npos;) {
      const std::size_t end = cell.find('`', at + 1);
      std::string name = cell.substr(at + 1, end - at - 1);
      if (name.starts_with('_')) name = "dissipated_power" + name;  // `_tangential` of a list
      names.insert(name);
      at = cell.find('`', end + 1);
    }
  }
  return names;
}

TEST(Ranges, are_known_for_every_documented_quantity_that_is_not_signed) {
  const std::set<std::string> is_unbounded{
      "power_imbalance", "toe_angle", "shoulder_angle", "temperature_balls", "temperature_jar",
      "thermocouple_reading", "property", "bed_angle", "charge_lever_arm", "surface_distance",
      "surface_layer_bottom", "surface_speed", "surface_shear_rate", "charge_height", "charge_rise",
      // a difference of two powers; numbers without an interval
      "dissipated_power_of_lasting_contacts", "settling_time", "replicates"};
  const std::set<std::string> names = documented_quantities();
  EXPECT_GT(names.size(), 60U);
  for (const std::string& name : names) {
    const Range range = range_of(name);
    EXPECT_EQ(std::isinf(range.least), is_unbounded.contains(name)) << name;
    EXPECT_TRUE(std::isinf(range.least) || range.least == 0) << name;
  }
}

TEST(Ranges, of_shares_end_at_one_and_thresholds_change_none) {
  EXPECT_EQ(range_of("flight_share").most, 1);
  EXPECT_EQ(range_of("grazing_share_above_threshold").most, 1);
  EXPECT_EQ(range_of("impact_angle_mean").most, 90);
  EXPECT_TRUE(std::isinf(range_of("withheld_power_share").most));  // over another power
  EXPECT_EQ(range_of("collision_rate_above_threshold").least, 0);
  EXPECT_TRUE(std::isinf(range_of("no_such_quantity").least));
}

}  // namespace
}  // namespace mahlwerk::results::range_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Disk that a run needs, known before it starts.
#include "mahlwerk/campaign/run/forecast.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::campaign::forecast_test {
namespace {

cases::Case shaken(double time) {
  cases::Case c;
  kinematics::Vibration motion;
  motion.frequency = 25;
  motion.amplitude = 5e-3;
  c.mill.motion = motion;
  c.jar.shape = geometry::Cylinder{0.03, 0.03};
  c.balls = {{1, 8e-3, 7850, ""}};
  c.run.engine = cases::EngineName::event;
  c.run.time = time;
  c.run.replicates = 4;
  return c;
}

TEST(Disk, needed_is_that_of_records_and_frames_of_all_replicates) {
  cases::Case c = shaken(10);
  const double plain = disk_needed(c, 200);
  EXPECT_EQ(plain, disk_needed(c, 0)) << "without records";
  c.observe.collisions = true;
  const double records = disk_needed(c, 200) - plain;
  EXPECT_NEAR(records, 4 * 10 * 200 * 100, 1);  // 100 bytes of each, docs/formats.md
  c.observe.collisions = false;
  c.observe.frames = 0.1;
  EXPECT_NEAR(disk_needed(c, 200) - plain, 4 * 100 * cases::frame_bytes(c), 1);
}

TEST(Disk, that_does_not_suffice_is_told_with_a_time_that_fits) {
  cases::Case c = shaken(1e7);
  EXPECT_TRUE(disk_faults({c}, 150, 1).empty()) << "tables do not grow with the time";
  c.observe.collisions = true;  // 4 replicates of 150 GB
  EXPECT_TRUE(disk_faults({shaken(1)}, 150, std::nullopt).empty());
  const Fault fault = disk_faults({c}, 150, 60e9).at(0);
  EXPECT_EQ(fault.code, "not-enough-disk");
  EXPECT_NE(fault.what.find("600 GB"), std::string::npos) << fault.what;
  EXPECT_NE(fault.what.find("60 GB are free"), std::string::npos) << fault.what;
  EXPECT_NE(fault.remedy.find("750000 s"), std::string::npos) << fault.remedy;
  c.run.time = 7.5e5;
  EXPECT_TRUE(disk_faults({c}, 150, 60e9).empty()) << "what the remedy says fits";
  c.run.time = 1e7;
  EXPECT_NE(disk_faults({c}, 150, 1e15).at(0).what.find("more than 50 GB"), std::string::npos)
      << "a mistake on the largest disk, too";
}

TEST(Disk, available_is_that_of_the_nearest_folder_that_exists) {
  const auto here = std::filesystem::temp_directory_path();
  const auto free = disk_available(here), below = disk_available(here / "no" / "such" / "folder");
  ASSERT_TRUE(free && below);
  EXPECT_NEAR(*below / *free, 1, 0.1);
}

TEST(Forecast, counts_the_collisions_of_a_pilot_run) {
  const Forecast found = forecast(shaken(10), std::chrono::milliseconds{50});
  EXPECT_GT(found.collisions, 25) << "the floor hits the ball about once a period or more";
  EXPECT_LT(found.collisions, 2500);
  EXPECT_GT(found.each, 0);
}

}  // namespace
}  // namespace mahlwerk::campaign::forecast_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Frames of a replay.
#include "mahlwerk/observe/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::observe::replay_test {
namespace {

/// LAMMPS writes its balls at fewer times than a replay has frames.
TEST(Replay, has_rising_times_although_an_engine_gives_its_balls_at_few_times) {
  const scene::Chamber drum{geometry::Cylinder{0.2, 0.1}, kinematics::Tumbling{5}, {}, {}};
  Replay replay(drum, 1, 0, 1);
  const std::vector<scene::Ball> balls(1, {0.005, 7850, {}, {}, {}});
  const double first = replay.next_frame_time();
  int frames = 0;
  for (; std::isfinite(replay.next_frame_time()) && frames < 10000; ++frames)
    replay.add(0.1 * std::floor(replay.next_frame_time() / 0.1), balls);
  EXPECT_EQ(first, 0);
  EXPECT_EQ(frames, 360) << "every frame is asked for once";
  ASSERT_EQ(replay.times().size(), 11U) << "0, 0.1, ... 1 s";
  for (std::size_t i = 1; i < replay.times().size(); ++i)
    EXPECT_GT(replay.times()[i], replay.times()[i - 1]);
  EXPECT_EQ(replay.positions().size(), 11U);
}

}  // namespace
}  // namespace mahlwerk::observe::replay_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Frames of a replay.
#include "mahlwerk/observe/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

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
    replay.add(0.1 * std::floor(replay.next_frame_time() / 0.1), 0, balls);
  EXPECT_EQ(first, 0);
  EXPECT_EQ(frames, 360) << "every frame is asked for once";
  ASSERT_EQ(replay.times().size(), 11U) << "0, 0.1, ... 1 s";
  for (std::size_t i = 1; i < replay.times().size(); ++i)
    EXPECT_GT(replay.times()[i], replay.times()[i - 1]);
  EXPECT_EQ(replay.positions().size(), 11U);
}

TEST(Replay, has_no_place_of_balls_outside_the_jar) {
  const scene::Chamber drum{geometry::Cylinder{0.2, 0.1}, kinematics::Tumbling{5}, {}, {}};
  Replay replay(drum, 2, 0, 1);
  std::vector<scene::Ball> balls(2, {0.005, 7850, {-1, -1, -1}, {}, {}});  // beyond all numbers
  balls[1].outside = true;
  replay.add(0, 0, balls);
  EXPECT_NE(replay.positions()[0], Replay::outside);
  EXPECT_EQ(replay.positions()[1], Replay::outside);
}

/// Of 50 001 balls every third is shown: the fewest that are at most 20 000.
TEST(Replay, shows_every_third_of_many_balls) {
  const scene::Chamber drum{geometry::Cylinder{0.2, 0.1}, kinematics::Tumbling{5}, {}, {}};
  constexpr int count = 50001;
  Replay replay(drum, count, 2, 10);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < count; ++i)
    balls.push_back({0.001, 7850, {1e-6 * i, -1e-6 * i, 0.05}, {0.001 * i, 0, 0}, {}});
  replay.add(2, 2, balls);
  EXPECT_EQ(replay.balls(), 16667U);
  ASSERT_EQ(replay.positions().size(), 16667U);
  const double unit = std::hypot(0.1, 0.05) / 32767;
  for (const std::size_t k : {0U, 1U, 7U, 16666U}) {
    EXPECT_EQ(replay.positions()[k][0], std::lround(3e-6 * static_cast<double>(k) / unit));
    EXPECT_EQ(replay.positions()[k][1], std::lround(-3e-6 * static_cast<double>(k) / unit));
    EXPECT_EQ(replay.positions()[k][2], std::lround(0.05 / unit));
    EXPECT_NEAR(replay.speeds()[k], 0.003 * static_cast<double>(k), 1e-5);
  }
}

/// How long a film is and how many frames it has, by the motion.
TEST(Replay, shows_three_periods_or_a_turn_of_the_jar) {
  const auto last = [](const kinematics::AnyMotion& motion, std::size_t balls, double most) {
    Replay replay({geometry::Cylinder{0.2, 0.1}, motion, {}, {}}, balls, 1, most);
    const std::vector<scene::Ball> all(balls, {0.005, 7850, {}, {}, {}});
    double end = 0;
    int frames = 0;
    for (; std::isfinite(replay.next_frame_time()); ++frames)
      replay.add(end = replay.next_frame_time(), 0, all);
    return std::pair(end - 1, frames);
  };
  kinematics::Vibration shaken;
  shaken.frequency = 20;
  shaken.amplitude = 0.01;
  const auto near = [](const std::pair<double, int>& found, double time, int frames) {
    EXPECT_NEAR(found.first, time, 1e-9);
    EXPECT_EQ(found.second, frames);
  };
  near(last(shaken, 1, 10), 0.15, 360);
  near(last(shaken, 1, 0.1), 0.1, 360);  // a shorter run
  near(last(kinematics::Still{}, 1, 10), 0.5, 360);
  near(last(kinematics::Tumbling{5}, 1, 10), 2 * std::numbers::pi / 5, 360);
  near(last(kinematics::Tumbling{0.1}, 1, 100), 10, 360);  // at most
  near(last(shaken, 1000, 10), 0.15, 150);                 // 150 000 positions in all
  near(last(shaken, 20000, 10), 0.15, 16);                 // but sixteen frames
}

}  // namespace
}  // namespace mahlwerk::observe::replay_test

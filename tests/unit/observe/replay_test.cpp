// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Frames of a replay.
#include "mahlwerk/observe/replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

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

/// 400 hits of a ball with the wall between the first two frames of a film of 16, and one before
/// its begin and one after its end, which are the strongest.
std::vector<scene::Collision> many_hits(double interval) {
  std::vector<scene::Collision> list;
  for (int i = 0; i < 402; ++i) {
    scene::Collision hit;
    hit.time = i < 400 ? interval * i / 400 : i == 400 ? -interval / 2 : 1000;
    hit.ball = i % 2;
    hit.other = ~0;
    hit.mass = 2;
    hit.approach = i < 400 ? 1 + (i * 7919) % 401 : 500;  // energies (1 to 401)^2 J, each once
    list.push_back(hit);
  }
  return list;
}

/// Of 400 hits between two frames the 100 strongest are kept, in whatever order they come.
TEST(Replay, keeps_the_strongest_hits_between_two_frames_whatever_their_order) {
  const scene::Chamber drum{geometry::Cylinder{0.2, 0.1}, kinematics::Tumbling{5}, {}, {}};
  Replay one(drum, 20000, 0, 10), other(drum, 20000, 0, 10);
  const double interval = 2 * std::numbers::pi / 5 / 15;
  std::vector<scene::Collision> hits = many_hits(interval);
  one.add_hits(hits, 201);
  std::ranges::reverse(hits);
  for (const scene::Collision& hit : hits) other.add_hits({&hit, 1}, 201);
  const std::vector<ReplayHit> kept = one.hits(), same = other.hits();
  ASSERT_EQ(kept.size(), 100U);
  ASSERT_EQ(same.size(), 100U);
  const auto between = [&](const scene::Collision& hit) {
    return hit.time >= 0 && hit.time < interval;
  };
  std::vector<double> expected;
  for (const scene::Collision& hit : hits)
    if (between(hit)) expected.push_back(hit.energy_normal());
  std::ranges::sort(expected, std::greater());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_GE(kept[i].energy, expected[99]);
    EXPECT_LE(kept[i].energy, expected[0]);
    EXPECT_EQ(kept[i].energy, same[i].energy);
    EXPECT_EQ(kept[i].time, same[i].time);
  }
  const auto counted = std::ranges::count_if(
      hits, [&](const scene::Collision& hit) { return between(hit) && hit.approach >= 201; });
  EXPECT_EQ(one.hits_of_balls()[0] + one.hits_of_balls()[1], counted);
  EXPECT_EQ(one.hits_of_balls(), other.hits_of_balls());
}

/// A saved film goes on with the same hits; one whose numbers do not fit is refused.
TEST(Replay, continues_from_a_saved_state_and_refuses_a_damaged_one) {
  const scene::Chamber drum{geometry::Cylinder{0.2, 0.1}, kinematics::Tumbling{5}, {}, {}};
  Replay one(drum, 20000, 0, 1);
  one.add_hits(many_hits(0.08), 0);
  Archive out;
  one.serialize(out);
  Replay read(drum, 20000, 0, 1);
  Archive in(out.bytes());
  read.serialize(in);
  in.finish();
  EXPECT_EQ(read.hits().size(), one.hits().size());
  EXPECT_EQ(read.hits_of_balls(), one.hits_of_balls());
  Replay shorter(drum, 1000, 0, 1);  // of other frames
  Archive again(out.bytes());
  EXPECT_THROW(shorter.serialize(again), RunError);
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

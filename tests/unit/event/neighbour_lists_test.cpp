// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Verlet neighbour lists against a test of all pairs.
#include "mahlwerk/event/neighbour_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/collision_prediction.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::neighbour_lists_test {
namespace {

constexpr std::int32_t count = 300;
constexpr double skin = 0.3;
const Vec3 periods{9, 8.5, 10};
const std::vector<double> radii{0.5, 0.3};

struct ListedBalls {
  event::NeighbourLists lists{radii, skin, periods, as_index(count)};
  std::vector<Vec3> centres = std::vector<Vec3>(as_index(count));
  std::vector<std::uint32_t> species = std::vector<std::uint32_t>(as_index(count));
  std::vector<std::int32_t> all = std::vector<std::int32_t>(as_index(count));

  explicit ListedBalls(Random& random) {
    std::iota(all.begin(), all.end(), 0);
    for (std::int32_t i = 0; i < count; ++i) {
      centres[as_index(i)] = anywhere(random);
      species[as_index(i)] = static_cast<std::uint32_t>(i % 2);
      lists.place(i, species[as_index(i)], centres[as_index(i)]);
    }
    for (std::int32_t i = 0; i < count; ++i) lists.renew(i, centres[as_index(i)], all);
  }
  static Vec3 anywhere(Random& random) {
    return {random.uniform(-0.5, 0.5) * periods.x, random.uniform(-0.5, 0.5) * periods.y,
            random.uniform(-0.5, 0.5) * periods.z};
  }
  std::vector<std::int32_t> expected(std::int32_t ball) const {
    std::vector<std::int32_t> found;
    for (const std::int32_t other : all) {
      const Vec3 apart =
          event::nearest_image(centres[as_index(ball)] - centres[as_index(other)], periods);
      const double touch = radii[species[as_index(ball)]] + radii[species[as_index(other)]];
      if (other != ball && norm(apart) <= touch + 2 * skin) found.push_back(other);
    }
    return found;
  }
  void check() const {
    for (const std::int32_t ball : all) {
      const auto list = lists.of(ball);
      std::vector<std::int32_t> found(list.begin(), list.end());
      std::ranges::sort(found);
      ASSERT_EQ(found, expected(ball)) << ball;
    }
  }
};

TEST(NeighbourLists, name_each_pair_whose_spheres_let_it_touch_and_no_other) {
  Random random(1, 1);
  ListedBalls balls(random);
  balls.check();
  for (int i = 0; i < 2000; ++i) {
    const auto ball = static_cast<std::int32_t>(random.uniform() * count);
    balls.centres[as_index(ball)] = ListedBalls::anywhere(random);
    balls.lists.renew(ball, balls.centres[as_index(ball)], balls.all);
    if (i % 100 == 0) balls.check();
  }
  balls.check();
  EXPECT_TRUE(balls.lists.is_consistent(as_index(count)));
}

TEST(NeighbourLists, are_the_same_after_the_balls_are_numbered_anew) {
  Random random(2, 1);
  ListedBalls balls(random);
  std::vector<std::int32_t> number = balls.all;
  for (std::size_t i = number.size(); i > 1; --i)
    std::swap(number[i - 1],
              number[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  ListedBalls before = balls;
  balls.lists.renumber(number);
  for (const std::int32_t i : balls.all) {
    balls.centres[as_index(number[as_index(i)])] = before.centres[as_index(i)];
    balls.species[as_index(number[as_index(i)])] = before.species[as_index(i)];
  }
  balls.check();
}

TEST(NeighbourLists, let_a_ball_fly_until_it_is_on_its_sphere) {
  Random random(3, 1);
  ListedBalls balls(random);
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::int32_t ball = i % count;
    const Vec3 start = balls.centres[as_index(ball)] +
                       skin * std::cbrt(random.uniform()) * (1 - 1e-6) * random.direction();
    const Vec3 velocity = std::pow(10, random.uniform(-3, 3)) * random.direction();
    const double time = balls.lists.safe_time(ball, start, velocity);
    const auto distance = [&](double t) {
      return norm(start + t * velocity - balls.centres[as_index(ball)]);
    };
    worst = std::max(worst, std::abs(distance(time) - skin) / skin);
    ASSERT_TRUE(balls.lists.has_left(ball, start + time * velocity)) << i;
    ASSERT_LT(distance(0.5 * time), skin) << i;
    ASSERT_FALSE(balls.lists.has_left(ball, start)) << i;
  }
  stays_below("distance from the sphere at the safe time, over its radius", worst, 1e-12,
              "rounding of a root, magnified for balls near the sphere");
}

}  // namespace
}  // namespace mahlwerk::tests::neighbour_lists_test

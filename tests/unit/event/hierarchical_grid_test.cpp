// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Size classes: all balls that a ball can touch before it leaves its cell are its neighbours,
// whatever their sizes.
#include "mahlwerk/event/hierarchical_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/collision_prediction.hpp"

namespace mahlwerk::event::hierarchical_grid_test {
namespace {

struct Placed {
  Vec3 place;
  std::uint32_t species;
  Cell cell;
};

/// Balls of diameters 1, 0.6, 0.3 and 0.1 at random positions in a box. Each finds all balls it
/// would touch.
void check(bool periodic, const Vec3& size, std::uint32_t stream) {
  const std::vector<double> diameters{0.3, 1, 0.1, 0.6};
  constexpr std::int32_t count = 400;
  const Vec3 low = -0.5 * size;
  HierarchicalGrid neighbours(low, size, periodic, diameters, 0.02, count);
  Random random(5, stream);
  std::vector<Placed> balls;
  for (std::int32_t i = 0; i < count; ++i) {
    const Vec3 p{low.x + random.uniform() * size.x, low.y + random.uniform() * size.y,
                 low.z + random.uniform() * size.z};
    const auto species = static_cast<std::uint32_t>(i % 4);
    const int level = neighbours.level_of(species);
    balls.push_back({p, species, neighbours.cell_at(level, p)});
    neighbours.insert(level, i, balls.back().cell);
  }
  const Vec3 periods = periodic ? size : Vec3{never, never, never};
  int pairs = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    const Placed& a = balls[static_cast<std::size_t>(i)];
    const auto near = neighbours.near(neighbours.level_of(a.species), a.cell);
    for (std::int32_t j = 0; j < count; ++j) {
      const Placed& b = balls[static_cast<std::size_t>(j)];
      const double touch = 0.5 * (diameters[a.species] + diameters[b.species]);
      if (i == j || norm(nearest_image(a.place - b.place, periods)) > touch) continue;
      ++pairs;
      EXPECT_NE(std::ranges::find(near, j), near.end()) << i << " and " << j;
    }
  }
  EXPECT_GT(pairs, 50);
  EXPECT_EQ(neighbours.ball_count(), count);
}

TEST(HierarchicalGrid, whoever_can_be_touched_is_near_in_a_jar) {
  check(false, {4, 4, 4}, 1);
  check(false, {9, 2, 3}, 2);
}

TEST(HierarchicalGrid, whoever_can_be_touched_is_near_round_a_periodic_box) {
  check(true, {5.3, 5.1, 6}, 3);
  check(true, {12, 2.3, 2.1}, 4);
}

TEST(HierarchicalGrid, sizes_within_a_factor_two_share_a_grid) {
  const std::vector<double> diameters{1, 0.6, 0.5, 0.3, 0.1};
  const HierarchicalGrid neighbours({-2, -2, -2}, {4, 4, 4}, false, diameters, 0, 10);
  EXPECT_EQ(neighbours.level_of(0), neighbours.level_of(1));
  EXPECT_NE(neighbours.level_of(1), neighbours.level_of(2));  // half the largest starts a new level
  EXPECT_EQ(neighbours.level_of(2), neighbours.level_of(3));
  EXPECT_NE(neighbours.level_of(3), neighbours.level_of(4));
}

}  // namespace
}  // namespace mahlwerk::event::hierarchical_grid_test

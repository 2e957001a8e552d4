// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::tests::cells_test {
namespace {

using Counts = std::array<int, 3>;

/// Balls at random positions in a grid with `counts` cells. They are up to the slack outside their
/// cells.
class RandomBalls {
 public:
  static constexpr double side = 1, slack = 0.05;

  RandomBalls(const Counts& counts, bool periodic, int balls, std::uint64_t seed)
      : random_(seed, 0),
        periodic_(periodic),
        low_{random_.uniform(-9, 9), random_.uniform(-9, 9), random_.uniform(-9, 9)},
        size_{wide(counts[0]), wide(counts[1]), wide(counts[2])},
        cells_(low_, size_, periodic, side, slack, 1e9) {
    for (int i = 0; i < balls; ++i) {
      const Vec3 at = anywhere();
      of_.push_back(cells_.cell_at(at));
      const Vec3 off =
          slack * Vec3{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
      places_.push_back(at + off);
      cells_.insert(i, of_.back());
    }
  }

  Vec3 anywhere() {
    return low_ + Vec3{random_.uniform(0, size_.x), random_.uniform(0, size_.y),
                       random_.uniform(0, size_.z)};
  }
  double distance(std::size_t a, std::size_t b) const {
    const Vec3 r = places_[a] - places_[b];
    const auto fold = [&](double x, double l) { return periodic_ ? x - l * std::rint(x / l) : x; };
    return norm(Vec3{fold(r.x, size_.x), fold(r.y, size_.y), fold(r.z, size_.z)});
  }
  std::vector<std::int32_t> near(event::Cell cell) const {
    std::vector<std::int32_t> out(static_cast<std::size_t>(cells_.max_neighbours()));
    out.resize(static_cast<std::size_t>(cells_.near(cell, out.data())));
    return out;
  }
  std::set<std::int32_t> newly_near(event::Cell cell, event::Cell before) const {
    std::vector<std::int32_t> out(static_cast<std::size_t>(cells_.max_neighbours()));
    const int n = cells_.newly_near(cell, before, out.data());
    return {out.begin(), out.begin() + n};
  }

  Random random_;
  bool periodic_;
  Vec3 low_, size_;
  event::Cells cells_;
  std::vector<event::Cell> of_;
  std::vector<Vec3> places_;

 private:
  double wide(int count) { return (count + random_.uniform(0.001, 0.999)) * side; }
};

void check_neighbours(const Counts& counts, bool periodic, int balls, std::uint64_t seed) {
  RandomBalls crowd(counts, periodic, balls, seed);
  for (std::size_t i = 0; i < crowd.of_.size(); ++i) {
    const auto list = crowd.near(crowd.of_[i]);
    const std::set<std::int32_t> seen(list.begin(), list.end());
    ASSERT_EQ(seen.size(), list.size()) << "no ball is listed twice";
    for (std::size_t j = 0; j < crowd.of_.size(); ++j) {
      if (crowd.distance(i, j) <= RandomBalls::side - 2 * RandomBalls::slack) {
        ASSERT_TRUE(seen.contains(static_cast<std::int32_t>(j)))
            << counts[0] << " x " << counts[1] << " x " << counts[2] << ", " << periodic;
      }
      auto known = crowd.newly_near(crowd.of_[i], crowd.of_[j]);
      for (const std::int32_t old : crowd.near(crowd.of_[j])) known.insert(old);
      ASSERT_TRUE(std::ranges::includes(known, seen)) << "a move from any cell to any other";
    }
  }
}

TEST(Cells, near_holds_all_that_can_touch_and_newly_near_what_a_move_adds) {
  for (const bool periodic : {false, true})
    for (int x = 1; x <= 5; ++x)
      for (int y = 1; y <= 5; ++y)
        for (int z = 1; z <= 5; ++z)
          check_neighbours({x, y, z}, periodic, 30, static_cast<std::uint64_t>(x + 8 * y + 64 * z));
}

TEST(Cells, long_thin_grids_and_crowded_cells_are_no_exception) {
  for (const bool periodic : {false, true}) {
    check_neighbours({200, 1, 1}, periodic, 120, 1);
    check_neighbours({1, 60, 2}, periodic, 120, 2);
    check_neighbours({1, 1, 1}, periodic, 100, 3);
    check_neighbours({2, 1, 3}, periodic, 120, 4);
  }
}

TEST(Cells, a_ball_removed_is_near_no_more_and_the_others_still_are) {
  RandomBalls crowd({2, 2, 2}, false, 200, 5);
  std::set<std::int32_t> there;
  for (std::int32_t i = 0; i < 200; ++i) {
    if (i % 3 == 0)
      crowd.cells_.remove(i, crowd.of_[static_cast<std::size_t>(i)]);
    else
      there.insert(i);
  }
  const auto list = crowd.near(crowd.of_[0]);
  EXPECT_EQ(std::set<std::int32_t>(list.begin(), list.end()), there);
  EXPECT_EQ(list.size(), there.size());
  crowd.cells_.clear();
  EXPECT_TRUE(crowd.near(crowd.of_[0]).empty());
}

TEST(Cells, a_place_outside_counts_to_the_nearest_cell) {
  RandomBalls crowd({5, 3, 4}, false, 0, 6);
  for (int i = 0; i < 10000; ++i) {
    const double far = std::pow(10, crowd.random_.uniform(-3, 15));
    const Vec3 out = crowd.anywhere() + far * crowd.random_.direction();
    const Vec3 high = crowd.low_ + (1 - 1e-9) * crowd.size_;
    const Vec3 in{std::clamp(out.x, crowd.low_.x, high.x), std::clamp(out.y, crowd.low_.y, high.y),
                  std::clamp(out.z, crowd.low_.z, high.z)};
    ASSERT_EQ(crowd.cells_.cell_at(out), crowd.cells_.cell_at(in)) << out.x << " " << out.y;
  }
}

TEST(Cells, beyond_its_borders_a_ball_is_in_another_cell) {
  for (const bool periodic : {false, true}) {
    RandomBalls crowd({4, 1, 2}, periodic, 0, 7);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 at = crowd.anywhere();
      const auto cell = crowd.cells_.cell_at(at);
      const auto borders = crowd.cells_.borders(cell);
      EXPECT_LT(borders.low.x, at.x);
      EXPECT_GT(borders.high.x, at.x);
      for (const double x : {borders.low.x, borders.high.x}) {
        const double inside = crowd.size_.x;
        if (x <= crowd.low_.x || x >= crowd.low_.x + inside) continue;  // no border, or periodic
        EXPECT_NE(crowd.cells_.cell_at({x, at.y, at.z}), cell);
      }
    }
  }
}

}  // namespace
}  // namespace mahlwerk::tests::cells_test

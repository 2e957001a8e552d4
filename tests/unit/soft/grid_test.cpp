// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::soft::grid_test {
namespace {

/// Random positions in a box of `size`.
std::vector<Vec3> cloud(int count, const Vec3& size, std::uint32_t seed) {
  Random random(seed, 0);
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i)
    places.push_back({random.uniform(-0.5, 0.5) * size.x, random.uniform(-0.5, 0.5) * size.y,
                      random.uniform(-0.5, 0.5) * size.z});
  return places;
}

void expect_all_found(int count, const Vec3& size, double radius, double margin, double reach,
                      const Vec3& periods, std::uint32_t seed) {
  std::vector<Vec3> places = cloud(count, size, seed);
  PositionBounds bounds;
  for (const Vec3& p : places) bounds.add(p);
  Grid grid(bounds, radius, margin, periods);
  std::ranges::sort(places, {}, [&](const Vec3& p) { return grid.key(p); });
  constexpr std::int32_t first = 100;
  std::vector<BallRecord> rows(first);
  for (const Vec3& p : places) rows.push_back({p.x, p.y, p.z, radius, 0, 0, 0, 0});
  grid.fill(first, static_cast<std::int32_t>(rows.size()),
            [&](std::int32_t row) { return rows[static_cast<std::size_t>(row)].position(); });
  const auto apart = [&](const Vec3& a, const Vec3& b) {
    Vec3 d = b - a;
    if (std::isfinite(periods.x)) d.x = std::remainder(d.x, periods.x);
    if (std::isfinite(periods.y)) d.y = std::remainder(d.y, periods.y);
    if (std::isfinite(periods.z)) d.z = std::remainder(d.z, periods.z);
    return norm(d);
  };
  for (const Vec3& from : cloud(30, 1.2 * size, seed + 1)) {
    std::multiset<std::int32_t> found;
    grid.for_each_near(from, {reach, reach, reach}, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t k = begin; k < end; ++k) found.insert(k);
    });
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto times = found.count(first + static_cast<std::int32_t>(k));
      EXPECT_LE(times, 1U) << "found twice";
      EXPECT_GE(times, apart(from, places[k]) <= reach ? 1U : 0U) << "missed";
    }
  }
}

TEST(Grid, finds_all_that_brute_force_does) {
  const Vec3 none{INFINITY, INFINITY, INFINITY};
  std::uint32_t seed = 1;
  for (const int count : {1, 2, 50, 2000})
    for (const Vec3& size : {Vec3{1, 1, 1}, Vec3{0.01, 5, 1}, Vec3{0, 0, 3}})
      for (const double radius : {0.01, 0.15})        // as many cells as balls, or few
        for (const double reach : {0.02, 0.3, 10.0})  // of queries by small and large balls
          expect_all_found(count, size, radius, 0.1 * radius, reach, none, ++seed);
}

TEST(Grid, finds_images_where_places_repeat) {
  std::uint32_t seed = 1000;
  for (const int count : {1, 50, 2000})
    for (const Vec3& periods : {Vec3{1, 1, 1}, Vec3{0.3, 1, INFINITY}})
      for (const double radius : {0.02, 0.1})
        for (const double reach : {0.05, 0.14})
          expect_all_found(count, {3, 3, 3}, radius, 0.1 * radius, reach, periods, ++seed);
}

}  // namespace
}  // namespace mahlwerk::soft::grid_test

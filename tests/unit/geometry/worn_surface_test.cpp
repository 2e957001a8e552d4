// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/worn_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mahlwerk/geometry/prism.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::worn_surface_test {
namespace {

using geometry::Surface;
using geometry::WornSide;

const geometry::Section square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};

Surface cube() {
  return *geometry::cut_into_small(geometry::weld(geometry::prism(square, 1, 1)), 0.2, 10'000);
}
/// Its points moved out to a sphere.
Surface ball(double radius) {
  Surface s = cube();
  for (Vec3& p : s.points) p = radius / norm(p) * p;
  return s;
}

double sum_of(const std::vector<double>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0);
}

/// What vertices lose where the surface wears unevenly.
std::vector<double> uneven(const Surface& s, double depth) {
  std::vector<double> lost = geometry::vertex_areas(s);
  for (std::size_t i = 0; i < lost.size(); ++i)
    lost[i] *= depth * (1 + 0.8 * std::sin(7 * s.points[i].x + 3 * s.points[i].z));
  return lost;
}

TEST(WornSurface, volume_lost_is_the_wear_to_rounding) {
  for (const Surface& s : {cube(), ball(0.6)})
    for (const WornSide side : {WornSide::outside, WornSide::inside}) {
      const auto lost = uneven(s, 0.01);
      const auto worn = geometry::worn_surface(s, lost, side);
      ASSERT_TRUE(worn.has_value());
      const double sign = side == WornSide::inside ? 1 : -1;
      states("volume lost by the wall or the solid [m3]",
             sign * (geometry::volume_of(*worn) - geometry::volume_of(s)), sum_of(lost), 1e-13,
             "sum of what the vertices lost (wea.19)");
      EXPECT_FALSE(geometry::flaw_of(*worn).has_value());
    }
}

TEST(WornSurface, uniform_wear_of_a_ball_makes_a_smaller_ball) {
  const Surface s = ball(0.6);
  std::vector<double> lost = geometry::vertex_areas(s);
  for (double& v : lost) v *= 0.01;
  const auto worn = geometry::worn_surface(s, lost, WornSide::outside);
  ASSERT_TRUE(worn.has_value());
  double least = 1, most = 0;
  for (const Vec3& p : worn->points)
    least = std::min(least, norm(p)), most = std::max(most, norm(p));
  // The radius that the same polyhedron has with the smaller volume. Vertices whose triangles
  // differ move along normals that differ from the radius by some degrees: 1 - cos(5 deg) = 0.4 %.
  const double radius = 0.6 * std::cbrt(geometry::volume_of(*worn) / geometry::volume_of(s));
  states("smallest radius [m]", least, radius, 0.01 * 0.02, "2 % of the depth");
  states("largest radius [m]", most, radius, 0.01 * 0.02, "2 % of the depth");
}

TEST(WornSurface, spreading_keeps_the_sum_and_a_uniform_depth) {
  const Surface s = cube();
  std::vector<double> one(s.points.size()), even = geometry::vertex_areas(s);
  one[10] = 1;
  const auto spread = geometry::spread_over(s, one, 0.1);
  states("sum", sum_of(spread), 1, 1e-13, "flows from vertex to vertex (wea.11)");
  EXPECT_LT(spread[10], 0.5);
  EXPECT_GE(*std::ranges::min_element(spread), -1e-15) << "nothing grows";
  const auto same = geometry::spread_over(s, even, 0.1);
  for (std::size_t i = 0; i < even.size(); ++i) EXPECT_NEAR(same[i], even[i], 1e-15);
}

TEST(WornSurface, spreading_on_a_face_has_the_standard_deviation_asked_for) {
  // A plane of 60 by 60 squares, open, and its middle.
  constexpr int n = 60;
  Surface s;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) s.points.push_back({1.0 * i, 1.0 * j, 0});
  const auto at = [](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  std::vector<double> lost(s.points.size());
  lost[static_cast<std::size_t>(at(30, 30))] = 1;
  const auto spread = geometry::spread_over(s, lost, 4);
  double variance = 0;
  for (std::size_t i = 0; i < spread.size(); ++i)
    variance += spread[i] * std::pow(s.points[i].x - 30, 2);
  states("standard deviation along x", std::sqrt(variance), 4, 0.04,
         "conduction over tau = s^2/2 (wea.11), 1 % for the edges of the plane");
}

TEST(WornSurface, nearest_vertex_is_the_nearest_of_all) {
  const Surface s = ball(0.6);
  const geometry::NearestVertex nearest(s);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p{0.6 * std::sin(i), 0.5 * std::cos(3 * i), 0.4 * std::sin(5 * i)};
    std::size_t best = 0;
    for (std::size_t k = 0; k < s.points.size(); ++k)
      if (norm(s.points[k] - p) < norm(s.points[best] - p)) best = k;
    EXPECT_DOUBLE_EQ(norm(s.points[nearest(p)] - p), norm(s.points[best] - p));
  }
}

TEST(WornSurface, a_step_that_turns_a_triangle_over_is_refused) {
  const Surface s = cube();
  std::vector<double> all = geometry::vertex_areas(s);
  for (double& v : all) v *= 0.7;  // more than there is
  EXPECT_FALSE(geometry::worn_surface(s, all, WornSide::outside).has_value());
}

}  // namespace
}  // namespace mahlwerk::tests::worn_surface_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/convex_core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "statement.hpp"

namespace mahlwerk::tests::convex_core_test {
namespace {

using geometry::ConvexCore;
using geometry::CoreFeature;
using geometry::NearestPoints;
using geometry::PlacedCore;
constexpr double pi = std::numbers::pi;

ConvexCore box(double x, double y, double z) {
  ConvexCore c;
  for (const double sx : {-x, x})
    for (const double sy : {-y, y})
      for (const double sz : {-z, z}) c.corners.push_back({sx, sy, sz});
  return c;
}

/// Distance of two segments: the least of the ends' distances from the other one, and that of the
/// lines, where it lies within both.
double segment_distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const auto of_point = [](const Vec3& x, const Vec3& a, const Vec3& b) {
    const double t = std::clamp(dot(x - a, b - a) / squared(b - a), 0.0, 1.0);
    return norm(x - (a + t * (b - a)));
  };
  double least =
      std::min({of_point(p, r, s), of_point(q, r, s), of_point(r, p, q), of_point(s, p, q)});
  const Vec3 u = q - p, v = s - r, n = cross(u, v);
  if (squared(n) < 1e-20) return least;
  const double a = dot(cross(r - p, v), n) / squared(n), b = dot(cross(r - p, u), n) / squared(n);
  if (a > 0 && a < 1 && b > 0 && b < 1) least = std::min(least, std::abs(dot(r - p, n)) / norm(n));
  return least;
}

/// Distance of a point from a box from outside.
double box_distance(const Vec3& x, const PlacedCore& box, const Vec3& half) {
  const Vec3 own = box.axes.apply_inverse(x - box.centre);
  const auto over = [](double a, double h) { return std::max(std::abs(a) - h, 0.0); };
  return norm(Vec3{over(own.x, half.x), over(own.y, half.y), over(own.z, half.z)});
}

/// The plain reference: all corners against the other box, all edges against all edges.
double plain_distance(const PlacedCore& a, const Vec3& half_a, const PlacedCore& b,
                      const Vec3& half_b) {
  const auto corners = [](const PlacedCore& p) {
    std::vector<Vec3> all;
    for (const Vec3& c : p.core->corners) all.push_back(p.centre + p.axes * c);
    return all;
  };
  const std::vector<Vec3> of_a = corners(a), of_b = corners(b);
  double least = 1e9;
  for (const Vec3& x : of_a) least = std::min(least, box_distance(x, b, half_b));
  for (const Vec3& x : of_b) least = std::min(least, box_distance(x, a, half_a));
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned k = 0; k < 8; ++k)
      for (const unsigned bit : {1U, 2U, 4U})
        for (const unsigned other : {1U, 2U, 4U})
          if ((i & bit) == 0 && (k & other) == 0)
            least =
                std::min(least, segment_distance(of_a[i], of_a[i | bit], of_b[k], of_b[k | other]));
  return least;
}

NearestPoints nearest(const PlacedCore& a, const PlacedCore& b) {
  geometry::NearestHulls hulls;
  return geometry::nearest_points(a, b, hulls);
}

class Draws {
 public:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(engine_); }
  Vec3 direction() {
    const double z = between(-1, 1), phi = between(0, 2 * pi), s = std::sqrt(1 - z * z);
    return {s * std::cos(phi), s * std::sin(phi), z};
  }
  Rotation rotation() { return rotation_about(direction(), between(0, pi)); }

 private:
  std::mt19937_64 engine_{5};
};

TEST(ConvexCore, distance_of_two_boxes_is_that_of_their_nearest_features) {
  Draws draw;
  double worst = 0;
  int apart = 0;
  for (int n = 0; n < 20000; ++n) {
    const Vec3 half_a{1, draw.between(0.1, 1), draw.between(0.1, 1)},
        half_b{draw.between(0.1, 1), 0.5, draw.between(0.1, 2)};
    const ConvexCore a = box(half_a.x, half_a.y, half_a.z), b = box(half_b.x, half_b.y, half_b.z);
    const PlacedCore at_a{&a, {}, draw.rotation()},
        at_b{&b, draw.between(0.5, 4) * draw.direction(), draw.rotation()};
    const double plain = plain_distance(at_a, half_a, at_b, half_b);
    if (plain < 1e-3) continue;  // cores that meet have no distance
    const NearestPoints found = nearest(at_a, at_b);
    if (found.distance == 0) continue;  // one box holds an edge of the other
    ++apart;
    worst = std::max(
        {worst, std::abs(found.distance - plain), std::abs(norm(found.on_b - found.on_a) - plain),
         box_distance(found.on_a, at_a, half_a), box_distance(found.on_b, at_b, half_b)});
  }
  EXPECT_GT(apart, 10000);
  stays_below("distance, and points outside their boxes", worst, 1e-9,
              "all corners and edges, one by one; hulls end exactly");
}

TEST(ConvexCore, cores_that_meet_have_no_distance) {
  const ConvexCore a = box(1, 1, 1), b = box(0.1, 0.1, 3);
  for (const double x : {0.0, 0.5, 0.99, 1.05}) {
    const NearestPoints found = nearest({&a, {}, {}}, {&b, {x, 0.2, 0.1}, {}});
    EXPECT_EQ(found.distance, 0) << x;
  }
}

TEST(ConvexCore, distance_of_parallel_faces_is_that_of_their_planes) {
  const ConvexCore a = box(1, 1, 1);
  for (const double turn : {0.0, 0.3, 1e-9}) {
    const NearestPoints found =
        nearest({&a, {}, {}}, {&a, {0.3, 0.2, 2.1}, rotation_about({0, 0, 1}, turn)});
    states("distance", found.distance, 0.1, 1e-11, "planes at 1 and 1.1");
    states("normal", (found.on_b - found.on_a).z / found.distance, 1, 1e-9, "likewise");
  }
}

TEST(ConvexCore, distance_of_cylinders_is_that_of_their_lines_and_discs) {
  ConvexCore cylinder;
  cylinder.radius = 0.5, cylinder.half_length = 1;
  // Crossed: the lines are 1.3 apart.
  const Rotation across = rotation_about({1, 0, 0}, pi / 2);
  const NearestPoints crossed = nearest({&cylinder, {}, {}}, {&cylinder, {1.3, 0.2, 0.1}, across});
  states("crossed", crossed.distance, 0.3, 3e-10, "1.3 - 2 x 0.5");
  // The end of one above the side of the other.
  const Rotation lying = rotation_about({0, 1, 0}, pi / 2);
  const NearestPoints above = nearest({&cylinder, {}, lying}, {&cylinder, {0.1, 0, 1.6}, {}});
  states("end on side", above.distance, 0.1, 3e-10, "1.6 - 1 - 0.5");
  // Tilted by 0.4 over a disc: its lowest rim point.
  ConvexCore disc;
  disc.radius = 3;
  const Rotation tilted = rotation_about({0, 1, 0}, 0.4);
  const double low = std::cos(0.4) + 0.5 * std::sin(0.4);
  const NearestPoints rim = nearest({&disc, {}, {}}, {&cylinder, {0, 0, low + 0.05}, tilted});
  states("rim on disc", rim.distance, 0.05, 1e-10, "half length cos + radius sin below the middle");
}

TEST(ConvexCore, distance_of_a_cylinder_is_that_of_its_fine_prism) {
  Draws draw;
  ConvexCore cylinder, prism;
  cylinder.radius = 0.5, cylinder.half_length = 0.4;
  constexpr int sides = 4000;
  for (int k = 0; k < sides; ++k)
    for (const double z : {-0.4, 0.4})
      prism.corners.push_back(
          {0.5 * std::cos(2 * pi * k / sides), 0.5 * std::sin(2 * pi * k / sides), z});
  const double missed = 0.5 * (1 - std::cos(pi / sides));  // of a side of the prism
  double worst = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 where = draw.between(0.9, 1.6) * draw.direction();
    const Rotation first = draw.rotation(), second = draw.rotation();
    const double found = nearest({&cylinder, {}, first}, {&cylinder, where, second}).distance;
    const double fine = nearest({&prism, {}, first}, {&prism, where, second}).distance;
    if (fine > 1e-2) worst = std::max(worst, std::abs(found - fine));
  }
  stays_below("difference", worst, 2 * missed + 2e-10, "sides of two prisms lie as much deeper");
}

/// Bodies that tumble past each other: a search that goes on from the last one finds the same.
TEST(ConvexCore, search_goes_on_from_the_last_one) {
  ConvexCore cylinder;
  cylinder.radius = 0.5, cylinder.half_length = 0.4;
  const ConvexCore cube = box(0.4, 0.4, 0.4);
  for (const auto& core : {&std::as_const(cylinder), &cube}) {
    geometry::NearestHulls hulls;
    double worst = 0;
    for (int n = 0; n < 20000; ++n) {
      const double t = 1e-3 * n;
      const PlacedCore a{core, {}, rotation_about({0.6, 0, 0.8}, 0.7 * t)},
          b{core,
            {1.5 + 0.1 * std::sin(t), 0.2 * std::cos(3 * t), 0},
            rotation_about({0, 1, 0}, t)};
      const double fresh = nearest(a, b).distance;
      worst = std::max(worst, std::abs(geometry::nearest_points(a, b, hulls).distance / fresh - 1));
    }
    stays_below("relative difference of the distances", worst, 1e-5,
                "1e-8 of the square; rims 2e-6");
  }
}

TEST(ConvexCore, nearest_point_to_a_wall_is_the_corner_or_the_rim_that_is_deepest) {
  struct Gap {
    double distance = 0;
    Vec3 inward;
  };
  Draws draw;
  ConvexCore cylinder;
  cylinder.radius = 0.3, cylinder.half_length = 0.2;
  const ConvexCore cube = box(0.2, 0.2, 0.2);
  const auto drum = [](const Vec3& x) {  // about the z axis, of radius 1
    const double r = std::sqrt(x.x * x.x + x.y * x.y);
    return Gap{1 - r, {-x.x / r, -x.y / r, 0}};
  };
  double worst = 0;
  for (int n = 0; n < 3000; ++n) {
    const double phi = draw.between(0, 2 * pi), from_axis = draw.between(0, 0.65);
    const Vec3 where{from_axis * std::cos(phi), from_axis * std::sin(phi), 0};
    const Rotation axes = draw.rotation();
    const double rim = drum(nearest_to_wall(PlacedCore{&cylinder, where, axes}, drum)).distance;
    const double corner = drum(nearest_to_wall(PlacedCore{&cube, where, axes}, drum)).distance;
    double least = 1e9, least_corner = 1e9;
    for (int k = 0; k < 3600; ++k)
      for (const double z : {-0.2, 0.2}) {
        const double a = 2 * pi * k / 3600;
        least = std::min(
            least, drum(where + axes * Vec3{0.3 * std::cos(a), 0.3 * std::sin(a), z}).distance);
      }
    for (const Vec3& c : cube.corners)
      least_corner = std::min(least_corner, drum(where + axes * c).distance);
    worst = std::max({worst, rim - least, std::abs(corner - least_corner)});
  }
  stays_below("distance above the least of 3600 points of each rim", worst, 1e-12,
              "the least of all points of both rims (bod.21)");
}

TEST(ConvexCore, curvature_is_that_of_corner_edge_face_rim_and_side) {
  const ConvexCore cube = box(1, 1, 1);
  ConvexCore cylinder;
  cylinder.radius = 0.8, cylinder.half_length = 1;
  const auto curvature = [&](const ConvexCore& c, const Vec3& at, const Vec3& n, CoreFeature f) {
    return geometry::mean_curvature(c, 0.2, at, n, f);
  };
  states("corner", curvature(cube, {1, 1, 1}, {0, 0, 1}, CoreFeature::corner), 5, 1e-12, "1/r");
  states("edge", curvature(cube, {1, 1, 0}, {1, 0, 0}, CoreFeature::edge), 2.5, 1e-12, "1/(2 r)");
  states("face", curvature(cube, {1, 0, 0}, {1, 0, 0}, CoreFeature::face), 0, 0, "flat");
  states("end", curvature(cylinder, {0.3, 0, 1}, {0, 0, 1}, CoreFeature::face), 0, 0, "flat");
  states("side", curvature(cylinder, {0.8, 0, 0.3}, {1, 0, 0}, CoreFeature::edge), 0.5, 1e-12,
         "1/(2 (0.8 + 0.2))");
  const double s = std::sqrt(0.5);
  states("rim", curvature(cylinder, {0.8, 0, 1}, {s, 0, s}, CoreFeature::corner),
         0.5 * (5 + s / (0.8 + 0.2 * s)), 1e-12, "torus");
}

TEST(ConvexCore, features_of_boxes_are_told) {
  const ConvexCore a = box(1, 1, 1);
  const auto features = [&](const Vec3& where, const Rotation& axes) {
    const NearestPoints p = nearest({&a, {}, {}}, {&a, where, axes});
    return std::array{p.feature_a, p.feature_b};
  };
  const Rotation on_edge = rotation_about({1, 0, 0}, pi / 4);
  // A corner above a face, and two crossed edges.
  const Rotation on_corner = rotation_about({1, 0.1, 0}, 0.7);
  EXPECT_EQ(features({0.05, 0.1, 3}, on_corner)[1], CoreFeature::corner);
  EXPECT_EQ(features({0.05, 0.1, 3}, on_corner)[0], CoreFeature::face);
  const ConvexCore turned = box(1, 1, 1);
  const PlacedCore below{&turned, {}, on_edge},
      above{&turned, {0.1, 0.1, 3}, rotation_about({0, 0, 1}, pi / 2) * on_edge};
  const NearestPoints edges = nearest(below, above);
  EXPECT_EQ(edges.feature_a, CoreFeature::edge);
  EXPECT_EQ(edges.feature_b, CoreFeature::edge);
}

}  // namespace
}  // namespace mahlwerk::tests::convex_core_test

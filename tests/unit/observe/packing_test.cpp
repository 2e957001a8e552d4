// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Packing fractions (mix.5) of lattices, whose own is known.
#include "mahlwerk/observe/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "mahlwerk/observe/images.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::packing_test {
namespace {

using tests::states;

constexpr double pi = std::numbers::pi, never = std::numeric_limits<double>::infinity();

/// Balls of diameter 1 on a lattice that fills the cuboid from `low` to `high`.
struct Lattice {
  double side = 1;           ///< of its cubic cell
  std::vector<Vec3> points;  ///< of a cell
  double packing() const { return double(points.size()) * pi / 6 / (side * side * side); }

  std::vector<scene::Ball> fill(const Vec3& low, const Vec3& high) const {
    std::vector<scene::Ball> balls;
    constexpr int cells = 30;
    constexpr double rounding = 1e-9;
    const auto inside = [](double x, double a, double b) {
      return x > a - rounding && x < b - rounding;
    };
    for (int x = -cells; x <= cells; ++x)
      for (int y = -cells; y <= cells; ++y)
        for (int z = -cells; z <= cells; ++z)
          for (const Vec3& p : points) {
            const Vec3 at = side * (p + Vec3{1.0 * x, 1.0 * y, 1.0 * z});
            if (inside(at.x, low.x, high.x) && inside(at.y, low.y, high.y) &&
                inside(at.z, low.z, high.z))
              balls.push_back({0.5, 1, at, {}, {}});
          }
    return balls;
  }
};
const Lattice cubic{1, {{0, 0, 0}}};
const Lattice dense{std::sqrt(2.0), {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};

/// Fourier transform of a full sphere over its volume.
double of_sphere(double x) {
  return 3 * (std::sin(x) - x * std::cos(x)) / (x * x * x);
}

/// Mean number of points in a line of the grid along each axis.
Vec3 mean_line(const std::vector<LocalPacking>& found) {
  std::set<std::pair<long, long>> x, y, z;
  const auto key = [](double a) { return std::lround(1e6 * a); };
  for (const LocalPacking& one : found) {
    x.insert({key(one.at.y), key(one.at.z)});
    y.insert({key(one.at.z), key(one.at.x)});
    z.insert({key(one.at.x), key(one.at.y)});
  }
  const auto n = double(found.size());
  return {n / double(x.size()), n / double(y.size()), n / double(z.size())};
}

/// Bound on the deviation of the mean over points of a grid with these spacings. The local packing
/// is the lattice's own and waves of the vectors g of the reciprocal lattice, each with the
/// transforms of a ball and of the sphere that is cut. A sum over a line is sin(n g h/2)/sin(g h/2)
/// of a wave at most, that over all lines the number of lines over |sin(g h/2)|, whatever the shape
/// of the bed.
double tolerance(const Lattice& l, const std::vector<LocalPacking>& found, const Vec3& apart) {
  constexpr int most = 20;
  constexpr double radius = 1.5;
  const Vec3 n = mean_line(found);
  const auto mean = [](double g, double h, double points) {
    return std::min(1.0, 1 / (points * std::abs(std::sin(0.5 * g * h))));
  };
  double sum = 0;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z) {
        const Vec3 g = 2 * pi / l.side * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
        if (x == 0 && y == 0 && z == 0) continue;
        double re = 0, im = 0;
        for (const Vec3& p : l.points) {
          re += std::cos(l.side * dot(g, p)), im += std::sin(l.side * dot(g, p));
        }
        const double amplitude = std::hypot(re, im) / double(l.points.size()) * l.packing() *
                                 std::abs(of_sphere(0.5 * norm(g)) * of_sphere(radius * norm(g)));
        sum += amplitude * std::min({mean(g.x, apart.x, n.x), mean(g.y, apart.y, n.y),
                                     mean(g.z, apart.z, n.z)});
      }
  return sum;
}

PackedJar jar_of(const std::vector<scene::Ball>& balls) {
  return {.balls = balls,
          .diameter = 1,
          .periods = {never, never, never},
          .clearance = [](const Vec3&, double) { return never; }};
}

double mean(const std::vector<LocalPacking>& all) {
  double sum = 0;
  for (const LocalPacking& one : all) sum += one.packing;
  return sum / double(all.size());
}

constexpr double spacing = 1 / std::numbers::phi;  // of the grid, for a few thousand balls

TEST(Packing, common_volume_of_two_spheres_is_that_of_two_caps) {
  states("apart", common_volume(1, 0.5, 1.5), 0, 0, "touching");
  states("inside", common_volume(2, 0.5, 1), 4 * pi / 3 / 8, 1e-15, "the smaller sphere");
  // Equal spheres at the distance of a radius: 5 pi/12 r^3.
  states("equal", common_volume(1, 1, 1), 5 * pi / 12, 1e-14, "two caps of height r/2");
}

TEST(Packing, of_lattices_in_free_space_is_their_own) {
  for (const Lattice& l : {cubic, dense}) {
    const auto balls = l.fill({-7, -7, -7}, {7, 7, 7});
    const auto found = packing_in_bed(jar_of(balls));
    ASSERT_GT(found.size(), 100U);
    states("packing", mean(found), l.packing(), tolerance(l, found, spacing * Vec3{1, 1, 1}),
           "sum over the reciprocal lattice");
  }
}

TEST(Packing, in_a_bed_is_taken_where_the_sphere_is_below_the_centres_of_the_surface) {
  const auto balls = cubic.fill({-7, -7, -7}, {7, 7, 7});
  for (const LocalPacking& one : packing_in_bed(jar_of(balls)))
    for (const double x : {one.at.x, one.at.y, one.at.z}) {
      EXPECT_LE(x + 1.5, 6);  // the outermost centres
      EXPECT_GE(x - 1.5, -7);
    }
}

TEST(Packing, counts_images_however_thin_the_slice) {
  for (const double thin : {1.0, 2.0, 3.0}) {
    const auto balls = cubic.fill({-7, -7, 0}, {7, 7, thin});
    PackedJar jar = jar_of(balls);
    jar.periods = {never, never, thin};
    const auto found = packing_in_bed(jar);
    ASSERT_GT(found.size(), 50U);
    states("packing", mean(found), cubic.packing(),
           tolerance(cubic, found, {spacing, spacing, thin / std::ceil(thin / spacing)}),
           "sum over the reciprocal lattice");
  }
}

TEST(Packing, of_a_periodic_lattice_needs_no_surface) {
  const auto balls = dense.fill({0, 0, 0}, {dense.side * 3, dense.side * 3, dense.side * 3});
  ASSERT_EQ(balls.size(), 108U);
  PackedJar jar = jar_of(balls);
  jar.periods = {dense.side * 3, dense.side * 3, dense.side * 3};
  const auto found = packing_in_bed(jar);
  states("points", double(found.size()), 343, 0, "all: ceil(3 sqrt(2) 1.618)^3");
  // Seven points on three cells: waves of g = 2 pi/side (h, k, l) with h, k and l multiples of 7
  // alone do not cancel: the eight of (7, 7, 7) and six of (14, 0, 0), with transforms of at most
  // 3/x^2, x = 27 of a ball and 81 of the sphere.
  states("packing", mean(found), dense.packing(), dense.packing() * 14 * 9 / (27.0 * 27 * 81 * 81),
         "waves that the grid does not resolve");
}

TEST(Packing, is_not_taken_near_walls_and_a_wall_is_no_surface) {
  const auto balls = cubic.fill({-4, -4, 0.5}, {4, 4, 9});
  PackedJar jar = jar_of(balls);
  jar.clearance = [](const Vec3& p, double) { return p.z; };
  double lowest = never;
  for (const LocalPacking& one : packing_in_bed(jar)) lowest = std::min(lowest, one.at.z);
  // Without the wall, the spheres would be a diameter and a radius above the lowest centres' plane.
  states("lowest point", lowest, 1.5 + 0.5 * spacing, 0.5 * spacing, "a radius above the wall");
}

TEST(Packing, of_balls_that_make_no_bed_has_no_place) {
  EXPECT_TRUE(packing_in_bed(jar_of({})).empty());
  std::vector<scene::Ball> balls = cubic.fill({0, 0, 0}, {3, 3, 3});
  EXPECT_TRUE(packing_in_bed(jar_of(balls)).empty());
  for (scene::Ball& b : balls) b.position = 1e4 * b.position;
  EXPECT_TRUE(packing_in_bed(jar_of(balls)).empty());
}

TEST(Packing, is_not_lowered_by_a_ball_that_flies) {
  std::vector<scene::Ball> balls = cubic.fill({-7, -7, -7}, {7, 7, 7});
  const auto before = packing_in_bed(jar_of(balls));
  balls.push_back({0.5, 1, {0, 0, 30}, {}, {}});
  const auto after = packing_in_bed(jar_of(balls));
  EXPECT_GT(after.size(), 100U);
  states("packing", mean(after), mean(before), 1e-12, "the same bed");
}

TEST(Images, are_as_many_as_the_cells_within_reach) {
  const std::vector<scene::Ball> one{{0.5, 1, {0, 0, 5}, {}, {}}};
  const Images all = images(one, {never, never, 2}, 3.5);
  // Folded to z = 1; images as far as 4.5 from the middle.
  states("balls", double(all.balls.size()), 4, 0, "-3, -1, 1, 3");
  for (const scene::Ball& b : all.balls) EXPECT_LE(std::abs(b.position.z), 4.5);
}

}  // namespace
}  // namespace mahlwerk::observe::packing_test

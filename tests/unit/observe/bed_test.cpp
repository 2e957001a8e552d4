// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The bed is made of the balls that three bodies support, or the jar's side.
#include "mahlwerk/observe/bed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::bed_test {
namespace {

using tests::states;

constexpr double r = 0.005, d = 2 * r;

scene::Ball at(double x, double y, double z) {
  return {r, 7850, {x, y, z}, {}, {}};
}

/// Mass outside the bed in an upright cylinder of 200 mm, in balls.
double outside(const std::vector<scene::Ball>& balls,
               const geometry::AnyShape& jar = geometry::Cylinder{0.2, 0.2}) {
  return mass_outside_bed(balls, jar, {}, 0.1) / balls.front().mass();
}

/// A ball on three others that touch each other, `height` above its place there.
std::vector<scene::Ball> pyramid(double height) {
  const double h = d * std::sqrt(3) / 2;
  return {at(0, 0, 0), at(d, 0, 0), at(d / 2, h, 0),
          at(d / 2, h / 3, d * std::sqrt(2.0 / 3) + height)};
}

TEST(Bed, a_ball_on_three_others_is_in_it_and_the_same_ball_above_them_is_not) {
  // Each of the lower balls touches three, or two if the upper ball is away.
  states("touching", outside(pyramid(0)), 0, 0, "each touches the three others");
  states("a twentieth of a diameter above", outside(pyramid(0.05 * d)), 0, 0, "gaps below 0.1 d");
  states("a diameter above", outside(pyramid(d)), 4, 1e-12, "none has three neighbours");
}

TEST(Bed, a_ball_at_the_side_is_in_it_and_a_ball_at_an_end_is_not_by_that_alone) {
  states("at the side", outside({at(0.1 - r, 0, 0)}), 0, 0, "the wall carries it");
  states("in mid-air", outside({at(0, 0, 0)}), 1, 1e-12, "touches nothing");
  states("at an end", outside({at(0, 0, 0.1 - r)}), 1, 1e-12, "one body");
  std::vector<scene::Ball> two = {at(0, 0, 0.1 - r), at(d, 0, 0.1 - r),
                                  at(d / 2, d * 0.87, 0.1 - r)};
  states("three on an end", outside(two), 0, 0, "two balls and the end");
}

/// A mesh counts as the cylinder about its axis that holds it, here of 100 mm.
TEST(Bed, a_ball_at_the_side_of_a_mesh_is_in_it) {
  const auto in_mesh = [](double x, double y) {
    return outside({at(x, y, 0)}, tests::mesh_of(tests::cylinder(64, 0.2, 0.2)));
  };
  const double near = 0.1 - r - 0.05 * d, away = 0.1 - r - 0.15 * d;  // within 0.1 d, and not
  states("near the side", in_mesh(near, 0), 0, 0, "gaps below 0.1 d");
  states("near the side", in_mesh(0, -near), 0, 0, "gaps below 0.1 d");
  states("near the side", in_mesh(0.6 * near, 0.8 * near), 0, 0, "gaps below 0.1 d");
  states("apart from it", in_mesh(away, 0), 1, 1e-12, "in mid-air");
  states("apart from it", in_mesh(0.6 * away, 0.8 * away), 1, 1e-12, "in mid-air");
}

TEST(Bed, neighbours_are_found_across_a_period_and_whatever_the_number_of_balls) {
  const double h = d * std::sqrt(3) / 2;
  const geometry::AnyShape endless = geometry::PeriodicCylinder{0.2, 4 * d};
  // Two pairs beside each other, one ball of each pair behind the period's end.
  const std::vector<scene::Ball> ring{at(0, 0, -1.5 * d), at(0, 0, 1.5 * d),
                                      at(h, 0, -2 * d + 1e-4),
                                      at(h / 3, d * std::sqrt(2.0 / 3), -2 * d + 1e-4)};
  states("across the period", outside(ring, endless), 0, 0, "each touches the three others");
  states("without it", outside(ring), 4, 1e-12, "apart");
  std::vector<scene::Ball> lattice;  // 8 x 8 x 8 on a cubic lattice; only its corners have fewer
  for (int x = 0; x < 8; ++x)        // than four neighbours, and they have three
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) lattice.push_back(at((x - 4) * d, (y - 4) * d, (z - 4) * d));
  states("cubic lattice", outside(lattice), 0, 0, "every ball has three neighbours");
  for (scene::Ball& b : lattice) b.position = 1.2 * b.position;
  states("spread by a fifth", outside(lattice), 512, 1e-9, "gaps of 0.2 d");
}

/// The grid begins at the first ball. The second has three neighbours, one of them 1.05 diameters
/// away, which is in the next column of 1.1 diameters.
TEST(Bed, a_neighbour_within_the_gap_is_found_in_the_next_column) {
  const double x = 0.85 * d;
  const std::vector<scene::Ball> balls{at(0, 0, 9 * d), at(x, 0, 0), at(x + 1.05 * d, 0, 0),
                                       at(x, 0, d), at(x, 0, -d)};
  states("along x", outside(balls), 4, 1e-12, "all but the one in the middle");
  std::vector<scene::Ball> across = balls;
  for (scene::Ball& b : across) std::swap(b.position.x, b.position.y);
  states("along y", outside(across), 4, 1e-12, "all but the one in the middle");
}

TEST(Bed, the_jar_may_be_turned) {
  const Rotation lying = scene::mounted_along({1, 0, 0});
  const scene::Ball side = at(0, 0.1 - r, 0);
  EXPECT_EQ(mass_outside_bed({side}, geometry::Cylinder{0.2, 0.5}, lying, 0.1), 0);
  EXPECT_GT(mass_outside_bed({at(0.1 - r, 0, 0)}, geometry::Cylinder{0.2, 0.5}, lying, 0.1), 0);
}

}  // namespace
}  // namespace mahlwerk::observe::bed_test

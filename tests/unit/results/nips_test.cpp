// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/nips.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "statement.hpp"

namespace mahlwerk::results::nips_test {
namespace {

using observe::WallGrid;
using observe::WallMap;
using tests::states;

constexpr double ball = 4e-3, jar = 6e-3;  // radii [m]
const double in_sphere = 1 / (1 / ball - 1 / jar), in_cylinder = std::sqrt(ball * in_sphere);

/// A map over a jar of this half length along its axis, hit in one cell; -1: no cell.
WallMap hit_in(double half_length, int cell) {
  WallMap map(WallGrid{.radius = jar, .bottom = -half_length, .top = half_length});
  if (cell >= 0) map.at(cell).energy_normal = 1;
  return map;
}

TEST(Nips, effective_radius_of_a_ball_in_a_sphere_is_that_of_both_curvatures) {
  states("R*", effective_radius(geometry::Sphere{2 * jar}, 0, ball, hit_in(jar, -1)), in_sphere,
         1e-12 * in_sphere, "1/R* = 1/r - 1/R; rounding");
}

TEST(Nips, effective_radius_on_the_side_of_a_cylinder_is_the_mean_of_both_directions) {
  const geometry::Cylinder shape{2 * jar, 0.02};
  const WallMap map = hit_in(0.01, -1);
  double side = 0, flat = 0;
  int sides = 0, flats = 0;
  for (int face = 0; face < 3; ++face) {
    const double found = effective_radius(shape, face, ball, map);
    if (std::string(shape.face_name(face)) == "side")
      side = found, ++sides;
    else
      flat += found, ++flats;
  }
  ASSERT_EQ(sides, 1);
  states("R* on the side", side, in_cylinder, 1e-12 * in_cylinder, "sqrt(r/(1/r - 1/R))");
  states("R* on a flat end", flat / flats, ball, 1e-12, "a plane");
}

TEST(Nips, capsule_counts_where_it_is_hit) {
  const geometry::Capsule shape{2 * jar, 0.02};
  const double half = 0.5 * shape.height + jar;
  // Cells in the middle of the side, and of the bottom disc.
  const int side = (WallGrid::along / 2) * WallGrid::around, disc = WallGrid::side_cells;
  states("hit on the side", effective_radius(shape, 0, ball, hit_in(half, side)), in_cylinder,
         1e-12 * in_cylinder, "a cylinder's");
  states("hit on a cap", effective_radius(shape, 0, ball, hit_in(half, disc)), in_sphere,
         1e-12 * in_sphere, "a sphere's");
  const double anywhere = effective_radius(shape, 0, ball, hit_in(half, -1));
  EXPECT_GT(anywhere, in_cylinder);
  EXPECT_LT(anywhere, in_sphere);
}

}  // namespace
}  // namespace mahlwerk::results::nips_test

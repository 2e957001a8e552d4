// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Degrees of mixing and packing (mix.1, mix.2, mix.5) against closed forms.
#include "mahlwerk/observe/mixing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::mixing_test {
namespace {

using tests::states;

/// A cubic lattice of `side`^3 balls that touch, with the diameter 1.
std::vector<scene::Ball> lattice(int side) {
  std::vector<scene::Ball> balls;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) balls.push_back({0.5, 1, {x + 0.5, y + 0.5, z + 0.5}, {}, {}});
  return balls;
}

TEST(Mixing, of_balls_coloured_at_random_is_one) {
  const auto balls = lattice(24);
  Random random(3, 0);
  double lacey = 0, neighbours = 0;
  constexpr int draws = 20;
  for (int d = 0; d < draws; ++d) {
    std::vector<std::uint8_t> colours;
    for (std::size_t i = 0; i < balls.size(); ++i) colours.push_back(random.uniform(0, 1) < 0.3);
    const MixingIndex m = mixing_index(balls, colours, 3, 1.2);
    lacey += m.lacey / draws, neighbours += m.neighbours / draws;
  }
  // 512 cells of 27 balls: the variance of p(1-p)/n scatters by sqrt(2/512) of itself, 1/26 of the
  // span of the index; four standard errors of 20 draws.
  states("Lacey's index", lacey, 1, 4 * std::sqrt(2.0 / 512) / 26 / std::sqrt(draws), "binomial");
  // 13824 balls of six neighbours each, each pair twice.
  states("neighbours", neighbours, 1, 4 * std::sqrt(0.7 / 0.3 / (3 * 13824.0) / draws), "binomial");
}

TEST(Mixing, of_two_separate_halves_is_zero_but_for_the_balls_at_their_border) {
  const auto balls = lattice(24);
  std::vector<std::uint8_t> colours;
  for (const scene::Ball& b : balls) colours.push_back(b.position.x < 12);
  const MixingIndex m = mixing_index(balls, colours, 3, 1.2);
  states("Lacey's index", m.lacey, 0, 1e-12, "every cell has one colour");
  // Of each half, one layer of 24 has one of its neighbours, 5 inside the lattice and up to 6, in
  // the other colour, over the expected half.
  double expected = 0;
  for (int y = 0; y < 24; ++y)
    for (int z = 0; z < 24; ++z) {
      const int at_edge = (y == 0 || y == 23 ? 1 : 0) + (z == 0 || z == 23 ? 1 : 0);
      expected += 2.0 / (6 - at_edge) / (6912.0 / 13823) / 13824;
    }
  states("neighbours", m.neighbours, expected, 1e-12, "counted");
}

TEST(Mixing, of_one_colour_is_not_defined) {
  const auto balls = lattice(4);
  const MixingIndex m = mixing_index(balls, std::vector<std::uint8_t>(balls.size(), 1), 3, 1.2);
  EXPECT_TRUE(std::isnan(m.lacey));
  EXPECT_TRUE(std::isnan(m.neighbours));
}

TEST(Packing, common_volume_of_two_spheres_is_that_of_two_caps) {
  const double pi = std::numbers::pi;
  states("apart", common_volume(1, 0.5, 1.5), 0, 0, "touching");
  states("inside", common_volume(2, 0.5, 1), 4 * pi / 3 / 8, 1e-15, "the smaller sphere");
  // Equal spheres at the distance of a radius: 5 pi/12 r^3.
  states("equal", common_volume(1, 1, 1), 5 * pi / 12, 1e-14, "two caps of height r/2");
}

TEST(Packing, of_a_face_centred_cubic_lattice_is_that_of_the_densest) {
  std::vector<scene::Ball> balls;
  const double a = std::sqrt(2.0);  // of the cube, for balls of diameter 1
  for (int x = -12; x <= 12; ++x)
    for (int y = -12; y <= 12; ++y)
      for (int z = -12; z <= 12; ++z)
        if ((x + y + z) % 2 == 0)
          balls.push_back({0.5, 1, 0.5 * a * Vec3{1.0 * x, 1.0 * y, 1.0 * z}, {}, {}});
  // A sphere of radius R cuts the shell of balls at its surface at random: the share scatters by
  // about 1/R^2 of a ball; at R = 7 diameters below half a per cent.
  states("packing", packing_around(balls, {0.1, 0.2, 0.05}, 7), std::numbers::pi / std::sqrt(18.0),
         0.005, "pi/sqrt(18)");
}

}  // namespace
}  // namespace mahlwerk::observe::mixing_test

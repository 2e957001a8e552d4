// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Degrees of mixing (mix.1, mix.2) against closed forms.
#include "mahlwerk/observe/mixing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::mixing_test {
namespace {

using tests::states;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr Vec3 endless{never, never, never};

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
    lacey += lacey_index(balls, colours, 3) / draws;
    neighbours += neighbour_index(balls, colours, 1.2, endless) / draws;
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
  states("Lacey's index", lacey_index(balls, colours, 3), 0, 1e-12, "every cell has one colour");
  // Of each half, one layer of 24 has one of its neighbours, 5 inside the lattice and up to 6, in
  // the other colour, over the expected half.
  double expected = 0;
  for (int y = 0; y < 24; ++y)
    for (int z = 0; z < 24; ++z) {
      const int at_edge = (y == 0 || y == 23 ? 1 : 0) + (z == 0 || z == 23 ? 1 : 0);
      expected += 2.0 / (6 - at_edge) / (6912.0 / 13823) / 13824;
    }
  states("neighbours", neighbour_index(balls, colours, 1.2, endless), expected, 1e-12, "counted");
}

TEST(Mixing, of_one_colour_is_not_defined) {
  const auto balls = lattice(4);
  const std::vector<std::uint8_t> one(balls.size(), 1);
  EXPECT_TRUE(std::isnan(lacey_index(balls, one, 3)));
  EXPECT_TRUE(std::isnan(neighbour_index(balls, one, 1.2, endless)));
}

TEST(Mixing, of_a_periodic_jar_has_neighbours_beyond_its_boundaries) {
  // Two layers of each colour in turn, without ends: one of the six neighbours has the other one.
  const auto balls = lattice(8);
  std::vector<std::uint8_t> colours;
  for (const scene::Ball& b : balls) colours.push_back(std::fmod(b.position.x, 4) < 2);
  states("neighbours", neighbour_index(balls, colours, 1.2, {8, 8, 8}), 1.0 / 6 / (256.0 / 511),
         1e-12, "counted");
  // In slices of one layer, the four neighbours in the layer and no image of the ball itself.
  std::vector<scene::Ball> slice;
  std::vector<std::uint8_t> of_slice;
  for (const scene::Ball& b : balls)
    if (b.position.z < 1) {
      slice.push_back(b);
      of_slice.push_back(std::fmod(b.position.x, 4) < 2);
    }
  states("neighbours in a layer", neighbour_index(slice, of_slice, 1.2, {8, 8, 1}),
         1.0 / 4 / (32.0 / 63), 1e-12, "counted");
}

}  // namespace
}  // namespace mahlwerk::observe::mixing_test

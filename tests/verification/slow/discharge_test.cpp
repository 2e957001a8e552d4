// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The discharge of grains through a round hole in a flat floor, beside Beverloo's law (flo.8).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::discharge_test {
namespace {

constexpr double d = 0.002, density = 2500, wide = 0.032, top_of_floor = -0.028;

class Outflow final : public scene::Observer {
 public:
  void collisions(std::span<const scene::Collision>) override {}
  void passages(std::span<const scene::Passage> passed) override {
    for (const scene::Passage& p : passed)
      if (p.entered == 0) ++count, mass += p.mass;
  }
  double count = 0, mass = 0;
};

std::vector<scene::Ball> bed(int count) {
  std::vector<scene::Ball> balls;
  const double pitch = 1.08 * d;
  Random random(3, 0);
  for (double z = top_of_floor + pitch; static_cast<int>(balls.size()) < count; z += pitch)
    for (double x = -0.5 * wide; x < 0.5 * wide; x += pitch)
      for (double y = -0.5 * wide; y < 0.5 * wide; y += pitch) {
        if (std::hypot(x, y) > 0.5 * wide - 0.52 * d || static_cast<int>(balls.size()) == count)
          continue;
        const Vec3 heading = random.direction();
        balls.push_back({.radius = 0.5 * d,
                         .density = density,
                         .position = {x, y, z},
                         .velocity = 0.1 * heading,
                         .spin = {}});
      }
  return balls;
}

/// Mass rate [kg/s] and bulk density [kg/m3] of a hopper whose balls circulate.
struct Discharge {
  double rate = 0, bulk = 0, count = 0;
};
Discharge discharge(double hole) {
  scene::Chamber jar{geometry::Cylinder{wide, 0.09}, kinematics::Still{}, {}, {0, 0, -gravity}};
  scene::MachinePart floor;
  floor.solid = geometry::AnySolid(geometry::RingSolid{1.1 * wide, hole, 0.002});
  floor.position = {0, 0, top_of_floor - 0.001};
  jar.parts.push_back(floor);
  soft::Settings rules{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), 1e-5, true};
  rules.flow = scene::Flow{.outlet = {0, 0, top_of_floor - 0.004},
                           .outlet_normal = {0, 0, -1},
                           .feed = scene::Flow::Feed::recirculate,
                           .axes = {},
                           .inlet = {0, 0, 0.035},
                           .inlet_size = {0.022, 0.022, 0.014}};
  contact::Pair pair = pair_of({5e6, 0.3}, {5e6, 0.3}, 0.6, 0.5);
  pair.rolling_friction = 0.02;
  const auto run = soft::make_engine(
      jar, bed(2500), rules, contact::PairTable(1, soft::moving_wall(jar)->faces(), pair), 0);
  Outflow seen;
  run->advance(0.2, seen);
  seen = {};
  constexpr double time = 0.5;
  constexpr int samples = 20;
  // The bed from 2 d to 14 mm above the floor, away from its top.
  const double low = top_of_floor + 2 * d, high = top_of_floor + 0.014;
  double within = 0;
  for (int k = 1; k <= samples; ++k) {
    run->advance(0.2 + time * k / samples, seen);
    for (const scene::Ball& b : run->balls())
      if (!b.outside && b.position.z > low && b.position.z < high) within += b.mass();
  }
  const double volume = std::numbers::pi / 4 * wide * wide * (high - low);
  return {seen.mass / time, within / samples / volume, seen.count};
}

TEST(Discharge, through_a_hole_follows_the_law_of_beverloo) {
  const std::array<double, 3> holes{0.009, 0.011, 0.013};
  // w^(2/5) is a straight line of the hole: a (D - k d).
  double sx = 0, sy = 0, sxx = 0, sxy = 0, bulk = 0, few = 1e9;
  std::array<double, 3> root{};
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Discharge found = discharge(holes[i]);
    std::printf("    D = %.0f mm: %.4g kg/s, %.0f balls, bulk density %.4g kg/m3\n", 1e3 * holes[i],
                found.rate, found.count, found.bulk);
    root[i] = std::pow(found.rate, 0.4);
    sx += holes[i], sy += root[i], sxx += holes[i] * holes[i], sxy += holes[i] * root[i];
    bulk += found.bulk / 3;
    few = std::min(few, found.count);
  }
  const double a = (3 * sxy - sx * sy) / (3 * sxx - sx * sx), b = (sy - a * sx) / 3;
  const double k = -b / a / d, c = std::pow(a, 2.5) / (bulk * std::sqrt(gravity));
  // At worst the counts are off by their square root: 0.4/sqrt(count) of a root, over the range of
  // the roots for the slope.
  const double error = 0.4 / std::sqrt(few);
  double off = 0;
  for (std::size_t i = 0; i < holes.size(); ++i)
    off = std::max(off, std::abs(root[i] - a * holes[i] - b) / root[i]);
  const double with_14 = std::log(std::pow(root[2] / root[0], 2.5)) /
                         std::log((holes[2] - 1.4 * d) / (holes[0] - 1.4 * d));
  stays_below("deviation of w^(2/5) from a line of D, relative", off, 2 * error,
              "Beverloo et al. 1961 (flo.8)");
  states("exponent of D - 1.4 d", with_14, 2.5, 0.3, "Beverloo et al. 1961: 5/2");
  states("C", c, 0.6, 0.1, "0.55 to 0.65 (flo.8)");
  states("k", k, 1.5, 0.7, "1 to 2 (flo.8)");
}

}  // namespace
}  // namespace mahlwerk::tests::discharge_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/jar_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::measure::jar_sizes_test {
namespace {

constexpr double pi = std::numbers::pi, water = 998.2;

std::vector<double> about(double value) {
  return {value, value * 1.001, value * 0.999};
}

TEST(JarSizes, of_a_capsule_are_diameter_and_height_of_its_cylinder) {
  const double d = 0.0267, length = 0.0536,
               volume = pi * d * d * (length - d) / 4 + pi * d * d * d / 6;
  const JarFound found = jar_sizes("capsule",
                                   {.diameter = about(d),
                                    .depth = about(length),
                                    .water = about(water * volume),
                                    .empty = {},
                                    .full = {},
                                    .wall = {0.003}},
                                   {});
  ASSERT_EQ(found.sizes.list.size(), 3U);
  EXPECT_NEAR(found.sizes.list[1].value.mean, length - d, 1e-9);
  EXPECT_NEAR(found.sizes.list[1].value.ci95,
              std::hypot(std::hypot(4.303 * 1e-3 * d / std::sqrt(3.0), 1e-4),
                         std::hypot(4.303 * 1e-3 * length / std::sqrt(3.0), 1e-4)),
              1e-6);
  EXPECT_NEAR(found.volume.mean, volume, 1e-9);
  EXPECT_NEAR(found.by_sizes.mean, volume, 1e-12);
  EXPECT_TRUE(found.sizes.remarks.empty());
}

TEST(JarSizes, of_a_rounded_cylinder_have_the_fillet_that_makes_the_volume) {
  const double r = 0.03, h = 0.05, fillet = 0.008;
  const double zone =
      pi * ((r - fillet) * (r - fillet) * fillet + (r - fillet) * pi * fillet * fillet / 2 +
            2 * fillet * fillet * fillet / 3);
  const double volume = pi * r * r * (h - 2 * fillet) + 2 * zone;
  const JarFound found = jar_sizes("rounded-cylinder",
                                   {.diameter = {2 * r},
                                    .depth = {h},
                                    .water = {},
                                    .empty = {0.5},
                                    .full = {0.5 + water * volume},
                                    .wall = {}},
                                   {});
  EXPECT_EQ(found.sizes.list[2].key, "jar.fillet");
  EXPECT_NEAR(found.sizes.list[2].value.mean, fillet, 1e-6);
}

TEST(JarSizes, of_a_sphere_and_a_cylinder_make_their_volume) {
  EXPECT_NEAR(
      jar_sizes("sphere",
                {.diameter = {0.05}, .depth = {}, .water = {}, .empty = {}, .full = {}, .wall = {}},
                {})
          .by_sizes.mean,
      pi * 0.05 * 0.05 * 0.05 / 6, 1e-12);
  EXPECT_NEAR(
      jar_sizes(
          "cylinder",
          {.diameter = {0.05}, .depth = {0.06}, .water = {}, .empty = {}, .full = {}, .wall = {}},
          {})
          .by_sizes.mean,
      pi * 0.05 * 0.05 * 0.06 / 4, 1e-12);
}

TEST(JarSizes, that_water_contradicts_are_refused) {
  const auto refused = [](std::string_view shape, const JarReadings& readings) {
    try {
      jar_sizes(shape, readings, {});
    } catch (const InputError& e) {
      return e.faults().front().what;
    }
    return std::string();
  };
  JarReadings jar{
      .diameter = {0.05}, .depth = {0.06}, .water = {0.2}, .empty = {}, .full = {}, .wall = {}};
  EXPECT_NE(refused("cylinder", jar).find("one of them is wrong"), std::string::npos);
  jar.water = {0.120};
  const JarFound near = jar_sizes("cylinder", jar, {});
  ASSERT_FALSE(near.sizes.remarks.empty());
  EXPECT_NE(near.sizes.remarks.front().find("not quite a cylinder"), std::string::npos);
  jar.depth = {0.04};
  EXPECT_NE(refused("capsule", jar).find("less than the diameter"), std::string::npos);
  jar.depth = {};
  EXPECT_NE(refused("cylinder", jar).find("no depth"), std::string::npos);
  jar.depth = {-1};
  EXPECT_NE(refused("cylinder", jar).find("a depth is -1"), std::string::npos);
  jar.water = {};
  EXPECT_NE(refused("rounded-cylinder", jar).find("follows from the volume"), std::string::npos);
  EXPECT_NE(refused("box", jar).find("not measured so"), std::string::npos);
  jar.empty = {0.5};
  jar.full = {0.4};
  EXPECT_NE(refused("cylinder", jar).find("no heavier"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::measure::jar_sizes_test

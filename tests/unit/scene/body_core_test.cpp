// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Features of bodies at points of their surface.
#include "mahlwerk/scene/body_core.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::tests::body_core_test {
namespace {

using scene::BodyCore;
using scene::BodyFeature;

constexpr double degree = std::numbers::pi / 180;

std::string feature_at(const scene::Solid& solid, const Vec3& point) {
  const BodyCore core(solid.shape());
  return std::string(name_of(core.feature_at(point / solid.equivalent_radius())));
}

/// The point at `angle` from the axis on the rounded rim of a cylinder of 10 mm.
Vec3 on_rim(const scene::Solid& cylinder, double angle) {
  double radius = 0;  // of the spheres of the rim
  for (const geometry::MemberSphere& s : cylinder.spheres)
    if (std::hypot(s.centre.x, s.centre.y) > 1e-4) radius = s.radius;
  const double core = 0.005 - radius;
  return {core + radius * std::sin(angle), 0, core + radius * std::cos(angle)};
}

TEST(BodyCore, of_a_cylinder_tells_end_rim_and_side) {
  const scene::Solid cylinder = scene::cylinder_of_spheres(0.01, 0.01, 47);
  EXPECT_EQ(feature_at(cylinder, {0, 0, 0.005}), "face");
  EXPECT_EQ(feature_at(cylinder, {0.002, 0.001, -0.0049}), "face") << "in a groove";
  EXPECT_EQ(feature_at(cylinder, {0.005, 0, 0.001}), "side");
  EXPECT_EQ(feature_at(cylinder, {0, -0.0049, 0}), "side");
  for (const double angle : {0.0, 22.0})
    EXPECT_EQ(feature_at(cylinder, on_rim(cylinder, angle * degree)), "face") << angle;
  for (const double angle : {23.0, 45.0, 67.0})
    EXPECT_EQ(feature_at(cylinder, on_rim(cylinder, angle * degree)), "edge") << angle;
  for (const double angle : {68.0, 90.0})
    EXPECT_EQ(feature_at(cylinder, on_rim(cylinder, angle * degree)), "side") << angle;
}

TEST(BodyCore, of_a_rod_tells_side_and_cap) {
  const scene::Solid rod = scene::rod_of_spheres(0.01, 0.03, 5);
  EXPECT_EQ(feature_at(rod, {0, 0, 0.015}), "cap");
  EXPECT_EQ(feature_at(rod, {0, 0.005, 0.009}), "side");
  EXPECT_EQ(feature_at(rod, {0.005, 0, -0.010}), "side") << "flat on a floor, on its last sphere";
  EXPECT_EQ(feature_at(rod, {0.0035, 0, -0.0135}), "cap") << "at 45 degrees";
}

TEST(BodyCore, of_a_cube_tells_faces_edges_and_corners) {
  const scene::Solid cube = scene::cube_of_spheres(0.01, 0.001, 60);
  const double b = 0.004, r = 0.001;
  EXPECT_EQ(feature_at(cube, {0, 0.001, -0.005}), "face");
  EXPECT_EQ(feature_at(cube, {b, b, 0.005}), "face") << "flat on its corners";
  EXPECT_EQ(feature_at(cube, {b + 0.7 * r, -b - 0.7 * r, 0}), "edge");
  EXPECT_EQ(feature_at(cube, {b + 0.7 * r, -b - 0.7 * r, b}), "edge") << "on two corners";
  EXPECT_EQ(feature_at(cube, {b + 0.57 * r, -b - 0.57 * r, b + 0.57 * r}), "corner");
}

/// The directions next to the 6 faces, 12 edges and 8 corners among all directions of a corner:
/// solid angles of the cells of the 26 directions, by Monte Carlo with another rule: the nearest of
/// the 26.
TEST(BodyCore, gives_a_corner_the_feature_of_the_nearest_direction) {
  const scene::Solid cube = scene::cube_of_spheres(0.01, 0.001, 60);
  Random random(1, 0);
  for (int k = 0; k < 2000; ++k) {
    Vec3 n = random.direction();
    n = {std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    double best = 0;
    int kind = 0;
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        for (int z = 0; z < 2; ++z) {
          const int count = x + y + z;
          if (count == 0) continue;
          const double along = (x * n.x + y * n.y + z * n.z) / std::sqrt(count);
          if (along > best) best = along, kind = count;
        }
    const std::string expected = kind == 1 ? "face" : kind == 2 ? "edge" : "corner";
    EXPECT_EQ(feature_at(cube, Vec3{0.004, 0.004, 0.004} + 0.001 * n), expected);
  }
}

TEST(BodyCore, of_spheres_ellipsoids_and_plain_clumps_has_no_features) {
  EXPECT_EQ(feature_at(scene::ellipsoid_of_spheres(0.01, 0.02, 9), {0, 0, 0.01}), "none");
  const scene::Solid cylinder = scene::cylinder_of_spheres(0.01, 0.01, 47);
  EXPECT_EQ(feature_at(scene::clump(cylinder.spheres), {0, 0, 0.005}), "none");
  for (const BodyFeature f : scene::body_features) {
    EXPECT_FALSE(has_feature(scene::SolidKind::ellipsoid, f));
    EXPECT_FALSE(has_feature(scene::SolidKind::none, f));
  }
}

}  // namespace
}  // namespace mahlwerk::tests::body_core_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Solids in a jar (geo.19): distances and normals from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::geometry::solid_test {
namespace {

using tests::stays_below;

/// [m] Distance of p from the nearest of many points of the frustum's surface.
double sampled_distance(const Frustum& f, const Vec3& p) {
  // Of revolution: in the half plane of p, where the meridian is three segments.
  const double r = std::hypot(p.x, p.y), half = 0.5 * f.length;
  const double corners[4][2] = {
      {0, -half}, {f.low_radius, -half}, {f.high_radius, half}, {0, half}};
  double least = 1e9;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i <= 20000; ++i) {
      const double s = i / 20000.0;
      const double x = corners[k][0] + s * (corners[k + 1][0] - corners[k][0]);
      const double z = corners[k][1] + s * (corners[k + 1][1] - corners[k][1]);
      least = std::min(least, std::hypot(r - x, p.z - z));
    }
  return least;
}

TEST(Solid, of_revolution_is_as_far_as_the_nearest_point_of_its_surface) {
  Random random(3, 0);
  double worst = 0;
  for (const Frustum& f : {Frustum{0.02, 0.02, 0.03}, Frustum{0.03, 0.01, 0.02},
                           Frustum{0.01, 0.03, 0.02}, Frustum{0.02, 0, 0.03}})
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = 0.05 * random.uniform(0, 1) * random.direction();
      const Gap gap = f.gap(p);
      worst = std::max(worst, std::abs(std::abs(gap.distance) - sampled_distance(f, p)));
    }
  // The samples are 3e-6 m apart at most.
  stays_below("error of the distance [m]", worst, 3e-6, "distance to the meridian");
}

TEST(Solid, that_is_a_ring_is_as_far_as_the_nearest_point_of_its_rectangle) {
  const RingSolid ring{0.06, 0.03, 0.01};
  Random random(6, 0);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 0.05 * random.uniform(0, 1) * random.direction();
    const double r = std::hypot(p.x, p.y);
    double least = 1e9;  // to the four sides of the rectangle of radius and height
    for (int k = 0; k <= 20000; ++k) {
      const double x = 0.015 + 0.015 * k / 20000, z = -0.005 + 0.01 * k / 20000;
      for (const auto& [a, b] : {std::pair(x, 0.005), {x, -0.005}, {0.015, z}, {0.03, z}})
        least = std::min(least, std::hypot(r - a, p.z - b));
    }
    const bool inside = r > 0.015 && r < 0.03 && std::abs(p.z) < 0.005;
    worst = std::max(worst, std::abs(ring.clearance(p) - (inside ? -least : least)));
  }
  stays_below("error of the distance of a ring [m]", worst, 1e-6, "distance to the rectangle");
}

template <class S>
void expect_unit_gradient(const S& solid) {
  Random random(4, 0);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 0.05 * random.direction() * random.uniform(0.2, 1);
    const Gap gap = solid.gap(0, p, never);
    if (!(gap.distance > 1e-4)) continue;
    constexpr double h = 1e-7;
    const auto at = [&](const Vec3& d) { return solid.gap(0, p + h * d, never).distance; };
    const Vec3 slope{(at({1, 0, 0}) - at({-1, 0, 0})) / (2 * h),
                     (at({0, 1, 0}) - at({0, -1, 0})) / (2 * h),
                     (at({0, 0, 1}) - at({0, 0, -1})) / (2 * h)};
    EXPECT_LT(norm(slope - gap.inward), 1e-4) << S::name << " " << i;
    EXPECT_NEAR(norm(gap.inward), 1, 1e-12);
    EXPECT_EQ(solid.clearance(p), gap.distance);
  }
}

TEST(Solid, has_the_gradient_of_its_distance_as_normal) {
  ConeSolid cone;
  cone.diameter = 0.05, cone.top_diameter = 0.02, cone.length = 0.03;
  DiscSolid disc;
  disc.diameter = 0.06, disc.thickness = 0.005;
  CylinderSolid bar;
  bar.diameter = 0.01, bar.length = 0.05;
  expect_unit_gradient(cone);
  expect_unit_gradient(disc);
  expect_unit_gradient(bar);
  expect_unit_gradient(RingSolid{0.06, 0.03, 0.01});
  expect_unit_gradient(BladeSolid{0.05, 0.004, 0.02});
  expect_unit_gradient(PlaneSolid{});
}

TEST(Solid, of_triangles_is_the_blade_that_they_bound) {
  const BladeSolid blade{0.03, 0.02, 0.01};
  for (const bool inside_out : {false, true}) {
    Surface surface = weld(tests::box(0.03, 0.02, 0.01));
    if (inside_out)
      for (auto& t : surface.triangles) std::swap(t[1], t[2]);
    ASSERT_FALSE(flaw_of_part(surface).has_value());
    const MeshSolid mesh(surface, 0.5);
    EXPECT_EQ(mesh.faces, 6);
    EXPECT_FALSE(mesh.is_sheet());
    Random random(5, 0);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = 0.03 * random.direction() * random.uniform(0.1, 1);
      EXPECT_NEAR(mesh.clearance(p), blade.clearance(p), 1e-15);
      if (!(blade.clearance(p) > 1e-6)) continue;
      Gap nearest{never, {}, 0};
      for (int face = 0; face < mesh.faces; ++face)
        if (const Gap gap = mesh.gap(face, p, 1.0); gap.distance < nearest.distance) nearest = gap;
      EXPECT_NEAR(nearest.distance, blade.clearance(p), 1e-15);
      EXPECT_LT(norm(nearest.inward - blade.gap(0, p, never).inward), 1e-9);
    }
  }
}

std::vector<Corners> moved(std::vector<Corners> triangles, const Vec3& way) {
  for (Corners& c : triangles)
    for (Vec3& p : c) p += way;
  return triangles;
}
std::vector<Corners> inside_out(std::vector<Corners> triangles) {
  for (Corners& c : triangles) std::swap(c[1], c[2]);
  return triangles;
}

/// [m] Largest deviation of a mesh's distance from the given one, at random points within 60 mm.
template <class Distance>
double distance_error(const MeshSolid& mesh, const Distance& distance) {
  Random random(6, 0);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06),
                 random.uniform(-0.06, 0.06)};
    worst = std::max(worst, std::abs(mesh.clearance(p) - distance(p)));
  }
  return worst;
}

/// Each body of a file has an inside of its own, whatever way the normals of the others point.
TEST(Solid, of_several_bodies_of_triangles_is_all_of_them_whichever_is_inside_out) {
  const BladeSolid large{0.03, 0.02, 0.04}, small{0.01, 0.02, 0.01};
  const Vec3 to_large{-0.03, 0, 0}, to_small{0.02, 0.01, 0};
  const std::vector<Corners> one = moved(tests::box(0.03, 0.02, 0.04), to_large),
                             other = moved(tests::box(0.01, 0.02, 0.01), to_small);
  const auto distance = [&](const Vec3& p) {
    return std::min(large.clearance(p - to_large), small.clearance(p - to_small));
  };
  for (const bool one_turned : {false, true})
    for (const bool other_turned : {false, true}) {
      std::vector<Corners> all = one_turned ? inside_out(one) : one;
      const std::vector<Corners> more = other_turned ? inside_out(other) : other;
      all.insert(all.end(), more.begin(), more.end());
      const MeshSolid mesh(weld(all), 0.5);
      stays_below("error of the distance of two bodies [m]", distance_error(mesh, distance), 1e-15,
                  "distance to the nearest of two cuboids, rounding");
    }
}

/// The surface of a cavity faces the cavity: there is no material in it.
TEST(Solid, of_triangles_with_a_cavity_is_hollow_whichever_way_its_surfaces_face) {
  const BladeSolid outside{0.08, 0.08, 0.08}, cavity{0.04, 0.05, 0.06};
  const std::vector<Corners> shell = tests::box(0.08, 0.08, 0.08),
                             hollow = tests::box(0.04, 0.05, 0.06);
  // Of the two surfaces the nearer counts; the material is between them.
  const auto distance = [&](const Vec3& p) {
    const double out = outside.clearance(p), in = -cavity.clearance(p);
    return std::abs(out) < std::abs(in) ? out : in;
  };
  for (const bool shell_turned : {false, true})
    for (const bool hollow_turned : {false, true}) {
      std::vector<Corners> all = shell_turned ? inside_out(shell) : shell;
      const std::vector<Corners> more = hollow_turned ? inside_out(hollow) : hollow;
      all.insert(all.end(), more.begin(), more.end());
      const MeshSolid mesh(weld(all), 0.5);
      stays_below("error of the distance of a hollow body [m]", distance_error(mesh, distance),
                  1e-15, "distance to the nearer surface, rounding");
    }
}

TEST(Solid, that_is_open_is_touched_from_both_sides_and_at_its_rim) {
  const double w = 0.02;
  const std::vector<Corners> square{{Vec3{-w, -w, 0}, {w, -w, 0}, {w, w, 0}},
                                    {Vec3{-w, -w, 0}, {w, w, 0}, {-w, w, 0}}};
  const Surface surface = weld(square);
  const MeshSolid sheet(surface, 0.5);
  EXPECT_TRUE(sheet.is_sheet());
  EXPECT_EQ(sheet.faces, 2);
  const auto nearest = [&](const Vec3& p) {
    Gap found{never, {}, 0};
    for (int face = 0; face < sheet.faces; ++face)
      if (const Gap gap = sheet.gap(face, p, 1.0); gap.distance < found.distance) found = gap;
    return found;
  };
  for (const double z : {0.003, -0.003}) {
    const Gap gap = nearest({0.001, 0.002, z});
    EXPECT_NEAR(gap.distance, 0.003, 1e-15);
    EXPECT_NEAR(gap.inward.z, z > 0 ? 1 : -1, 1e-12);
  }
  const Gap rim = nearest({w + 0.004, 0, 0.003});
  EXPECT_NEAR(rim.distance, 0.005, 1e-15);
  EXPECT_NEAR(rim.inward.x, 0.8, 1e-12);
  EXPECT_NEAR(rim.inward.z, 0.6, 1e-12);
  EXPECT_NEAR(nearest({w + 0.003, w + 0.004, 0}).distance, 0.005, 1e-15);
}

TEST(Solid, of_which_three_triangles_meet_at_an_edge_is_refused) {
  const std::vector<Corners> fin{{Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                 {Vec3{1, 0, 0}, {0, 0, 0}, {0, 0, 1}},
                                 {Vec3{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}};
  const auto flaw = flaw_of_part(weld(fin));
  ASSERT_TRUE(flaw.has_value());
  EXPECT_EQ(flaw->kind, Flaw::Kind::non_manifold);
}

}  // namespace
}  // namespace mahlwerk::geometry::solid_test

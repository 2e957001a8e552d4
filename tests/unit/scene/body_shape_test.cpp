// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/scene/body_shape.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "statement.hpp"

namespace mahlwerk::tests::body_shape_test {
namespace {

constexpr double pi = std::numbers::pi;

/// The union of very many spheres is nearly the solid that they stand for.
void resembles(const std::string& what, const scene::Solid& solid, double tolerance) {
  const geometry::SolidMoments m =
      geometry::union_moments(solid.spheres, 300, geometry::Hollows::filled);
  states(what + ": volume of the spheres over that of the solid", m.volume / solid.volume, 1,
         tolerance, "bod.2");
  const Vec3 &s = m.squares, inertia = {s.y + s.z, s.z + s.x, s.x + s.y};
  states(what + ": moment about x", inertia.x / solid.inertia.x, 1, 2 * tolerance,
         "bod.3 to bod.6");
  states(what + ": moment about z", inertia.z / solid.inertia.z, 1, 2 * tolerance,
         "bod.3 to bod.6");
}

TEST(BodyShape, fine_clumps_have_volume_and_inertia_of_the_solid) {
  resembles("rod", scene::rod_of_spheres(0.01, 0.03, 60), 0.002);
  resembles("ellipsoid", scene::ellipsoid_of_spheres(0.01, 0.02, 60), 0.002);
  resembles("cube", scene::cube_of_spheres(0.01, 0.002, 1500), 0.01);
  resembles("cylinder", scene::cylinder_of_spheres(0.01, 0.01, 1500), 0.03);
}

TEST(BodyShape, spheres_stay_within_the_solid) {
  const double d = 0.01, l = 0.012;
  for (const auto& s : scene::cylinder_of_spheres(d, l, 30).spheres) {
    EXPECT_LE(std::hypot(s.centre.x, s.centre.y) + s.radius, 0.5 * d * (1 + 1e-12));
    EXPECT_LE(std::abs(s.centre.z) + s.radius, 0.5 * l * (1 + 1e-12));
  }
  for (const auto& s : scene::cube_of_spheres(d, 0.3 * d, 40).spheres)
    for (const double x : {s.centre.x, s.centre.y, s.centre.z})
      EXPECT_LE(std::abs(x) + s.radius, 0.5 * d * (1 + 1e-12));
}

TEST(BodyShape, number_of_spheres_is_at_most_what_was_asked) {
  for (const int most : {25, 40, 100, 400}) {
    EXPECT_LE(scene::cylinder_of_spheres(0.01, 0.01, most).spheres.size(), std::size_t(most));
    EXPECT_LE(scene::cube_of_spheres(0.01, 0.002, most).spheres.size(), std::size_t(most));
  }
}

/// Moments of a solid of revolution by the midpoint rule over slices.
TEST(BodyShape, rounded_cylinder_has_the_moments_of_its_slices) {
  const double d = 0.01, l = 0.016, r = 0.0015, half = l / 2;
  double volume = 0, along = 0, across = 0;
  constexpr int slices = 200000;
  for (int k = 0; k < slices; ++k) {
    const double z = half * (k + 0.5) / slices, t = std::max(z - (half - r), 0.0);
    const double w = d / 2 - r + std::sqrt(r * r - t * t), area = 2 * pi * w * w * half / slices;
    volume += area, along += area * w * w / 2, across += area * (w * w / 4 + z * z);
  }
  const scene::Solid solid = scene::rounded_cylinder(d, l, r);
  states("volume", solid.volume / volume, 1, 1e-7, "bod.23; 2e5 slices");
  states("moment along", solid.inertia.z / along, 1, 1e-7, "bod.23");
  states("moment across", solid.inertia.x / across, 1, 1e-7, "bod.23");
}

TEST(BodyShape, rounded_bodies_end_in_cylinder_cube_and_sphere) {
  const double d = 0.01;
  const scene::Solid sharp = scene::rounded_cylinder(d, 1.5 * d, 1e-9 * d),
                     plain = scene::cylinder_of_spheres(d, 1.5 * d, 0);
  states("sharp cylinder: volume", sharp.volume / plain.volume, 1, 1e-8, "bod.3");
  states("sharp cylinder: moment across", sharp.inertia.x / plain.inertia.x, 1, 1e-8, "bod.3");
  const scene::Solid round = scene::rounded_cylinder(d, d, d / 2 * (1 - 1e-12));
  states("all rounding: volume of a sphere", round.volume / (pi / 6 * d * d * d), 1, 1e-9,
         "bod.23");
  states("all rounding: moments", round.inertia.x / (round.volume * d * d / 10), 1, 1e-9,
         "2/5 m R^2");
  EXPECT_EQ(scene::rounded_cube(d, 0.1 * d).inertia.x,
            scene::cube_of_spheres(d, 0.1 * d, 9).inertia.x);
  EXPECT_EQ(scene::rounded_rod(d, 2 * d).volume, scene::rod_of_spheres(d, 2 * d, 2).volume);
  // A picture of sharp edges needs no more spheres than others.
  EXPECT_LT(scene::rounded_cube(d, 1e-4 * d).spheres.size(), 700U);
}

TEST(BodyShape, closed_forms_of_the_solids) {
  // A rounded cube without rounding is a cube; one that is all rounding is a sphere.
  const double a = 0.02;
  const scene::Solid sharp = scene::cube_of_spheres(a, 1e-9, 9),
                     ball = scene::cube_of_spheres(a, a / 2, 9);
  states("cube: volume over a^3", sharp.volume / (a * a * a), 1, 1e-5, "a^3");
  states("cube: inertia over m a^2", sharp.inertia.x / (sharp.volume * a * a), 1.0 / 6, 1e-6,
         "1/6");
  states("sphere: volume", ball.volume / (pi / 6 * a * a * a), 1, 1e-12, "pi a^3/6");
  states("sphere: inertia over m R^2", ball.inertia.x / (ball.volume * a * a / 4), 0.4, 1e-12,
         "2/5");
  // A rod of the length of its diameter is a sphere.
  const scene::Solid rod = scene::rod_of_spheres(a, a * (1 + 1e-12), 2);
  states("short rod: inertia across over m R^2", rod.inertia.x / (rod.volume * a * a / 4), 0.4,
         1e-9, "2/5");
  EXPECT_NEAR(scene::cylinder_of_spheres(a, a, 30).equivalent_radius(), std::cbrt(3.0 / 16) * a,
              1e-9);
}

TEST(BodyShape, clump_is_moved_to_its_centre_and_turned_to_its_axes) {
  const std::array<geometry::MemberSphere, 3> three{
      {{{1, 1, 0}, 0.5}, {{2, 2, 0}, 0.5}, {{1.2, 0.8, 0.3}, 0.5}}};
  const scene::Solid solid = scene::clump(three);
  const geometry::SolidMoments m = geometry::union_moments(solid.spheres, 800);
  stays_below("centre of mass", norm(m.centroid), 1e-3, "at the origin");
  stays_below("products over the largest moment", norm(m.products) / norm(m.squares), 2e-3,
              "principal axes");
  // Distances are kept: the axes are orthonormal.
  states("distance of two spheres", norm(solid.spheres[1].centre - solid.spheres[0].centre),
         std::sqrt(2.0), 1e-12, "rotation");
  const Vec3 of_union{m.squares.y + m.squares.z, m.squares.z + m.squares.x,
                      m.squares.x + m.squares.y};
  states("moment about z", of_union.z / solid.inertia.z, 1, 2e-3, "the same solid");
  const double sum = 3 * pi / 6;
  EXPECT_LT(solid.volume, 0.99 * sum) << "what spheres share counts once";
}

TEST(BodyShape, shape_does_not_depend_on_the_size) {
  const scene::BodyShape a = scene::cylinder_of_spheres(0.01, 0.015, 40).shape(),
                         b = scene::cylinder_of_spheres(0.03, 0.045, 40).shape();
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  for (std::size_t k = 0; k < a.spheres.size(); ++k)
    EXPECT_LT(norm(a.spheres[k].centre - b.spheres[k].centre), 1e-12);
  EXPECT_NEAR(a.reach(), b.reach(), 1e-12);
}

}  // namespace
}  // namespace mahlwerk::tests::body_shape_test

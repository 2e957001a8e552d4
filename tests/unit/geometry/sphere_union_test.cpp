// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/sphere_union.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "statement.hpp"

namespace mahlwerk::tests::sphere_union_test {
namespace {

using geometry::MemberSphere;
using geometry::SolidMoments;
constexpr double pi = std::numbers::pi;

/// Integral from 0 to h of z^power (R^2 - (z - c)^2)^k, by Gauss-Legendre with five points, which
/// is exact for these polynomials up to degree nine.
double integral(double h, double c, double radius, int power, int k) {
  constexpr std::array<double, 3> at{0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665,
                                         0.2369268850561891};
  double sum = 0;
  for (std::size_t n = 0; n < 3; ++n)
    for (const double side : {1.0, -1.0}) {
      if (n == 0 && side < 0) continue;
      const double z = 0.5 * h * (1 + side * at[n]), square = radius * radius - (z - c) * (z - c);
      double value = weight[n];
      for (int p = 0; p < power; ++p) value *= z;
      for (int p = 0; p < k; ++p) value *= square;
      sum += value;
    }
  return 0.5 * h * sum;
}

/// Two equal spheres whose centres are a distance apart: each is cut by the plane between them.
TEST(SphereUnion, two_overlapping_spheres_have_the_moments_of_their_closed_form) {
  const double r = 1;
  for (const double apart : {0.3, 1.0, 1.7}) {
    const std::array<MemberSphere, 2> both{
        {{{0.2, -0.1, 0.5 * apart}, r}, {{0.2, -0.1, -0.5 * apart}, r}}};
    const SolidMoments m = geometry::union_moments(both);
    const double c = 0.5 * apart, h = c + r;
    const double volume = 2 * pi * integral(h, c, r, 0, 1);
    const double lens = pi * (4 * r + apart) * (2 * r - apart) * (2 * r - apart) / 12;
    const double tolerance = std::pow(400, -1.5);
    states(fmt::format("volume over closed form, {} apart", apart), m.volume / volume, 1, tolerance,
           "caps");
    states("  closed forms agree", volume, 8.0 / 3 * pi * r * r * r - lens, 1e-12, "lens");
    states("  centroid", norm(m.centroid - Vec3{0.2, -0.1, 0}), 0, tolerance, "symmetry");
    states("  integral of z^2", m.squares.z / (2 * pi * integral(h, c, r, 2, 1)), 1, 2 * tolerance,
           "caps");
    for (const double found : {m.squares.x, m.squares.y})
      states("  integral of x^2, y^2", found / (0.5 * pi * integral(h, c, r, 0, 2)), 1,
             2 * tolerance, "caps");
    stays_below("  products", norm(m.products), tolerance, "symmetry");
  }
}

TEST(SphereUnion, what_spheres_share_counts_once) {
  const std::array<MemberSphere, 2> both{{{{0, 0, 0}, 1}, {{0.1, 0.1, 0.1}, 0.5}}};
  const SolidMoments m = geometry::union_moments(both);
  states("volume of a sphere in another", m.volume / (4.0 / 3 * pi), 1, std::pow(400, -1.5),
         "sphere");
}

TEST(SphereUnion, moments_turn_with_the_spheres) {
  // The same two spheres along a diagonal of x and y: products of inertia.
  const double s = std::sqrt(0.5);
  const std::array<MemberSphere, 2> along{{{{0.6, 0, 0}, 1}, {{-0.6, 0, 0}, 1}}},
      turned{{{{0.6 * s, 0.6 * s, 0}, 1}, {{-0.6 * s, -0.6 * s, 0}, 1}}};
  const SolidMoments a = geometry::union_moments(along), b = geometry::union_moments(turned);
  states("xy", b.products.x, 0.5 * (a.squares.x - a.squares.y), 1e-3, "rotation by 45 degrees");
  states("xx", b.squares.x, 0.5 * (a.squares.x + a.squares.y), 1e-3, "rotation by 45 degrees");
}

}  // namespace
}  // namespace mahlwerk::tests::sphere_union_test

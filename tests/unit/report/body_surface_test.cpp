// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/body_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mahlwerk::report::body_surface_test {

double volume(const BodySurface& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.triangles)
    sum += dot(s.vertices[a], cross(s.vertices[b], s.vertices[c])) / 6;
  return sum;
}

/// The surface of a drawn body encloses its volume, outward, and each vertex is at the rounding
/// from the core. The chords of 32 facets about the axis and 24 about an edge leave out at most 1 -
/// sin(t)/t, t = 2 pi/24, of the rounded parts.
TEST(BodySurface, encloses_the_volume_of_the_body) {
  const double t = 2 * std::numbers::pi / 24, tolerance = 1 - std::sin(t) / t;
  for (const scene::Solid& solid :
       {scene::rounded_cube(0.02, 0.002), scene::rounded_cylinder(0.02, 0.03, 0.002),
        scene::rounded_rod(0.01, 0.04)}) {
    const scene::BodyShape shape = solid.shape();
    const BodySurface surface = body_surface(shape);
    const double expected = 4 * std::numbers::pi / 3, found = volume(surface);
    EXPECT_LT(found, expected * (1 + 1e-12));
    EXPECT_NEAR(found, expected, expected * tolerance)
        << "the unit of length is the radius of the sphere of the same volume (bod.1)";
    for (std::size_t k = 0; k < surface.vertices.size(); ++k) {
      const Vec3 n = surface.normals[k];
      EXPECT_NEAR(dot(surface.vertices[k] - shape.core.support(n), n), shape.rounding, 1e-14);
    }
  }
}

}  // namespace mahlwerk::report::body_surface_test

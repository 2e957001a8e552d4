// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "mahlwerk/scene/body_shape.hpp"

// Rounded convex bodies (docs/theory/bodies.md).
namespace mahlwerk::scene {
namespace {

/// Volume and moments of a cylinder with rounded rims (bod.23): a cylinder of the radius R between
/// two caps with the profile a + sqrt(r^2 - t^2) at the height h + t.
void set_moments(Solid& solid, double a, double h, double r) {
  const double s1 = std::numbers::pi * r * r / 4, s2 = 2 * r * r * r / 3,
               s3 = 3 * std::numbers::pi * r * r * r * r / 16,
               s4 = 8 * r * r * r * r * r / 15;                  // of s^n, s = sqrt(r^2 - t^2)
  const double t1_s = r * r * r / 3, t1_s2 = r * r * r * r / 4;  // of t s and t s^2
  const double t2_s = std::numbers::pi * r * r * r * r / 16, t2_s2 = 2 * r * r * r * r * r / 15;
  const double radius = a + r, square = radius * radius;
  const double area = a * a * r + 2 * a * s1 + s2;  // of the squared profile of a cap
  const double fourth = a * a * a * a * r + 4 * a * a * a * s1 + 6 * a * a * s2 + 4 * a * s3 + s4;
  const double heights = h * h * area + 2 * h * (a * a * r * r / 2 + 2 * a * t1_s + t1_s2) +
                         a * a * r * r * r / 3 + 2 * a * t2_s + t2_s2;
  solid.volume = 2 * std::numbers::pi * (square * h + area);
  const double fourth_powers = 2 * (square * square * h + fourth);
  const double along = std::numbers::pi / 2 * fourth_powers;
  const double across = std::numbers::pi / 4 * fourth_powers +
                        2 * std::numbers::pi * (square * h * h * h / 3 + heights);
  solid.inertia = {across, across, along};
}

}  // namespace

Solid rounded_rod(double diameter, double length) {
  Solid rod = rod_of_spheres(diameter, length, usual_spheres_of_rod(diameter, length));
  const double half = (length - diameter) / 2;
  rod.core.corners = {{0, 0, -half}, {0, 0, half}};
  rod.rounding = diameter / 2;
  return rod;
}

Solid rounded_cube(double edge, double rounding) {
  // Sharp edges would need too many spheres in a picture.
  const double drawn = std::max(rounding, edge / 8);
  Solid cube = cube_of_spheres(edge, rounding, 0);  // volume and moments
  cube.spheres = cube_of_spheres(edge, drawn, usual_spheres_of_cube(edge, drawn)).spheres;
  const double half = edge / 2 - rounding;
  for (const double x : {-half, half})
    for (const double y : {-half, half})
      for (const double z : {-half, half}) cube.core.corners.push_back({x, y, z});
  cube.rounding = rounding;
  return cube;
}

Solid rounded_cylinder(double diameter, double length, double rounding) {
  Solid cylinder =
      cylinder_of_spheres(diameter, length, usual_spheres_of_cylinder(diameter, length));
  cylinder.core.radius = diameter / 2 - rounding;
  cylinder.core.half_length = length / 2 - rounding;
  cylinder.rounding = rounding;
  set_moments(cylinder, cylinder.core.radius, cylinder.core.half_length, rounding);
  return cylinder;
}

}  // namespace mahlwerk::scene

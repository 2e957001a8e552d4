// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/ball_shape.hpp"

namespace mahlwerk::cases {

scene::Solid BallShape::solid() const {
  const int count = static_cast<int>(spheres);
  switch (kind) {
    case Kind::cylpebs:
      return scene::cylinder_of_spheres(diameter, length, count);
    case Kind::rod:
      return scene::rod_of_spheres(diameter, length, count);
    case Kind::cube:
      return scene::cube_of_spheres(edge, rounding, count);
    case Kind::ellipsoid:
      return scene::ellipsoid_of_spheres(diameter, length, count);
    default:
      return {};
  }
}

std::int64_t BallShape::usual_spheres() const {
  switch (kind) {
    case Kind::cylpebs:
      return scene::usual_spheres_of_cylinder(diameter, length);
    case Kind::rod:
      return scene::usual_spheres_of_rod(diameter, length);
    case Kind::cube:
      return scene::usual_spheres_of_cube(edge, rounding);
    case Kind::ellipsoid:
      return scene::usual_spheres_of_ellipsoid(diameter, length);
    default:
      return 1;
  }
}

std::int64_t BallShape::fewest_spheres() const {
  constexpr std::int64_t of_a_cube = 9, of_a_row = 2;
  if (kind == Kind::cylpebs) return scene::fewest_in_cylinder(diameter, length);
  return kind == Kind::cube ? of_a_cube : of_a_row;
}

const std::vector<std::string>& body_words() {
  static const std::vector<std::string> words{"sphere", "cylpebs", "rod", "cube", "ellipsoid"};
  return words;
}

}  // namespace mahlwerk::cases

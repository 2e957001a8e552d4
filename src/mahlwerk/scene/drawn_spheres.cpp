// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/scene/drawn_spheres.hpp"

#include <cstddef>

namespace mahlwerk::scene {

DrawnSpheres drawn_spheres(const std::vector<Ball>& balls, const std::vector<BodyShape>& shapes) {
  DrawnSpheres all;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const Ball& ball = balls[b];
    const auto number = static_cast<std::int32_t>(b);
    const auto kind = static_cast<std::size_t>(ball.kind);
    if (kind >= shapes.size() || shapes[kind].is_sphere()) {
      all.spheres.push_back(ball);
      all.of_ball.push_back(number);
      continue;
    }
    const Rotation axes = rotation_of(ball.orientation);
    for (const geometry::MemberSphere& s : shapes[kind].spheres) {
      const Vec3 arm = ball.radius * (axes * s.centre);
      Ball one = ball;
      one.radius = ball.radius * s.radius;
      one.position = ball.position + arm;
      one.velocity = ball.velocity + cross(ball.spin, arm);
      all.spheres.push_back(one);
      all.of_ball.push_back(number);
    }
  }
  return all;
}

}  // namespace mahlwerk::scene

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/body_shape.hpp"

namespace mahlwerk::scene {

/// What pictures show: each ball, or in place of a body its spheres with their places and
/// velocities, each with the number of its ball. `shapes` by Ball::kind; none: all are spheres.
struct DrawnSpheres {
  std::vector<Ball> spheres;
  std::vector<std::int32_t> of_ball;
};
DrawnSpheres drawn_spheres(const std::vector<Ball>& balls, const std::vector<BodyShape>& shapes);

}  // namespace mahlwerk::scene

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/body_shape.hpp"

namespace mahlwerk::report {

/// The surface of a rounded convex body for pictures, in the lengths and axes of its shape. Front
/// sides point outwards.
struct BodySurface {
  std::vector<Vec3> vertices, normals;  ///< all vertices lie on the surface
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// Of a body whose core is a box, a line along z or a cylinder (bod.20).
BodySurface body_surface(const scene::BodyShape& shape);

}  // namespace mahlwerk::report

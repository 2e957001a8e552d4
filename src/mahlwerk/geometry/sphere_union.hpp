// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::geometry {

/// A sphere that belongs to a body.
struct MemberSphere {
  Vec3 centre;        ///< [m] in the axes of the body
  double radius = 0;  ///< [m]
  constexpr bool operator==(const MemberSphere&) const = default;
};

/// Volume and moments of a homogeneous solid of density 1. What several spheres share counts once.
struct SolidMoments {
  double volume = 0;  ///< [m3]
  Vec3 centroid;      ///< [m]
  /// [m5] integrals about the centroid: of x^2, y^2, z^2, and of xy, yz, zx
  Vec3 squares, products;
};

/// What a hollow between spheres counts as: part of the surroundings, or, if spheres stand for a
/// convex solid, part of that.
enum class Hollows { open, filled };

/// The moments of the union of spheres (bod.2): a midpoint rule over columns along z, in which the
/// lengths are exact. `columns` is their number along the longer edge of the box; the relative
/// error of the volume is below columns^-1.5 (tests/unit/geometry/sphere_union_test.cpp).
SolidMoments union_moments(std::span<const MemberSphere> spheres, int columns = 400,
                           Hollows hollows = Hollows::open);

}  // namespace mahlwerk::geometry

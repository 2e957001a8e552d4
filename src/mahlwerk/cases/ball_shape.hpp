// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/scene/body_shape.hpp"

namespace mahlwerk::cases {

/// The shape of the balls of a set by its name and two numbers (docs/theory/bodies.md).
struct BallShape {
  /// What touches: spheres that stand for the shape, or the shape itself with rounded edges.
  enum class Surface { spheres, convex };
  enum class Kind {
    sphere,
    cylpebs,    ///< cylinder with flat ends
    rod,        ///< cylinder with hemispherical ends
    cube,       ///< with rounded edges
    ellipsoid,  ///< of revolution, longer along its axis than across
    clump       ///< spheres that stand for themselves
  };
  Kind kind = Kind::sphere;
  double diameter = 0;       ///< [m] across the axis; not of a cube
  double length = 0;         ///< [m] along the axis; not of a cube
  double edge = 0;           ///< [m] of a cube
  double rounding = 0;       ///< [m] radius of the edges of a cube or of convex cylpebs
  std::int64_t spheres = 0;  ///< largest number of spheres that stand for it
  Surface surface = Surface::spheres;
  std::vector<geometry::MemberSphere> members = {};  ///< of a clump, in axes of its own

  bool is_sphere() const { return kind == Kind::sphere; }
  bool is_convex() const { return surface == Surface::convex; }
  scene::SolidKind solid_kind() const;
  /// Its spheres, scaled so that their volume is that of the solid that they stand for, and mass
  /// and inertia of this solid (bod.15). Of a convex shape they are for pictures; a clump has mass
  /// and inertia of the union of its spheres (bod.2).
  scene::Solid solid() const;
  double scale() const;                                             ///< [1] of the spheres
  std::int64_t count() const { return is_sphere() ? 1 : spheres; }  ///< of spheres, about
  std::int64_t usual_spheres() const;   ///< neighbours are a radius apart
  std::int64_t fewest_spheres() const;  ///< fewer do not make the shape
  bool operator==(const BallShape&) const = default;
};

/// What keeps spheres from making one body: "member 3 overlaps no other"; empty if nothing does.
std::string flaw_of_members(const std::vector<geometry::MemberSphere>& members);
constexpr std::size_t most_members = 200;  ///< of a clump

/// "sphere", "cylpebs", ... in the order of BallShape::Kind.
const std::vector<std::string>& body_words();
/// "spheres", "convex".
const std::vector<std::string>& surface_words();

}  // namespace mahlwerk::cases

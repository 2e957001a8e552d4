// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/geometry/convex_core.hpp"
#include "mahlwerk/geometry/sphere_union.hpp"

namespace mahlwerk::scene {

/// The solid that the spheres of a body stand for; none: they stand for themselves.
enum class SolidKind { none, cylinder, rod, cube, ellipsoid };
/// Whether it has an axis of revolution, which is the third principal axis.
constexpr bool has_axis(SolidKind kind) {
  return kind == SolidKind::cylinder || kind == SolidKind::rod || kind == SolidKind::ellipsoid;
}

/// The shape of the balls of a set that are no spheres (docs/theory/bodies.md), in the principal
/// axes of inertia, the origin at the centre of mass. All lengths are over the radius of the sphere
/// of the same volume, Ball::radius, so that a set of several sizes has one shape.
struct BodyShape {
  /// The spheres that touch other bodies: a clump. None: the body is a sphere. Of a rounded body
  /// they are for pictures only.
  std::vector<geometry::MemberSphere> spheres;
  Vec3 inertia_ratio{0.4, 0.4, 0.4};  ///< [1] principal moments of inertia over m R^2
  SolidKind solid = SolidKind::none;
  /// The core of a rounded convex body, whose surface touches other bodies (bod.20); of a clump
  /// empty.
  geometry::ConvexCore core = {};
  double rounding = 0;  ///< distance of the surface from the core

  bool is_sphere() const { return spheres.empty(); }
  bool is_rounded() const { return !core.is_empty(); }
  /// [1] Radius of the sphere about the centre of mass that holds the body.
  double reach() const;
  /// [1] Mean of the principal moments, Ball::inertia_ratio.
  double mean_inertia_ratio() const {
    return (inertia_ratio.x + inertia_ratio.y + inertia_ratio.z) / 3;
  }
  bool operator==(const BodyShape&) const = default;
};

/// A body as it is described, in m: its spheres, and volume and moments of inertia of the solid
/// that they stand for, of density 1.
struct Solid {
  std::vector<geometry::MemberSphere> spheres;
  double volume = 0;  ///< [m3]
  Vec3 inertia;       ///< [m5] principal, along the axes
  SolidKind kind = SolidKind::none;
  geometry::ConvexCore core = {};  ///< [m] of a rounded convex body, else empty
  double rounding = 0;             ///< [m]

  double equivalent_radius() const;  ///< [m] of the sphere of the same volume (bod.1)
  BodyShape shape() const;
};

/// A clump of spheres that stand for themselves: mass and inertia are those of their union (bod.2).
/// Moved to its centre of mass and turned to its principal axes.
Solid clump(std::span<const geometry::MemberSphere> spheres);

/// A cylinder of `diameter` and `length` [m] with flat ends (bod.3): rings of spheres along its
/// side and in its ends, with spheres of its diameter inside; at most `spheres`, at least
/// fewest_in_cylinder(). Mass and inertia are those of the cylinder. Its length is at least half
/// its diameter.
Solid cylinder_of_spheres(double diameter, double length, int spheres);
int fewest_in_cylinder(double diameter, double length);

/// A rod with hemispherical ends, of `diameter` and overall `length` [m] (bod.4): a row of
/// `spheres` spheres, at least two. Mass and inertia are those of the rod.
Solid rod_of_spheres(double diameter, double length, int spheres);

/// A cube of `edge` [m] with edges rounded to the radius `rounding` [m] (bod.5): a grid of spheres
/// in its surface and one inside; at most `spheres`, at least 9. Mass and inertia are those of the
/// rounded cube.
Solid cube_of_spheres(double edge, double rounding, int spheres);

/// An ellipsoid of revolution of `diameter` across and `length` [m] along its axis, length >=
/// diameter (bod.6): a row of `spheres` inscribed spheres, at least two. Mass and inertia are those
/// of the ellipsoid.
Solid ellipsoid_of_spheres(double diameter, double length, int spheres);

/// The same rod, and the same cube, as rounded convex bodies (bod.20).
Solid rounded_rod(double diameter, double length);
Solid rounded_cube(double edge, double rounding);
/// A cylinder with flat ends whose rims are rounded (bod.23), as a rounded convex body. The
/// rounding is below half of `diameter` and of `length` [m].
Solid rounded_cylinder(double diameter, double length, double rounding);

/// Number of spheres at which neighbours are a radius of the smaller ones apart: what a case uses
/// that gives none.
int usual_spheres_of_cylinder(double diameter, double length);
int usual_spheres_of_rod(double diameter, double length);
int usual_spheres_of_cube(double edge, double rounding);
int usual_spheres_of_ellipsoid(double diameter, double length);

}  // namespace mahlwerk::scene

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/balls.hpp"

// How densely balls are packed.
namespace mahlwerk::observe {

/// [m3] Volume common to two spheres whose centres are `distance` [m] apart.
double common_volume(double a, double b, double distance);
/// Packing fraction around a point: volume of balls within the sphere of `radius` [m] about it over
/// the volume of that sphere (mix.5). Exact for balls that do not overlap.
double packing_around(std::span<const scene::Ball> balls, const Vec3& point, double radius);

/// A jar with balls, in the jar's own axes.
struct PackedJar {
  std::span<const scene::Ball> balls;
  double diameter = 0;  ///< [m] of a ball of mean volume
  Vec3 periods;         ///< [m] as geometry::periods()
  /// [m] Distance of a point from the nearest wall or part; exact up to `within` [m], negative
  /// outside of the jar.
  std::function<double(const Vec3& p, double within)> clearance;
};

/// The packing around one point.
struct LocalPacking {
  Vec3 at;
  double packing = 0;
};

/// [m] Radius of the spheres of packing_in_bed().
inline double packing_radius(const PackedJar& jar) {
  return 1.5 * jar.diameter;
}
/// The packing around the points of a regular grid whose spheres of packing_radius() lie in the
/// bed, clear of walls and parts, and below the centres of the balls at its surface.
std::vector<LocalPacking> packing_in_bed(const PackedJar& jar);

}  // namespace mahlwerk::observe

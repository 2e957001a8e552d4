// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::geometry {

/// The core of a rounded convex body, whose surface lies at a fixed distance, its rounding, from
/// the core (bod.20): the convex hull of points, or a cylinder about the z axis.
struct ConvexCore {
  std::vector<Vec3> corners;           ///< [m] in the axes of the body; of a cylinder none
  double radius = 0, half_length = 0;  ///< [m] of a cylinder; it may be a disc

  bool is_cylinder() const { return corners.empty() && radius > 0; }
  bool is_empty() const { return corners.empty() && !(radius > 0); }
  /// The point of the core that is farthest along `d`, in the axes of the body.
  Vec3 support(const Vec3& d) const;
  double reach() const;  ///< [m] of the sphere about the origin that holds the core
  ConvexCore scaled(double factor) const;
  bool operator==(const ConvexCore&) const = default;
};

/// A core and where it is. A null core is the point `centre`.
struct PlacedCore {
  const ConvexCore* core = nullptr;
  Vec3 centre;
  Rotation axes;
};

/// What of a body a point of its core stands for, which says how curved its surface is there.
enum class CoreFeature { corner, edge, face };

/// The points of two cores, in the axes of each, whose hulls hold those nearest to each other:
/// where the next search begins. None: between the centres.
struct NearestHulls {
  std::array<Vec3, 3> of_a{}, of_b{};
  std::int64_t count = 0;

  NearestHulls swapped() const { return {of_b, of_a, count}; }
};

/// The points of two cores that are nearest to each other.
struct NearestPoints {
  Vec3 on_a, on_b;
  double distance = 0;  ///< [m] 0 if the cores meet
  CoreFeature feature_a = CoreFeature::corner, feature_b = CoreFeature::corner;
};
/// By the algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robot. Autom. 4, 1988, 193). The
/// relative error of the distance is below 1e-8; at rims of cylinders now
/// and then up to 2e-6. `hulls` are those of an earlier search of the same cores, and become those
/// of this one; a body that has moved little needs a round or two. The features are those of hulls
/// of points; of a cylinder use mean_curvature().
NearestPoints nearest_points(const PlacedCore& a, const PlacedCore& b, NearestHulls& hulls);

/// [1/m] Mean of the principal curvatures of a rounded body where the direction `normal` points
/// out of its core at `at` (bod.22), both in the axes of the body.
double mean_curvature(const ConvexCore& core, double rounding, const Vec3& at, const Vec3& normal,
                      CoreFeature feature);

/// Corners of an octagon, as cosine and sine.
inline constexpr std::array<std::array<double, 2>, 8> octagon{
    {{1, 0},
     {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2},
     {0, 1},
     {-std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2},
     {-1, 0},
     {-std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2},
     {0, -1},
     {std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2}}};

/// Goes from a point of a rim of a cylinder, at the height `z`, to the one that the normal there
/// makes the nearest to the wall, until it stays. `try_point(x)` returns the normal into the jar at
/// x; `d` is that at the beginning.
template <class TryPoint>
void descend_along_rim(const PlacedCore& placed, double z, Vec3 d, const TryPoint& try_point) {
  constexpr int most_rounds = 60;
  const ConvexCore& core = *placed.core;
  const auto on_rim = [&](const Vec3& against) {  // in the axes of the body
    Vec3 x = core.support({-against.x, -against.y, 0});
    x.z = z;
    return x;
  };
  Vec3 last, before;
  for (int n = 0; n < most_rounds; ++n) {
    Vec3 rim = on_rim(placed.axes.apply_inverse(d));
    const double step = norm(rim - last), step_before = norm(last - before);
    if (n > 0 && step < 1e-8 * core.radius) break;
    const Vec3 previous = last;
    before = last, last = rim;
    if (n % 3 == 2 && step < step_before) {  // the limit of steps in a constant ratio
      const Vec3 limit = rim + step / (step_before - step) * (rim - previous);
      rim = on_rim(-limit), last = rim;
    }
    d = try_point(placed.centre + placed.axes * rim);
  }
}

/// The point of a core at which `gap` is least: corners of a hull, points of the two rims of a
/// cylinder. `gap(x)` returns the distance of a point from a wall that is nowhere convex, and the
/// normal into the jar: a struct with `distance` and `inward`. On a rim the search begins at the
/// lower ones of eight points: the distance from such a wall is concave, so that each round of
/// descend_along_rim() lessens it, by about the ratio of the curvatures.
template <class Gap>
Vec3 nearest_to_wall(const PlacedCore& placed, const Gap& gap) {
  Vec3 best = placed.centre;
  if (placed.core == nullptr) return best;
  double least = std::numeric_limits<double>::infinity();
  const auto try_point = [&](const Vec3& x) {
    const auto at = gap(x);
    if (at.distance < least) best = x, least = at.distance;
    return at.inward;
  };
  const ConvexCore& core = *placed.core;
  for (const Vec3& corner : core.corners) try_point(placed.centre + placed.axes * corner);
  if (!core.is_cylinder()) return best;
  for (const double z : {-core.half_length, core.half_length}) {
    std::array<Vec3, octagon.size()> inward;
    std::array<double, octagon.size()> distance;
    for (std::size_t k = 0; k < octagon.size(); ++k) {
      const Vec3 rim{core.radius * octagon[k][0], core.radius * octagon[k][1], z};
      const auto at = gap(placed.centre + placed.axes * rim);
      inward[k] = at.inward, distance[k] = at.distance;
    }
    const std::size_t n = octagon.size();
    for (std::size_t k = 0; k < n; ++k)
      if (distance[k] <= std::min(distance[(k + 1) % n], distance[(k + n - 1) % n]))
        descend_along_rim(placed, z, inward[k], try_point);
  }
  return best;
}

}  // namespace mahlwerk::geometry

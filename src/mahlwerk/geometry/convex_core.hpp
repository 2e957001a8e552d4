// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
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

/// The point of a core at which `gap` is least: corners of a hull, points of the two rims of a
/// cylinder. `gap(x)` returns the distance of a point from a wall that is nowhere convex, and the
/// normal into the jar: a struct with `distance` and `inward`.
template <class Gap>
Vec3 nearest_to_wall(const PlacedCore& placed, const Gap& gap) {
  Vec3 best = placed.centre;
  if (placed.core == nullptr) return best;
  double least = 0;
  bool first = true;
  const auto try_point = [&](const Vec3& x) {
    const auto at = gap(x);
    if (first || at.distance < least) best = x, least = at.distance, first = false;
    return at.inward;
  };
  const ConvexCore& core = *placed.core;
  for (const Vec3& corner : core.corners) try_point(placed.centre + placed.axes * corner);
  if (!core.is_cylinder()) return best;
  // From the lower ones of eight points of each rim to the point that the present normal makes the
  // nearest: the distance from such a wall is concave, so that each round lessens it, by about the
  // ratio of the curvatures.
  constexpr int points = 8, most_rounds = 60;
  for (const double z : {-core.half_length, core.half_length}) {
    std::array<Vec3, points> inward;
    std::array<double, points> distance;
    const auto on_rim = [&](const Vec3& d) {  // against d, given in the axes of the body
      Vec3 x = core.support({-d.x, -d.y, 0});
      x.z = z;
      return x;
    };
    for (int k = 0; k < points; ++k) {
      const auto& [x, y] = octagon[static_cast<std::size_t>(k)];
      const auto at = gap(placed.centre + placed.axes * Vec3{core.radius * x, core.radius * y, z});
      inward[static_cast<std::size_t>(k)] = at.inward;
      distance[static_cast<std::size_t>(k)] = at.distance;
    }
    for (std::size_t k = 0; k < points; ++k) {
      if (distance[k] > distance[(k + 1) % points] ||
          distance[k] > distance[(k + points - 1) % points])
        continue;
      Vec3 d = inward[k], last, before;
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
  }
  return best;
}

}  // namespace mahlwerk::geometry

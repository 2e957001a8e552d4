// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mahlwerk/base/index.hpp"
#include "mahlwerk/geometry/box_tree.hpp"
#include "mahlwerk/geometry/facets.hpp"
#include "mahlwerk/geometry/shape.hpp"

namespace mahlwerk::geometry {

/// The wall of a mesh for queries, without memory of its own: where the arrays are, those of a
/// MeshWall or copies in the memory of a device. Kernels read it as it is.
struct MeshView {
  static constexpr double far = not_near;
  static constexpr int cells = 24;  ///< number along each side of the extent

  const Facet* facets = nullptr;
  const Vertex* vertices = nullptr;
  const IncidentSide* incident_sides = nullptr;
  const std::int32_t* roots = nullptr;     ///< root of each face's tree
  const float* distance_bounds = nullptr;  ///< [m] for all points of a cell; null: none yet
  BoxSearch tree, face_tree;               ///< of each face's facets, and of the faces
  std::int32_t root = 0;                   ///< root of the tree of faces
  std::int32_t faces = 0;
  Extent extent;

  struct ClosestPoint {
    Vec3 point;
    double distance2 = 0;  ///< [m2]
    std::int32_t facet = -1;
    int feature = 0;  ///< 0 the plane, 1 to 3 a side, 4 to 6 a corner
  };
  struct Feature {
    Vec3 normal;         ///< into the jar
    std::int32_t owner;  ///< the face that owns it
  };
  struct NearestFace {
    int face = 0;
    Gap gap;  ///< negative outside
  };

  // What MeshWall documents.
  Gap gap(int face, const Vec3& p, double within) const;
  double distance(int face, const Vec3& p, double within) const;
  NearestFace nearest(const Vec3& p) const;
  double distance_bound(const Vec3& p) const;
  bool can_touch(int, double) const { return true; }
  /// Calls `f(face, distance)` for the faces within `within` [m], in any order; at last for the one
  /// behind which p is, with a negative distance, if p is outside the jar.
  template <class F>
  void distances(const Vec3& p, double within, const F& f) const;

  // Parts of them.
  static double across_side(const Facet& f, std::size_t k, const Vec3& p) {
    return dot(f.inner[k], p - f.start_of(k));
  }
  /// Coordinate of p along a side, from its start or from its end; the sign is exact near that end.
  static double from_start(const Facet& f, std::size_t k, const Vec3& p) {
    return dot(f.along[k], p - f.start_of(k));
  }
  static double from_end(const Facet& f, std::size_t k, const Vec3& p) {
    return dot(f.along[k], p - f.end_of(k));
  }
  static ClosestPoint closest_point_on(const Facet& f, const Vec3& p);
  static bool beyond(const Facet& f, const Vec3& p, double least);
  static bool nearer(const ClosestPoint& a, const ClosestPoint& best, double least);
  bool beyond_extent(const Vec3& p) const;
  Feature feature_of(const ClosestPoint& closest) const;
  bool in_normal_cone(const ClosestPoint& closest, const Vec3& p) const;
  bool is_contact(const ClosestPoint& closest, int face, const Vec3& p) const;
  ClosestPoint nearest_contact(int face, const Vec3& p, double within) const;
  Gap gap_at(ClosestPoint best, int face, const Vec3& p, double within) const;
  void take_nearer(std::int32_t facet, const Vec3& p, double& least, ClosestPoint& best) const;
  void nearest_on(int face, const Vec3& p, double& within2, ClosestPoint& best) const;
  NearestFace signed_nearest(const ClosestPoint& closest, const Vec3& p) const;
};

/// The nearest point of a triangle: inside it, on the one side beyond which p lies between the
/// ends, or at a corner.
inline MeshView::ClosestPoint MeshView::closest_point_on(const Facet& f, const Vec3& p) {
  std::array<double, 3> s{};
  for (std::size_t k = 0; k < 3; ++k) s[k] = across_side(f, k, p);
  if (s[0] > 0 && s[1] > 0 && s[2] > 0) {
    const double h = dot(f.normal, p - f.corner[0]);
    return {p - h * f.normal, h * h, 0, 0};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (s[k] > 0) continue;
    const double u = from_start(f, k, p);
    if (!(u > 0 && from_end(f, k, p) < 0)) continue;
    const Vec3 closest = f.start_of(k) + u * f.along[k];
    return {closest, squared(p - closest), 0, static_cast<int>(k) + 1};
  }
  std::size_t nearest = 0;
  double least = never;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = squared(p - f.corner[k]);
    if (d < least) least = d, nearest = k;
  }
  return {f.corner[nearest], least, 0, static_cast<int>(nearest) + 4};
}

inline MeshView::Feature MeshView::feature_of(const ClosestPoint& closest) const {
  const Facet& f = facets[as_index(closest.facet)];
  if (closest.feature == 0) return {f.normal, f.face};
  if (closest.feature > 3) {
    const Vertex& v = vertices[as_index(f.vertex[as_index(closest.feature - 4)])];
    return {v.normal, v.owner};
  }
  const Facet& other = facets[as_index(f.neighbour[as_index(closest.feature - 1)])];
  const Vec3 sum = f.normal + other.normal;
  const double size = norm(sum);
  return {size > 0 ? sum / size
                   : f.inner[as_index(closest.feature - 1)] * -1.0,  // fin without thickness
          std::min(f.face, other.face)};
}

/// Whether p lies in the normal cone of the closest point: no wall point around it is nearer, and p
/// is in front of the wall (geo.10). Neighbouring features test the same numbers, so exactly one of
/// them accepts p.
inline bool MeshView::in_normal_cone(const ClosestPoint& closest, const Vec3& p) const {
  const Facet& f = facets[as_index(closest.facet)];
  if (closest.feature > 3) {
    const Vertex& v = vertices[as_index(f.vertex[as_index(closest.feature - 4)])];
    for (std::int32_t n = v.first; n < v.last; ++n) {
      const IncidentSide& incident = incident_sides[as_index(n)];
      const Facet& g = facets[as_index(incident.facet)];
      const bool beside = incident.starts ? from_start(g, as_index(incident.side), p) > 0
                                          : from_end(g, as_index(incident.side), p) < 0;
      if (beside) return false;
    }
  } else if (closest.feature > 0) {
    const std::size_t k = as_index(closest.feature - 1);
    const Facet& other = facets[as_index(f.neighbour[k])];
    if (across_side(other, as_index(f.neighbour_side[k]), p) > 0) return false;
  }
  return dot(feature_of(closest).normal, p - closest.point) >= 0;
}

/// Whether no point of the plane of a facet is within the root of `least` [m2], with a margin for
/// rounding: the facets that a search visits must not decide between two that are equally near.
inline bool MeshView::beyond(const Facet& f, const Vec3& p, double least) {
  const double h = dot(f.normal, p - f.corner[0]);
  return (1 - 1e-9) * h * h > least;
}

/// Of equally near points that of the first facet counts, in whatever order a search visits them.
inline bool MeshView::nearer(const ClosestPoint& a, const ClosestPoint& best, double least) {
  return a.distance2 < least ||
         (a.distance2 == best.distance2 && best.facet >= 0 && a.facet < best.facet);
}

/// The nearest point of a face at which p lies in the normal cone is the nearest of all its points,
/// except beside a crease. So that one, which every facet on the way narrows, is searched first.
inline Gap MeshView::gap(int face, const Vec3& p, double within) const {
  double within2 = within * within;
  ClosestPoint best;
  nearest_on(face, p, within2, best);
  return gap_at(best, face, p, within);
}

/// The gap where `best` is the nearest point of the face.
inline Gap MeshView::gap_at(ClosestPoint best, int face, const Vec3& p, double within) const {
  if (best.facet >= 0 && !is_contact(best, face, p)) best = nearest_contact(face, p, within);
  if (best.facet < 0) return {far, {0, 0, 1}, 0};
  return signed_nearest(best, p).gap;
}

inline bool MeshView::is_contact(const ClosestPoint& closest, int face, const Vec3& p) const {
  return feature_of(closest).owner == face && in_normal_cone(closest, p);
}

inline MeshView::ClosestPoint MeshView::nearest_contact(int face, const Vec3& p,
                                                        double within) const {
  double within2 = within * within;
  ClosestPoint best;
  tree.near(roots[as_index(face)], p, within2, [&](std::int32_t facet, double& least) {
    const Facet& f = facets[as_index(facet)];
    if (beyond(f, p, least)) return;
    ClosestPoint closest = closest_point_on(f, p);
    closest.facet = facet;
    if (!nearer(closest, best, least) || !is_contact(closest, face, p)) return;
    best = closest;
    least = closest.distance2;
  });
  return best;
}

/// The face of a closest point, with the signed distance of p: negative behind the wall.
inline MeshView::NearestFace MeshView::signed_nearest(const ClosestPoint& closest,
                                                      const Vec3& p) const {
  const Feature feature = feature_of(closest);
  const Vec3 way = p - closest.point;
  const double side = dot(feature.normal, way) < 0 ? -1 : 1,
               distance = std::sqrt(closest.distance2);
  const bool known = closest.feature != 0 && distance > 0;
  return {feature.owner, {side * distance, known ? side / distance * way : feature.normal, 0}};
}

inline void MeshView::nearest_on(int face, const Vec3& p, double& within2,
                                 ClosestPoint& best) const {
  tree.near(roots[as_index(face)], p, within2,
            [&](std::int32_t facet, double& least) { take_nearer(facet, p, least, best); });
}

/// Takes the closest point of a facet if it is nearer than `best` and the root of `least` [m2].
inline void MeshView::take_nearer(std::int32_t facet, const Vec3& p, double& least,
                                  ClosestPoint& best) const {
  const Facet& f = facets[as_index(facet)];
  if (beyond(f, p, least)) return;
  ClosestPoint closest = closest_point_on(f, p);
  closest.facet = facet;
  if (!nearer(closest, best, least)) return;
  best = closest;
  least = closest.distance2;
}

template <class F>
void MeshView::distances(const Vec3& p, double within, const F& f) const {
  if (distance_bound(p) > within) return;
  ClosestPoint first;
  double least = never, range = within * within;
  face_tree.near(root, p, range, [&](std::int32_t face, double&) {
    ClosestPoint best;
    double within2 = within * within;
    nearest_on(face, p, within2, best);
    if (best.facet < 0) return;
    f(face, std::sqrt(best.distance2));
    if (nearer(best, first, least)) least = best.distance2, first = best;
  });
  if (first.facet < 0) {
    if (beyond_extent(p)) f(0, -far);
    return;
  }
  const NearestFace wall = signed_nearest(first, p);
  if (wall.gap.distance < 0) f(wall.face, wall.gap.distance);
}

inline bool MeshView::beyond_extent(const Vec3& p) const {
  const Vec3 &a = extent.low, &b = extent.high;
  return p.x < a.x || p.y < a.y || p.z < a.z || p.x > b.x || p.y > b.y || p.z > b.z;
}

inline double MeshView::distance(int face, const Vec3& p, double within) const {
  ClosestPoint best;
  double within2 = within * within;
  nearest_on(face, p, within2, best);
  return best.facet < 0 ? far : std::sqrt(best.distance2);
}

inline MeshView::NearestFace MeshView::nearest(const Vec3& p) const {
  ClosestPoint best;
  double within2 = never;
  face_tree.near(root, p, within2,
                 [&](std::int32_t face, double& least) { nearest_on(face, p, least, best); });
  return best.facet < 0 ? NearestFace{0, {-far, {0, 0, 1}, 0}} : signed_nearest(best, p);
}

inline double MeshView::distance_bound(const Vec3& p) const {
  if (distance_bounds == nullptr) return 0;
  const Vec3 size = extent.size(), place = p - extent.low;
  const std::array<double, 3> at{place.x / size.x, place.y / size.y, place.z / size.z};
  std::size_t cell = 0;
  for (const double x : at) {
    const double index = x * cells;
    if (!(index >= 0 && index < cells)) return 0;
    cell = cells * cell + static_cast<std::size_t>(index);
  }
  return static_cast<double>(distance_bounds[cell]);
}

}  // namespace mahlwerk::geometry

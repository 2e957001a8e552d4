// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/geometry/box_tree.hpp"
#include "mahlwerk/geometry/facets.hpp"
#include "mahlwerk/geometry/mesh_view.hpp"
#include "mahlwerk/geometry/near_facets.hpp"
#include "mahlwerk/geometry/shape.hpp"

namespace mahlwerk::geometry {

/// The inner wall of a closed surface of triangles, and distances of points from it.
class MeshWall {
 public:
  using NearestFace = MeshView::NearestFace;
  static constexpr double far = MeshView::far;

  /// Whether the wall encloses the balls, so that its depth can be sampled.
  enum class Depth { sampled, unknown };

  /// `surface` must be without a flaw (flaw_of()); `crease_angle` [rad].
  MeshWall(Surface surface, double crease_angle, Depth depth = Depth::sampled);
  MeshWall(MeshWall&&) = default;  // no copies: the view would be that of the original
  MeshWall& operator=(MeshWall&&) = default;

  const Surface& surface() const { return surface_; }
  int faces() const { return facets_.faces; }
  const Extent& extent() const { return extent_; }
  double volume() const { return volume_; }
  double reach() const { return reach_; }
  /// Largest distance of the wall from the z axis [m].
  double radius_about_axis() const { return radius_about_axis_; }
  /// Radius of the largest ball found [m].
  double inradius() const { return inradius_; }
  /// Centre of the largest ball found [m].
  const Vec3& largest_ball_centre() const { return largest_ball_centre_; }
  double min_concave_radius() const { return facets_.min_concave_radius; }

  /// Where a ball at `p` may touch a face (geo.10): the nearest point of the face in whose normal
  /// cone p lies. Distance `far` if there is none within `within` [m].
  Gap gap(int face, const Vec3& p, double within) const;
  /// The same, faster for a ball whose last query has left `near`.
  Gap gap(int face, const Vec3& p, double within, NearFacets& near) const;

  /// Distance of each face [m], whether or not p lies in a normal cone: a lower bound of gap(),
  /// also while p moves. `far` beyond `within` [m]. One distance is negative if p is outside.
  void distances(const Vec3& p, double within, std::span<double> out) const;

  /// As distances(), for one face; never negative.
  double distance(int face, const Vec3& p, double within) const;

  /// The nearest face of the whole wall.
  NearestFace nearest(const Vec3& p) const;
  /// Distance from these facets [m], < 0 outside, if it is more than `depth` [m]; otherwise any
  /// value up to `depth`.
  double depth_beyond(double depth, const Vec3& p, std::span<const std::int32_t> facets) const;
  /// Those of the facets that may be the nearest to some point within `within` [m] of `p`.
  std::vector<std::int32_t> nearest_around(const Vec3& p, double within,
                                           std::span<const std::int32_t> facets) const;

  /// Lower bound of the distance of p from the wall, for p inside [m]; 0 where none is stored.
  double distance_bound(const Vec3& p) const;

  /// What answers these queries, with the arrays where `copy(vector)` says.
  template <class Copy>
  MeshView view(const Copy& copy) const;

 private:
  using ClosestPoint = MeshView::ClosestPoint;

  std::vector<std::int32_t> build_trees();
  void orient_trees();
  void measure();
  void sample_depth();
  void renew_view();

  bool nearest_listed(const NearFacets& near, const Vec3& p, double within,
                      ClosestPoint& best) const;
  ClosestPoint list_near(ClosestPoint nearest, int face, const Vec3& p, double within,
                         NearFacets& near) const;
  void list_around(const ClosestPoint& nearest, int face, NearFacets& near) const;

  Surface surface_;
  Facets facets_;
  BoxTree tree_, face_tree_;
  std::vector<std::int32_t> roots_;  // root of each face's tree
  std::int32_t root_ = 0;            // root of the tree of faces

  Extent extent_;
  double volume_ = 0, reach_ = 0, radius_about_axis_ = 0, inradius_ = 0;
  Vec3 largest_ball_centre_;

  std::vector<float> distance_bounds_;  // [m] lower bound for all points of a cell
  MeshView view_;                       // of the arrays above
};

template <class Copy>
MeshView MeshWall::view(const Copy& copy) const {
  return {.facets = copy(facets_.facets),
          .vertices = copy(facets_.vertices),
          .incident_sides = copy(facets_.incident_sides),
          .roots = copy(roots_),
          .distance_bounds = copy(distance_bounds_),
          .tree = tree_.view(copy),
          .face_tree = face_tree_.view(copy),
          .root = root_,
          .faces = facets_.faces,
          .extent = extent_};
}

}  // namespace mahlwerk::geometry

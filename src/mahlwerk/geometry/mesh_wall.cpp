// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/mesh_wall.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/index.hpp"

namespace mahlwerk::geometry {

MeshWall::MeshWall(Surface surface, double crease_angle, Depth depth)
    : surface_(std::move(surface)), facets_(facets_of(surface_, crease_angle)) {
  reorder(facets_, build_trees());  // near facets get near in memory
  build_trees();
  orient_trees();
  measure();
  renew_view();
  if (depth == Depth::unknown) return;
  sample_depth();
  renew_view();
}

void MeshWall::renew_view() {
  view_ =
      view([]<class T>(const std::vector<T>& all) { return all.empty() ? nullptr : all.data(); });
}

/// Builds a tree of each face's facets, and one of the faces. Returns the facets in the order of
/// the trees.
std::vector<std::int32_t> MeshWall::build_trees() {
  const auto faces = static_cast<std::size_t>(facets_.faces);
  tree_ = face_tree_ = {};
  roots_.clear();
  std::vector<std::vector<BoxTree::Item>> of_face(faces);
  for (std::size_t i = 0; i < facets_.facets.size(); ++i) {
    BoxTree::Item item{~static_cast<std::int32_t>(i), BoxTree::Box::empty()};
    for (const Vec3& c : facets_.facets[i].corner) item.box.add(c);
    of_face[as_index(facets_.facets[i].face)].push_back(item);
  }
  std::vector<BoxTree::Item> all;
  for (std::size_t face = 0; face < faces; ++face) {
    const BoxTree::Item built = tree_.build(of_face[face]);
    roots_.push_back(built.id);
    all.push_back({~static_cast<std::int32_t>(face), built.box});
  }
  root_ = face_tree_.build(all).id;
  std::vector<std::int32_t> order;
  for (const auto& items : of_face)
    for (const BoxTree::Item& item : items) order.push_back(~item.id);
  return order;
}

/// Lays the boxes of each face's tree along its facets.
void MeshWall::orient_trees() {
  for (const std::int32_t root : roots_)
    tree_.orient(root, [&](std::int32_t i) {
      const auto& c = facets_.facets[as_index(i)].corner;
      return BoxTree::Piece{c, cross(c[1] - c[0], c[2] - c[0])};
    });
}

void MeshWall::measure() {
  extent_ = extent_of(surface_.points);
  volume_ = volume_of(surface_);
  for (const Vec3& p : surface_.points) {
    reach_ = std::max(reach_, norm(p));
    radius_about_axis_ = std::max(radius_about_axis_, math::hypot(p.x, p.y));
  }
}

Gap MeshWall::gap(int face, const Vec3& p, double within) const {
  return view_.gap(face, p, within);
}

double MeshWall::distance(int face, const Vec3& p, double within) const {
  return view_.distance(face, p, within);
}

MeshWall::NearestFace MeshWall::nearest(const Vec3& p) const {
  return view_.nearest(p);
}

double MeshWall::distance_bound(const Vec3& p) const {
  return view_.distance_bound(p);
}

void MeshWall::distances(const Vec3& p, double within, std::span<double> out) const {
  std::ranges::fill(out, far);
  view_.distances(p, within, [&](int face, double d) { out[as_index(face)] = d; });
}

double MeshWall::depth_beyond(double depth, const Vec3& p,
                              std::span<const std::int32_t> facets) const {
  ClosestPoint best;
  double least = never;
  for (const std::int32_t i : facets) {
    const Facet& f = facets_.facets[as_index(i)];
    const double h = dot(f.normal, p - f.corner[0]);
    if (!(h * h < least)) continue;
    ClosestPoint closest = MeshView::closest_point_on(f, p);
    if (!(closest.distance2 < least)) continue;
    if (depth > 0 && closest.distance2 <= depth * depth) return depth;
    closest.facet = i;
    best = closest;
    least = closest.distance2;
  }
  return best.facet < 0 ? -far : view_.signed_nearest(best, p).gap.distance;
}

std::vector<std::int32_t> MeshWall::nearest_around(const Vec3& p, double within,
                                                   std::span<const std::int32_t> facets) const {
  std::vector<double> distances;
  for (const std::int32_t i : facets)
    distances.push_back(
        std::sqrt(MeshView::closest_point_on(facets_.facets[as_index(i)], p).distance2));
  const double least = distances.empty() ? 0 : *std::ranges::min_element(distances);
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < facets.size(); ++k)
    if (distances[k] <= (least + 2 * within) * (1 + 1e-12)) near.push_back(facets[k]);
  return near;
}

}  // namespace mahlwerk::geometry

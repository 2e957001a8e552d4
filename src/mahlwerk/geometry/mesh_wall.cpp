// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/mesh_wall.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/index.hpp"

namespace mahlwerk::geometry {
namespace {

double across_side(const Facet& f, std::size_t k, const Vec3& p) {
  return dot(f.inner[k], p - f.start_of(k));
}
/// Coordinate of p along a side, from its start or from its end; the sign is exact near that end.
double from_start(const Facet& f, std::size_t k, const Vec3& p) {
  return dot(f.along[k], p - f.start_of(k));
}
double from_end(const Facet& f, std::size_t k, const Vec3& p) {
  return dot(f.along[k], p - f.end_of(k));
}

}  // namespace

MeshWall::MeshWall(Surface surface, double crease_angle)
    : surface_(std::move(surface)), facets_(facets_of(surface_, crease_angle)) {
  reorder(facets_, build_trees());  // near facets get near in memory
  build_trees();
  orient_trees();
  measure();
  sample_depth();
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

/// The nearest point of a triangle: inside it, on the one side beyond which p lies between the
/// ends, or at a corner.
MeshWall::ClosestPoint MeshWall::closest_point_on(const Facet& f, const Vec3& p) {
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

MeshWall::Feature MeshWall::feature_of(const ClosestPoint& closest) const {
  const Facet& f = facets_.facets[as_index(closest.facet)];
  if (closest.feature == 0) return {f.normal, f.face};
  if (closest.feature > 3) {
    const Vertex& v = facets_.vertices[as_index(f.vertex[as_index(closest.feature - 4)])];
    return {v.normal, v.owner};
  }
  const Facet& other = facets_.facets[as_index(f.neighbour[as_index(closest.feature - 1)])];
  const Vec3 sum = f.normal + other.normal;
  const double size = norm(sum);
  return {size > 0 ? sum / size
                   : f.inner[as_index(closest.feature - 1)] * -1.0,  // fin without thickness
          std::min(f.face, other.face)};
}

/// Whether p lies in the normal cone of the closest point: no wall point around it is nearer, and p
/// is in front of the wall (geo.10). Neighbouring features test the same numbers, so exactly one of
/// them accepts p.
bool MeshWall::in_normal_cone(const ClosestPoint& closest, const Vec3& p) const {
  const Facet& f = facets_.facets[as_index(closest.facet)];
  if (closest.feature > 3) {
    const Vertex& v = facets_.vertices[as_index(f.vertex[as_index(closest.feature - 4)])];
    for (std::int32_t n = v.first; n < v.last; ++n) {
      const IncidentSide& incident = facets_.incident_sides[as_index(n)];
      const Facet& g = facets_.facets[as_index(incident.facet)];
      const bool beside = incident.starts ? from_start(g, as_index(incident.side), p) > 0
                                          : from_end(g, as_index(incident.side), p) < 0;
      if (beside) return false;
    }
  } else if (closest.feature > 0) {
    const std::size_t k = as_index(closest.feature - 1);
    const Facet& other = facets_.facets[as_index(f.neighbour[k])];
    if (across_side(other, as_index(f.neighbour_side[k]), p) > 0) return false;
  }
  return dot(feature_of(closest).normal, p - closest.point) >= 0;
}

/// Whether no point of the plane of a facet is within the root of `least` [m2], with a margin for
/// rounding: the facets that a search visits must not decide between two that are equally near.
bool MeshWall::beyond(const Facet& f, const Vec3& p, double least) {
  const double h = dot(f.normal, p - f.corner[0]);
  return (1 - 1e-9) * h * h > least;
}

/// Of equally near points that of the first facet counts, in whatever order a search visits them.
bool MeshWall::nearer(const ClosestPoint& a, const ClosestPoint& best, double least) {
  return a.distance2 < least ||
         (a.distance2 == best.distance2 && best.facet >= 0 && a.facet < best.facet);
}

/// The nearest point of a face at which p lies in the normal cone is the nearest of all its points,
/// except beside a crease. So that one, which every facet on the way narrows, is searched first.
Gap MeshWall::gap(int face, const Vec3& p, double within) const {
  double within2 = within * within;
  ClosestPoint best;
  nearest_on(face, p, within2, best);
  return gap_at(best, face, p, within);
}

/// The gap where `best` is the nearest point of the face.
Gap MeshWall::gap_at(ClosestPoint best, int face, const Vec3& p, double within) const {
  if (best.facet >= 0 && !is_contact(best, face, p)) best = nearest_contact(face, p, within);
  if (best.facet < 0) return {far, {0, 0, 1}, 0};
  return signed_nearest(best, p).gap;
}

bool MeshWall::is_contact(const ClosestPoint& closest, int face, const Vec3& p) const {
  return feature_of(closest).owner == face && in_normal_cone(closest, p);
}

MeshWall::ClosestPoint MeshWall::nearest_contact(int face, const Vec3& p, double within) const {
  double within2 = within * within;
  ClosestPoint best;
  tree_.near(roots_[as_index(face)], p, within2, [&](std::int32_t facet, double& least) {
    const Facet& f = facets_.facets[as_index(facet)];
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
MeshWall::NearestFace MeshWall::signed_nearest(const ClosestPoint& closest, const Vec3& p) const {
  const Feature feature = feature_of(closest);
  const Vec3 way = p - closest.point;
  const double side = dot(feature.normal, way) < 0 ? -1 : 1,
               distance = std::sqrt(closest.distance2);
  const bool known = closest.feature != 0 && distance > 0;
  return {feature.owner, {side * distance, known ? side / distance * way : feature.normal, 0}};
}

void MeshWall::nearest_on(int face, const Vec3& p, double& within2, ClosestPoint& best) const {
  tree_.near(roots_[as_index(face)], p, within2,
             [&](std::int32_t facet, double& least) { take_nearer(facet, p, least, best); });
}

/// Takes the closest point of a facet if it is nearer than `best` and the root of `least` [m2].
void MeshWall::take_nearer(std::int32_t facet, const Vec3& p, double& least,
                           ClosestPoint& best) const {
  const Facet& f = facets_.facets[as_index(facet)];
  if (beyond(f, p, least)) return;
  ClosestPoint closest = closest_point_on(f, p);
  closest.facet = facet;
  if (!nearer(closest, best, least)) return;
  best = closest;
  least = closest.distance2;
}

void MeshWall::distances(const Vec3& p, double within, std::span<double> out) const {
  std::ranges::fill(out, far);
  if (distance_bound(p) > within) return;
  ClosestPoint first;
  double least = never, range = within * within;
  face_tree_.near(root_, p, range, [&](std::int32_t face, double&) {
    ClosestPoint best;
    double within2 = within * within;
    nearest_on(face, p, within2, best);
    if (best.facet < 0) return;
    out[as_index(face)] = std::sqrt(best.distance2);
    if (nearer(best, first, least)) least = best.distance2, first = best;
  });
  if (first.facet < 0) {
    const Vec3 &a = extent_.low, &b = extent_.high;
    const bool beyond = p.x < a.x || p.y < a.y || p.z < a.z || p.x > b.x || p.y > b.y || p.z > b.z;
    if (beyond) out[0] = -far;
    return;
  }
  const NearestFace wall = signed_nearest(first, p);
  if (wall.gap.distance < 0) out[as_index(wall.face)] = wall.gap.distance;
}

double MeshWall::distance(int face, const Vec3& p, double within) const {
  ClosestPoint best;
  double within2 = within * within;
  nearest_on(face, p, within2, best);
  return best.facet < 0 ? far : std::sqrt(best.distance2);
}

MeshWall::NearestFace MeshWall::nearest(const Vec3& p) const {
  ClosestPoint best;
  double within2 = never;
  face_tree_.near(root_, p, within2,
                  [&](std::int32_t face, double& least) { nearest_on(face, p, least, best); });
  return best.facet < 0 ? NearestFace{0, {-far, {0, 0, 1}, 0}} : signed_nearest(best, p);
}

double MeshWall::depth_beyond(double depth, const Vec3& p,
                              std::span<const std::int32_t> facets) const {
  ClosestPoint best;
  double least = never;
  for (const std::int32_t i : facets) {
    const Facet& f = facets_.facets[as_index(i)];
    const double h = dot(f.normal, p - f.corner[0]);
    if (!(h * h < least)) continue;
    ClosestPoint closest = closest_point_on(f, p);
    if (!(closest.distance2 < least)) continue;
    if (depth > 0 && closest.distance2 <= depth * depth) return depth;
    closest.facet = i;
    best = closest;
    least = closest.distance2;
  }
  return best.facet < 0 ? -far : signed_nearest(best, p).gap.distance;
}

std::vector<std::int32_t> MeshWall::nearest_around(const Vec3& p, double within,
                                                   std::span<const std::int32_t> facets) const {
  std::vector<double> distances;
  for (const std::int32_t i : facets)
    distances.push_back(std::sqrt(closest_point_on(facets_.facets[as_index(i)], p).distance2));
  const double least = distances.empty() ? 0 : *std::ranges::min_element(distances);
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < facets.size(); ++k)
    if (distances[k] <= (least + 2 * within) * (1 + 1e-12)) near.push_back(facets[k]);
  return near;
}

double MeshWall::distance_bound(const Vec3& p) const {
  if (distance_bounds_.empty()) return 0;
  const Vec3 size = extent_.size(), place = p - extent_.low;
  std::size_t cell = 0;
  for (const auto& [x, length] :
       {std::pair(place.x, size.x), std::pair(place.y, size.y), std::pair(place.z, size.z)}) {
    const double index = x / length * cells;
    if (!(index >= 0 && index < cells)) return 0;
    cell = cells * cell + static_cast<std::size_t>(index);
  }
  return static_cast<double>(distance_bounds_[cell]);
}

}  // namespace mahlwerk::geometry

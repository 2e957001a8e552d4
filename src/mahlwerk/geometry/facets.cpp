// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/index.hpp"

namespace mahlwerk::geometry {
namespace {

/// Plane and sides of a triangle. The normal of a triangle without area is zero.
Facet facet_of(const Surface& s, const std::array<std::int32_t, 3>& t) {
  Facet f;
  f.vertex = t;
  for (std::size_t k = 0; k < 3; ++k) f.corner[k] = s.points[as_index(t[k])];
  const Vec3 area = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
  const double size = norm(area);
  const Vec3 outward = size > 0 ? area / size : Vec3{};
  f.normal = -outward;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const bool forward = t[k] < t[next];
    f.start[k] = static_cast<std::int8_t>(forward ? k : next);
    const Vec3 way = f.corner[next] - f.corner[k];
    const double length = norm(way);
    f.along[k] = (forward ? 1.0 : -1.0) / length * way;
    f.inner[k] = cross(outward, way / length);
  }
  return f;
}

/// Links neighbours; `sides` holds the two sides of each edge next to each other.
void join_neighbours(std::vector<Facet>& facets, const std::vector<Side>& sides) {
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    for (const auto& [mine, other] :
         {std::pair(sides[i], sides[i + 1]), std::pair(sides[i + 1], sides[i])}) {
      Facet& f = facets[as_index(mine.triangle)];
      f.neighbour[as_index(mine.k)] = other.triangle;
      f.neighbour_side[as_index(mine.k)] = static_cast<std::int8_t>(other.k);
    }
}

int split_into_faces(std::vector<Facet>& facets, double crease_angle) {
  // Bends of exactly the crease angle are creases, however their cosine is rounded.
  const double smooth = math::cos(crease_angle) + 1e-9;
  int faces = 0;
  for (Facet& f : facets) f.face = -1;
  std::vector<std::int32_t> open;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (facets[i].face >= 0) continue;
    facets[i].face = faces;
    open.assign(1, static_cast<std::int32_t>(i));
    while (!open.empty()) {
      const Facet& f = facets[as_index(open.back())];
      open.pop_back();
      for (const std::int32_t n : f.neighbour) {
        Facet& other = facets[as_index(n)];
        if (other.face >= 0 || !(dot(f.normal, other.normal) > smooth)) continue;
        other.face = faces;
        open.push_back(n);
      }
    }
    ++faces;
  }
  return faces;
}

/// Angle of a facet at one of its corners [rad].
double angle_at(const Facet& f, std::size_t k) {
  const Vec3 a = f.corner[(k + 1) % 3] - f.corner[k], b = f.corner[(k + 2) % 3] - f.corner[k];
  return math::atan2(norm(cross(a, b)), dot(a, b));
}

Vec3 unit(const Vec3& a) {
  const double size = norm(a);
  return size > 0 ? a / size : a;
}

void gather_vertices(Facets& all, std::size_t points) {
  all.vertices.assign(points, {});
  for (const Facet& f : all.facets)
    for (const std::int32_t v : f.vertex) all.vertices[as_index(v)].last += 2;  // sides per facet
  std::int32_t count = 0;
  for (Vertex& v : all.vertices) {
    v.first = count;
    count += v.last;
    v.last = v.first;
    v.owner = std::numeric_limits<std::int32_t>::max();
  }
  all.incident_sides.resize(as_index(count));
  for (std::size_t i = 0; i < all.facets.size(); ++i) {
    const Facet& f = all.facets[i];
    for (std::size_t k = 0; k < 3; ++k) {
      Vertex& v = all.vertices[as_index(f.vertex[k])];
      v.crease = v.crease || (v.last > v.first && v.owner != f.face);
      v.owner = std::min(v.owner, f.face);
      v.normal += angle_at(f, k) * f.normal;
      for (const std::size_t side : {k, (k + 2) % 3})
        all.incident_sides[as_index(v.last++)] = {static_cast<std::int32_t>(i),
                                                  static_cast<std::int8_t>(side),
                                                  as_index(f.start[side]) == k};
    }
  }
  for (Vertex& v : all.vertices) v.normal = unit(v.normal);
}

/// Normal at corner k, from the facets there that belong to the face of `f`. Each of them has two
/// incident sides.
Vec3 face_normal(const Facets& all, const Facet& f, std::size_t k) {
  const Vertex& v = all.vertices[as_index(f.vertex[k])];
  if (!v.crease) return v.normal;
  Vec3 sum;
  for (std::int32_t n = v.first; n < v.last; n += 2) {
    const Facet& other = all.facets[as_index(all.incident_sides[as_index(n)].facet)];
    if (other.face != f.face) continue;
    const auto mine = std::ranges::find(other.vertex, f.vertex[k]) - other.vertex.begin();
    sum += angle_at(other, static_cast<std::size_t>(mine)) * other.normal;
  }
  return unit(sum);
}

/// From the change of the normal along the sides (geo.12) [m].
double min_concave_radius(const Facets& all) {
  double most = 0;
  for (const Facet& f : all.facets) {
    std::array<Vec3, 3> normal;
    for (std::size_t k = 0; k < 3; ++k) normal[k] = face_normal(all, f, k);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 way = f.corner[(k + 1) % 3] - f.corner[k];
      most = std::max(most, -dot(normal[(k + 1) % 3] - normal[k], way) / squared(way));
    }
  }
  constexpr double rounding = 1e-6;  // of a curvature times the size of a facet
  const double size = norm(extent_of(all.facets[0].corner).size());
  return most * size > rounding ? 1 / most : std::numeric_limits<double>::infinity();
}

}  // namespace

Facets facets_of(const Surface& surface, double crease_angle) {
  Facets all;
  all.facets.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) all.facets.push_back(facet_of(surface, t));
  join_neighbours(all.facets, sides_of(surface));
  all.faces = split_into_faces(all.facets, crease_angle);
  gather_vertices(all, surface.points.size());
  all.min_concave_radius = min_concave_radius(all);
  return all;
}

void reorder(Facets& all, const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> now(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    now[as_index(order[i])] = static_cast<std::int32_t>(i);
  std::vector<Facet> facets;
  facets.reserve(order.size());
  for (const std::int32_t i : order) facets.push_back(all.facets[as_index(i)]);
  for (Facet& f : facets)
    for (std::int32_t& n : f.neighbour) n = now[as_index(n)];
  for (IncidentSide& s : all.incident_sides) s.facet = now[as_index(s.facet)];
  all.facets = std::move(facets);
}

}  // namespace mahlwerk::geometry

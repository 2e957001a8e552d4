// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/index.hpp"
#include "mahlwerk/geometry/mesh_wall.hpp"

// Queries of a mesh by balls that move little between them (NearFacets).
//
// Let q be the nearest point of a face to the place a, at the distance d, and x another point of
// the face. When the ball is at a + m, the squares of its distances from x and q differ by
// |x - a|^2 - d^2 - 2 m.(x - q). So x cannot be the nearest point before the ball has moved by
// (|x - a|^2 - d^2) / (2 |x - q|) (geo.18): half the way from q to x on a flat wall.
namespace mahlwerk::geometry {

Gap MeshWall::gap(int face, const Vec3& p, double within, NearFacets& near) const {
  if (!(within > 0)) return {far, {0, 0, 1}, 0};
  ClosestPoint best;
  if (near.face != face || !nearest_listed(near, p, within, best))
    best = list_near(best, face, p, within, near);
  return view_.gap_at(best, face, p, within);
}

/// Finds what nearest_on() finds among the listed facets. Returns whether no other facet of the
/// face can be as near.
bool MeshWall::nearest_listed(const NearFacets& near, const Vec3& p, double within,
                              ClosestPoint& best) const {
  const double moved = (1 + 1e-9) * norm(p - near.place);
  if (near.count == 0) return near.range - moved > within;
  if (moved >= near.others_from) return false;
  double least = within * within;
  for (std::size_t k = 0; k < near.count; ++k) {
    if (static_cast<double>(near.list[k].from) > moved) break;
    view_.take_nearer(near.list[k].facet, p, least, best);
  }
  return true;
}

/// Lists the facets around the nearest point of a face, and returns what nearest_on() finds.
/// `nearest` is a point of the face to begin with, if any.
MeshWall::ClosestPoint MeshWall::list_near(ClosestPoint nearest, int face, const Vec3& p,
                                           double within, NearFacets& near) const {
  // A ball beyond `within` is not asked again before it has come near, which needs no list.
  constexpr double range = 1.05, beyond_all = 1.003;
  double within2 = range * range * within * within;
  if (nearest.facet >= 0) within2 = nearest.distance2;
  view_.nearest_on(face, p, within2, nearest);
  near.count = 0, near.face = face, near.place = p;
  near.range = nearest.facet < 0 ? range * within : std::sqrt(nearest.distance2);
  if (near.range > beyond_all * within) return {};
  list_around(nearest, face, near);
  return nearest.distance2 < within * within ? nearest : ClosestPoint{};
}

/// Lists the facets that the ball has to move least for, by the boxes around them.
void MeshWall::list_around(const ClosestPoint& nearest, int face, NearFacets& near) const {
  struct Found {
    double from;
    std::int32_t facet;
  };
  std::array<Found, NearFacets::most> found;
  std::size_t& count = near.count;
  const double margin = 1e-9 * std::sqrt(nearest.distance2);  // for rounding of equal distances
  const BoxTree::Probe at = view_.tree.probe_at(near.place),
                       at_wall = view_.tree.probe_at(nearest.point);
  double least = std::numeric_limits<double>::infinity();
  view_.tree.search(
      roots_[as_index(face)], least,
      [&](const BoxTree::Box& box) {
        const double excess = box.distance2(at) - nearest.distance2;
        return excess > 0 ? (1 - 1e-6) * excess / (2 * std::sqrt(box.farthest2(at_wall))) - margin
                          : -margin;
      },
      [&](std::int32_t facet, double from, double& most) {
        std::size_t k = std::min(count, found.size() - 1);
        for (; k > 0 && found[k - 1].from > from; --k) found[k] = found[k - 1];
        found[k] = {from, facet};
        if (count < found.size()) ++count;
        if (count == found.size()) most = found.back().from;
      });
  near.others_from = least;
  for (std::size_t k = 0; k < count; ++k)
    near.list[k] = {found[k].facet, static_cast<float>(found[k].from * (1 - 1e-6) - margin)};
}

}  // namespace mahlwerk::geometry

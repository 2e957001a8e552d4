// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// The triangles of a wall, with the data that a nearest-point search needs. Data that two triangles
// share is computed from the same numbers in both, so that they agree on which one owns a point.
namespace mahlwerk::geometry {

struct Facet {
  std::array<Vec3, 3> corner;  ///< [m]
  Vec3 normal;                 ///< unit, into the jar
  // Side k runs between corners k and k + 1, and is measured from the end with the lower number.
  std::array<Vec3, 3> inner;  ///< unit, normal to side k in the plane, into the facet
  std::array<Vec3, 3> along;  ///< unit, along side k from its start
  std::array<std::int32_t, 3> vertex, neighbour;
  std::array<std::int8_t, 3> start;           ///< the corner that side k is measured from
  std::array<std::int8_t, 3> neighbour_side;  ///< index of side k in the neighbour
  std::int32_t face = 0;

  const Vec3& start_of(std::size_t k) const { return corner[static_cast<std::size_t>(start[k])]; }
  const Vec3& end_of(std::size_t k) const {
    const auto s = static_cast<std::size_t>(start[k]);
    return corner[s == k ? (k + 1) % 3 : k];
  }
};

/// A side that ends at a vertex.
struct IncidentSide {
  std::int32_t facet;
  std::int8_t side;
  bool starts;  ///< it is measured from that vertex
};

struct Vertex {
  Vec3 normal;                       ///< of the facets around it, weighted by angle; into the jar
  std::int32_t owner = 0;            ///< the lowest number of the faces around it
  bool crease = false;               ///< several faces meet there
  std::int32_t first = 0, last = 0;  ///< range of its incident sides
};

struct Facets {
  std::vector<Facet> facets;
  std::vector<Vertex> vertices;
  std::vector<IncidentSide> incident_sides;
  int faces = 0;
  /// [m] smallest concave radius of curvature of a face (geo.12); infinite if none is concave
  double min_concave_radius = 0;
};

/// Facets of a closed surface. Facets joined by sides that bend by less than `crease_angle` [rad]
/// are one face; faces are numbered in the order of their first triangles (geo.9).
Facets facets_of(const Surface& surface, double crease_angle);

/// Reorders the facets: the new facet i is the old facet order[i].
void reorder(Facets& all, const std::vector<std::int32_t>& order);

}  // namespace mahlwerk::geometry

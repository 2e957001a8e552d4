// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// The triangles of a wall with all that a search for nearest points asks of them. What two of them
// share is computed from the same numbers in both, so that they never disagree on whose a point is.
namespace mahlwerk::geometry {

struct Facet {
  std::array<Vec3, 3> corner;  ///< [m]
  Vec3 normal;                 ///< into the jar
  // Side k runs between corners k and k + 1, and is measured from the end with the lower number.
  std::array<Vec3, 3> inner;  ///< across side k, in the plane, into the facet
  std::array<Vec3, 3> along;  ///< side k
  std::array<std::int32_t, 3> vertex, neighbour;
  std::array<std::int8_t, 3> start;           ///< the corner that side k is measured from
  std::array<std::int8_t, 3> neighbour_side;  ///< which side of the neighbour side k is
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
  bool starts;  ///< it is measured from there
};

struct Vertex {
  Vec3 normal;                       ///< of the facets around it, by their angles; into the jar
  std::int32_t owner = 0;            ///< the first of the faces around it
  bool crease = false;               ///< there are several
  std::int32_t first = 0, last = 0;  ///< its incident sides
};

struct Facets {
  std::vector<Facet> facets;
  std::vector<Vertex> vertices;
  std::vector<IncidentSide> incident_sides;
  int faces = 0;
  /// [m] the smallest concave radius at which a face is curved (geo.12); infinite if none is
  double min_concave_radius = 0;
};

/// Facets of a closed surface. Those joined over sides that bend by less than `crease_angle` [rad]
/// are one face; faces are numbered as their first triangles are (geo.9).
Facets facets_of(const Surface& surface, double crease_angle);

/// Facets in that order of their numbers.
void reorder(Facets& all, const std::vector<std::int32_t>& order);

}  // namespace mahlwerk::geometry

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

// A surface of triangles that share their corners, and what keeps it from being a jar.
namespace mahlwerk::geometry {

using Corners = std::array<Vec3, 3>;  ///< [m] of one triangle, as files have them

/// Triangles by their corners' numbers, anticlockwise as seen from outside.
struct Surface {
  std::vector<Vec3> points;  ///< [m]
  std::vector<std::array<std::int32_t, 3>> triangles;
  bool operator==(const Surface&) const = default;
};

struct Extent {
  Vec3 low, high;  ///< [m]
  Vec3 size() const { return high - low; }
  Vec3 middle() const { return 0.5 * (low + high); }
};

/// Joins corners that are one point: equal ones, and, if the surface then still gapes, those within
/// a millionth of its size. Triangles without area are taken out; the surface stays closed.
Surface weld(std::span<const Corners> triangles);

Extent extent_of(std::span<const Vec3> points);
double volume_of(const Surface& surface);  ///< [m3] (geo.11); negative if it is inside out

/// Why a surface does not enclose a volume.
struct Flaw {
  enum class Kind { open, non_manifold, misoriented, several_shells, inside_out };
  Kind kind;
  std::size_t count;  ///< edges or, of `several_shells`, shells
  Vec3 where;         ///< [m] the middle of one such edge, or a corner of the second shell
};
std::optional<Flaw> flaw_of(const Surface& surface);

/// One side of a triangle: from corner k to the next.
struct Side {
  std::int32_t low, high;  ///< its ends' numbers
  std::int32_t triangle;
  std::int32_t k;
  bool forward;  ///< it runs from low to high
};
/// All sides, those of one edge beside each other.
std::vector<Side> sides_of(const Surface& surface);

}  // namespace mahlwerk::geometry

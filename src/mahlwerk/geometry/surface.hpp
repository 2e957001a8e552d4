// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

// A surface of triangles with shared vertices, and flaws that keep it from being a jar.
namespace mahlwerk::geometry {

using Corners = std::array<Vec3, 3>;  ///< [m] of one triangle, as stored in files

/// Triangles as vertex numbers, anticlockwise as seen from outside.
struct Surface {
  std::vector<Vec3> points;  ///< [m]
  std::vector<std::array<std::int32_t, 3>> triangles;
  bool operator==(const Surface&) const = default;
};

/// Axis-aligned bounding box.
struct Extent {
  Vec3 low, high;  ///< [m]
  Vec3 size() const { return high - low; }
  Vec3 middle() const { return 0.5 * (low + high); }
};

/// Welds vertices: merges equal corners and, if the surface is then still open, those within a
/// millionth of its size. Removes triangles without area and keeps the surface closed.
Surface weld(std::span<const Corners> triangles);

/// Turns each closed, connected shell so that it faces away from the material: outward, or inward
/// if it bounds a cavity, that is if it lies in an odd number of other shells. The surface must be
/// closed and consistently oriented.
void face_outward(Surface& surface);

Extent extent_of(std::span<const Vec3> points);
double volume_of(const Surface& surface);  ///< [m3] (geo.11); negative if inside out

/// Why a surface does not enclose a volume.
struct Flaw {
  enum class Kind { open, non_manifold, misoriented, several_shells, inside_out };
  Kind kind;
  std::size_t count;  ///< of edges; for `several_shells` of shells
  Vec3 where;         ///< [m] midpoint of one such edge, or a corner of the second shell
};
/// The first flaw found; none if the surface encloses a volume.
std::optional<Flaw> flaw_of(const Surface& surface);

/// One side of a triangle: from corner k to the next.
struct Side {
  std::int32_t low, high;  ///< vertex numbers of its ends
  std::int32_t triangle;
  std::int32_t k;
  bool forward;  ///< the triangle runs along it from low to high
};
/// All sides of all triangles, sorted so that the sides of one edge are next to each other.
std::vector<Side> sides_of(const Surface& surface);

}  // namespace mahlwerk::geometry

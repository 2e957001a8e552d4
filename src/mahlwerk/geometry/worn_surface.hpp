// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// A surface of triangles that wears: its vertices move. What wore off is counted by vertex.
namespace mahlwerk::geometry {

/// The same surface in triangles whose edges are at most `longest` [m]: all are cut in four, as
/// often as needed. None if these would be more than `most`.
std::optional<Surface> cut_into_small(Surface surface, double longest, std::size_t most);

/// [m2] Area of each vertex: a third of its triangles.
std::vector<double> vertex_areas(const Surface& surface);

/// Spreads what vertices lost over the surface, as heat is conducted, with the standard deviation
/// `width` [m] >= 0 along it. The sum stays, and a uniform depth (wea.11).
std::vector<double> spread_over(const Surface& surface, std::vector<double> lost, double width);

enum class WornSide {
  outside,  ///< of a solid, which becomes smaller
  inside    ///< of the jar that the surface holds, which becomes larger
};
/// The surface after its vertices have lost these volumes [m3] >= 0: the volume of the closed
/// surface changes by their sum, to rounding (wea.19). None if a triangle would turn over.
std::optional<Surface> worn_surface(const Surface& surface, const std::vector<double>& lost,
                                    WornSide side);

/// Finds the vertex nearest to a point.
class NearestVertex {
 public:
  explicit NearestVertex(const Surface& surface);
  std::size_t operator()(const Vec3& p) const;

 private:
  using Cell = std::array<int, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  Cell cell_of(const Vec3& p) const;
  void search(const Cell& middle, int ring, const Vec3& p, double& least, std::size_t& found) const;

  std::vector<Vec3> points_;
  double width_ = 1;  // [m] of a cell
  int most_rings_ = 1;
  std::unordered_map<Cell, std::vector<std::size_t>, Hash> cells_;
};

}  // namespace mahlwerk::geometry

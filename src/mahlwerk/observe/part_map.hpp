// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/observe/packed_array.hpp"
#include "mahlwerk/observe/wall_map.hpp"

namespace mahlwerk::observe {

/// Division of a part's surface into cells (obs.23): six views along its own axes, each of the
/// surface that faces that way, in square cells. What lies behind in a view is in the same cell.
class PartGrid {
 public:
  static constexpr int along_longest = 32;  ///< most cells along the longest edge of the box
  enum Side { left, right, front, back, bottom, top, sides };  ///< outwards -x, +x, -y, +y, -z, +z

  PartGrid() : PartGrid({-1, -1, -1}, {1, 1, 1}) {}
  /// `least`, `most` [m]: a box about the part, in its own axes. `finest` [m]: no cell is narrower.
  PartGrid(const Vec3& least, const Vec3& most, double finest = 0);

  int cells() const { return first_.back(); }
  /// The cell of a point [m] on the surface; `outward`: the normal there, of any length.
  int cell_of(const Vec3& where, const Vec3& outward) const;

  Side side(int cell) const;
  int first(Side side) const { return first_[side]; }  ///< of its cells; rows along `across`
  /// The axes of a view, 0 to 2, and its number of cells along them.
  static std::array<int, 2> axes(Side side);
  std::array<int, 2> counts(Side side) const;
  /// [m] Ranges of a cell along the two axes of its view.
  struct Bounds {
    std::array<double, 2> along, across;
  };
  Bounds bounds(int cell) const;
  double edge() const { return edge_; }  ///< [m] of a cell

 private:
  std::array<double, 3> least_;  // [m] of the cells
  std::array<int, 3> counts_;    // of cells along each axis
  double edge_;
  std::array<int, sides + 1> first_{};
};

/// Map of hits on a part and their effects.
class PartMap {
 public:
  explicit PartMap(const PartGrid& grid = {})
      : grid_(grid), cells_(static_cast<std::size_t>(grid.cells())) {}
  const PartGrid& grid() const { return grid_; }
  WallSums& at(int cell) { return cells_[static_cast<std::size_t>(cell)]; }
  WallSums operator[](int cell) const { return cells_[static_cast<std::size_t>(cell)]; }
  void merge(const PartMap& other) { cells_.merge(other.cells_, WallSums::add_to); }
  void pack() { cells_.pack(); }
  void let_go() { cells_.let_go(); }
  void serialize(Archive& archive) { cells_.serialize(archive); }

 private:
  PartGrid grid_;
  PackedArray<WallSums> cells_;
};

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/observe/packed_array.hpp"

namespace mahlwerk::observe {

/// Division of a jar's wall into cells (obs.4): an unrolled cylinder about the jar's own z axis,
/// and two discs for the parts that face along this axis. Every point is in exactly one cell.
struct WallGrid {
  static constexpr int around = 60, along = 30;  ///< cells of the unrolled side
  static constexpr int rings = 6, sectors = 30;  ///< cells of each disc; rings have equal areas
  static constexpr int side_cells = around * along, disc_cells = rings * sectors;
  static constexpr int cells = side_cells + 2 * disc_cells;

  double radius = 1;            ///< [m] largest distance from the axis
  double bottom = -1, top = 1;  ///< [m] ends along the axis
  /// Number of faces of the jar; hits on those of parts are not in its map.
  int faces = std::numeric_limits<int>::max();

  enum class Part { side, bottom, top };
  static Part part(int cell);
  /// Ranges of a cell: angle about the axis [rad]; height (side) or radius (disc) [m].
  struct Bounds {
    std::array<double, 2> angle, across;
  };
  Bounds bounds(int cell) const;
};

/// Sums over the hits on one cell of the wall.
struct WallSums {
  std::int64_t count = 0;
  double energy_normal = 0, lost = 0;  ///< [J]
  double load_distance = 0;            ///< [N m] integral of normal force over sliding distance
  double erosion = 0;                  ///< [J] sum of m u^2 f(alpha) (wea.4)

  static void add_to(WallSums& mine, const WallSums& more) {
    mine.count += more.count;
    mine.energy_normal += more.energy_normal;
    mine.lost += more.lost;
    mine.load_distance += more.load_distance;
    mine.erosion += more.erosion;
  }
};

/// Map of hits on the jar's wall and their effects, in fixed memory of 0.1 MB.
class WallMap {
 public:
  explicit WallMap(const WallGrid& grid = {}) : grid_(grid), cells_(std::size_t{WallGrid::cells}) {}
  const WallGrid& grid() const { return grid_; }
  WallSums& at(std::int64_t cell) { return cells_[static_cast<std::size_t>(cell)]; }
  WallSums operator[](int cell) const { return cells_[static_cast<std::size_t>(cell)]; }
  /// Adds a map of the same grid.
  void merge(const WallMap& other) { cells_.merge(other.cells_, WallSums::add_to); }
  void pack() { cells_.pack(); }      ///< nothing is added from then on
  void let_go() { cells_.let_go(); }  ///< the sums are forgotten
  void serialize(Archive& archive) { cells_.serialize(archive); }

 private:
  WallGrid grid_;
  PackedArray<WallSums> cells_;
};

}  // namespace mahlwerk::observe

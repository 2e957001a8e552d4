// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::observe {

/// How a jar's wall is cut into cells (obs.4): its own z axis is that of an unrolled cylinder, and
/// what faces along that axis belongs to one of two discs. Every place is in exactly one cell.
struct WallGrid {
  static constexpr int around = 60, along = 30;  ///< of the unrolled side
  static constexpr int rings = 6, sectors = 30;  ///< of each disc; rings have equal areas
  static constexpr int side_cells = around * along, disc_cells = rings * sectors;
  static constexpr int cells = side_cells + 2 * disc_cells;

  double radius = 1;            ///< [m] largest distance from the axis
  double bottom = -1, top = 1;  ///< [m] ends along the axis

  enum class Part { side, bottom, top };
  static Part part(int cell);
  /// Ranges of a cell: angle about the axis [rad], and height [m] of the side or radius [m] of a
  /// disc.
  struct Bounds {
    std::array<double, 2> angle, across;
  };
  Bounds bounds(int cell) const;
};

/// What hits on one cell of the wall add up to.
struct WallSums {
  std::int64_t count = 0;
  double energy_normal = 0, lost = 0;  ///< [J]
  double load_distance = 0;            ///< [N m] integral of normal force times way slid
  double erosion = 0;                  ///< [J] sum of m u^2 f(alpha) (wea.4)
};

/// Where the jar is hit, and what that does to it, in fixed memory: 0.1 MB.
class WallMap {
 public:
  explicit WallMap(const WallGrid& grid = {}) : grid_(grid), cells_(WallGrid::cells) {}
  const WallGrid& grid() const { return grid_; }
  WallSums& at(std::int64_t cell) { return cells_[static_cast<std::size_t>(cell)]; }
  const WallSums& operator[](int cell) const { return cells_[static_cast<std::size_t>(cell)]; }
  void merge(const WallMap& other);  ///< of the same grid
  void serialize(Archive& archive) { archive(cells_); }

 private:
  WallGrid grid_;
  std::vector<WallSums> cells_;
};

}  // namespace mahlwerk::observe

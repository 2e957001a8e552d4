// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/event/cells.hpp"

namespace mahlwerk::event {

/// Hierarchical grid for the neighbour search: a grid of cells for each size class, so that one
/// large ball among many small ones does not enlarge the neighbourhood of all. A class holds
/// diameters down to half its largest.
class HierarchicalGrid {
 public:
  /// Grid for `balls` balls of these `diameters` [m] (by species) in the box that begins at `low`
  /// [m] and is `size` [m] wide. A ball may stay in its cell's list until it is `slack`
  /// diameters beyond the border.
  HierarchicalGrid(const Vec3& low, const Vec3& size, bool periodic,
                   std::span<const double> diameters, double slack, std::size_t balls);

  int level_of(std::uint32_t species) const { return level_of_[species]; }
  Cell cell_at(int level, const Vec3& position) const { return cells(level).cell_at(position); }
  Cells::Borders borders(int level, Cell cell) const { return cells(level).borders(cell); }
  void insert(int level, std::int32_t ball, Cell cell) { cells(level).insert(ball, cell); }
  void remove(int level, std::int32_t ball, Cell cell) { cells(level).remove(ball, cell); }
  void clear();
  void prefetch(int level, Cell cell) const { cells(level).prefetch(cell); }
  void serialize(Archive& archive);
  bool contains(int level, std::int32_t ball, Cell cell) const {
    return cells(level).contains(ball, cell);
  }
  std::int64_t ball_count() const;  ///< in all cells
  /// Whether a periodic box has so few cells that any image of a ball may collide
  /// (Cells::needs_all_images).
  bool needs_all_images() const { return needs_all_images_; }

  /// Whether all balls of near() are at their nearest images: no periodic border is close.
  bool is_interior(int level, Cell cell) const {
    return levels_.size() == 1 && cells(level).is_interior(cell);
  }
  /// All balls that a ball of this level in this cell can touch before it leaves the cell, and
  /// possibly more. Valid until the next call with the same `buffer`, 0 or 1.
  std::span<const std::int32_t> near(int level, Cell cell, std::size_t buffer = 0);
  /// Those of near() that were not near the ball's previous cell `before`, and possibly more; in
  /// buffer 0.
  std::span<const std::int32_t> newly_near(int level, Cell cell, Cell before);

 private:
  struct Level {
    double widest;  // [m] diameter
    double slack;   // [m]
    Cells cells;
  };
  Cells& cells(int level) { return levels_[static_cast<std::size_t>(level)].cells; }
  const Cells& cells(int level) const { return levels_[static_cast<std::size_t>(level)].cells; }
  std::span<const std::int32_t> with_other_levels(int level, Cell cell, int count,
                                                  std::vector<std::int32_t>& found) const;

  std::vector<Level> levels_;
  std::vector<int> level_of_;                       // by species
  std::array<std::vector<std::int32_t>, 2> found_;  // buffers of near()
  bool needs_all_images_ = false;
};

}  // namespace mahlwerk::event

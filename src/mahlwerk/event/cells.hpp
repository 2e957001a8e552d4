// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/huge_page_allocator.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::event {

/// A cell's number: its three indices, ten bits each, so that extracting them needs no division.
using Cell = std::int32_t;

/// Cell list: a grid of cells at rest in the jar frame. Balls that can touch are in the same cell
/// or in neighbouring cells. A ball may stay in its cell's list until it is `slack` [m] beyond the
/// border.
class Cells {
 public:
  /// A grid over the box that begins at `low` [m] and is `size` [m] wide, periodic along all axes
  /// if `periodic`. Cells are at least `side` [m] wide, or half a period where that is less, so
  /// that no ball crosses the box without leaving its cell. There are at most about `most` cells.
  Cells(const Vec3& low, const Vec3& size, bool periodic, double side, double slack, double most);

  Cell cell_at(const Vec3& position) const;  ///< the nearest cell for positions outside
  void clear();
  void insert(std::int32_t ball, Cell cell);
  void remove(std::int32_t ball, Cell cell);

  /// Writes the balls in `cell` and in the 26 cells around it to `out`, which must hold
  /// max_neighbours() numbers. Returns their count.
  int near(Cell cell, std::int32_t* out) const;
  /// As near(), but without the balls that are also near the cell `before`, if the two cells share
  /// a face.
  int newly_near(Cell cell, Cell before, std::int32_t* out) const;
  /// Appends the balls of all cells that the box from `low` to `high` [m] overlaps; the box may be
  /// infinite.
  void within(const Vec3& low, const Vec3& high, std::vector<std::int32_t>& out) const;
  /// Prefetches the data that near() reads.
  void prefetch(Cell cell) const;
  void serialize(Archive& archive);
  bool contains(std::int32_t ball, Cell cell) const;  ///< false for an invalid cell
  std::int64_t ball_count() const;                    ///< in all cells
  int max_neighbours() const { return 27 * capacity_ + 4; }

  /// Whether no ball of near() is across a periodic border: the cell is at least two cells away
  /// from it, because a ball in the outermost cells may be beyond it.
  bool is_interior(Cell cell) const {
    const auto [x, y, z] = split(cell);
    return std::min({x, y, z}) >= 2 && x < counts_[0] - 2 && y < counts_[1] - 2 &&
           z < counts_[2] - 2;
  }

  /// Whether the minimum image convention can miss the first collision: a periodic box with fewer
  /// than five cells along an axis.
  bool needs_all_images() const {
    return periodic_ && std::min({counts_[0], counts_[1], counts_[2]}) < 5;
  }

  /// Box that a ball does not leave as long as it belongs to `cell` [m], slack included; infinite
  /// where there is no neighbouring cell.
  struct Borders {
    Vec3 low, high;
  };
  Borders borders(Cell cell) const;

 private:
  static constexpr int bits = 10;
  static constexpr std::int32_t mask = (1 << bits) - 1;
  static std::array<std::int32_t, 3> split(Cell cell) {
    return {cell & mask, (cell >> bits) & mask, cell >> (2 * bits)};
  }
  /// Storage index of a cell; index 0 stays empty and stands for "outside".
  std::int32_t cell_index(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return (z * counts_[1] + y) * counts_[0] + x + 1;
  }
  std::int32_t cell_index(Cell cell) const {
    const auto [x, y, z] = split(cell);
    return cell_index(x, y, z);
  }
  std::int32_t count() const { return counts_[0] * counts_[1] * counts_[2]; }
  void grow();
  int copy(std::int32_t place, std::int32_t* out, int n) const;

  Vec3 low_, side_, per_side_;
  double slack_;
  bool periodic_;
  std::array<std::int32_t, 3> counts_{};
  std::array<std::vector<std::int32_t>, 3> lower_neighbour_,
      upper_neighbour_;                  // neighbours along each axis, or -1
  int capacity_ = 4;                     // balls a cell can hold
  HugePageVector<std::int32_t> filled_;  // number of balls by cell
  HugePageVector<std::int32_t> slots_;   // balls, `capacity_` slots a cell
};

}  // namespace mahlwerk::event

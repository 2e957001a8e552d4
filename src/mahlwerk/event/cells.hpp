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

/// A cell's number: its three indices in ten bits each, so that none needs a division.
using Cell = std::int32_t;

/// A grid of cells at rest in the jar frame. Balls that can touch are in the same cell or in cells
/// next to each other; a ball belongs to its cell until it is `slack` beyond its border.
class Cells {
 public:
  /// A grid over the box from `low` on, `size` [m] wide, periodic along axes where `periodic`.
  /// Cells are at least `side` wide, or half a period, so that no ball goes round the box without
  /// leaving its cell; there are at most about `most` of them.
  Cells(const Vec3& low, const Vec3& size, bool periodic, double side, double slack, double most);

  Cell cell_at(const Vec3& position) const;  ///< places outside count to the nearest cell
  void clear();
  void insert(std::int32_t ball, Cell cell);
  void remove(std::int32_t ball, Cell cell);

  /// The balls in and next to `cell` into `out`, which must hold `max_neighbours()`; returns how
  /// many.
  int near(Cell cell, std::int32_t* out) const;
  /// Of those, the ones that are not near the neighbour `before` of `cell`.
  int newly_near(Cell cell, Cell before, std::int32_t* out) const;
  /// Appends the balls of all cells that the box from `low` to `high` reaches; it may be infinite.
  void within(const Vec3& low, const Vec3& high, std::vector<std::int32_t>& out) const;
  /// Sends for what `near` will read.
  void prefetch(Cell cell) const;
  void serialize(Archive& archive);
  bool contains(std::int32_t ball, Cell cell) const;  ///< any number may be asked for
  std::int64_t ball_count() const;                    ///< how many balls there are in all cells
  int max_neighbours() const { return 27 * capacity_ + 4; }

  /// Whether balls in cells next to each other may be nearer in another image than in the one they
  /// will meet in: a box repeats itself after fewer than five cells.
  bool needs_all_images() const {
    return periodic_ && std::min({counts_[0], counts_[1], counts_[2]}) < 5;
  }

  /// The box a ball may not leave as long as it belongs to `cell`, slack included; infinite where
  /// there is no other cell to go to.
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
  /// Where a cell's balls are kept; place 0 stays empty and stands for "outside".
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
  std::array<std::vector<std::int32_t>, 3> before_, after_;  // neighbours along each axis, or -1
  int capacity_ = 4;                                         // balls a cell can hold
  HugePageVector<std::int32_t> filled_;                      // how many it holds
  HugePageVector<std::int32_t> slots_;                       // which, `capacity_` places a cell
};

}  // namespace mahlwerk::event

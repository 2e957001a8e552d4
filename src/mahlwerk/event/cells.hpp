// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::event {

/// A grid of cells at rest in the jar frame. Balls that can touch are in the same cell or in cells
/// next to each other; a ball belongs to its cell until it is `slack` beyond its border.
class Cells {
 public:
  /// A grid over the box from `low` on, `size` [m] wide, periodic along axes where `periodic`. Cells
  /// are at least `side` wide; there are at most about `most` of them.
  Cells(const Vec3& low, const Vec3& size, bool periodic, double side, double slack, double most);

  std::int32_t cell_at(const Vec3& place) const;  ///< places outside count to the nearest cell
  void clear();
  void insert(std::int32_t ball, std::int32_t cell);
  void remove(std::int32_t ball, std::int32_t cell);

  /// The balls in and next to `cell` into `out`, which must hold `most_near()`; returns how many.
  int near(std::int32_t cell, std::int32_t* out) const;
  /// Of those, the ones that are not near the neighbour `before` of `cell`.
  int newly_near(std::int32_t cell, std::int32_t before, std::int32_t* out) const;
  int most_near() const { return 27 * capacity_ + 4; }

  /// The box a ball may not leave as long as it belongs to `cell`, slack included; infinite where
  /// there is no other cell to go to.
  struct Borders {
    Vec3 low, high;
  };
  Borders borders(std::int32_t cell) const;

  std::int32_t count() const { return counts_[0] * counts_[1] * counts_[2]; }

 private:
  std::array<std::int32_t, 3> split(std::int32_t cell) const;
  void grow();
  int copy(std::int32_t cell, std::int32_t* out, int n) const;

  static constexpr std::int32_t nowhere = 0;  // an empty cell that stands for "outside"

  Vec3 low_, side_;
  double slack_;
  bool periodic_;
  std::array<std::int32_t, 3> counts_{};
  std::array<std::vector<std::int32_t>, 3> before_, after_;  // neighbours along each axis, or -1
  int capacity_ = 4;                                         // balls a cell can hold
  std::vector<std::int32_t> filled_;                         // how many it holds
  std::vector<std::int32_t> slots_;                          // which, `capacity_` places a cell
};

}  // namespace mahlwerk::event

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

/// Bounds of positions [m], and their number.
struct PositionBounds {
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  std::size_t count = 0;

  void add(const Vec3& a) {
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y), std::max(high.z, a.z)};
    ++count;
  }
};

/// Cell grid (linked-cell method) for balls of similar size. Balls are sorted along a space-filling
/// curve (Z-order, Morton code), so that neighbours in space are close in memory.
class Grid {
 public:
  /// For balls with radii up to `radius` [m] within `bounds`, and pairs with gaps up to `margin`
  /// [m]. `periods` [m] are infinite where the box is not periodic.
  Grid(const PositionBounds& bounds, double radius, double margin, const Vec3& periods);

  double radius() const { return radius_; }  ///< [m] of the largest ball
  /// Morton code of the cell of a position.
  std::uint64_t key(const Vec3& position) const;
  /// Fills the cells with the balls of rows first to last - 1, which are in the order of the keys
  /// of `position(row)`.
  template <class Position>
  void fill(std::int32_t first, std::int32_t last, const Position& position) {
    clear();
    for (std::int32_t ball = first; ball < last; ++ball) {
      const std::size_t c = cell(position(ball));
      if (from_[c] == to_[c]) from_[c] = ball;
      to_[c] = ball + 1;
    }
  }

  std::size_t cell(const Vec3& position) const;
  /// Calls `f(first, last)` for ranges of balls. The ranges contain all balls whose centres are
  /// within `reach` [m] of `position` along each axis, and others.
  template <class F>
  void for_each_near(const Vec3& position, const Vec3& reach, const F& f) const {
    std::array<std::array<std::int32_t, 2>, 3> range{};
    for (std::size_t a = 0; a < 3; ++a) range[a] = cells(at(position, a), at(reach, a), a);
    for (std::int32_t z = range[2][0]; z <= range[2][1]; ++z)
      for (std::int32_t y = range[1][0]; y <= range[1][1]; ++y)
        for (std::int32_t x = range[0][0]; x <= range[0][1]; ++x) {
          const auto c = cell(wrapped(x, 0), wrapped(y, 1), wrapped(z, 2));
          if (from_[c] < to_[c]) f(from_[c], to_[c]);
        }
  }

 private:
  void clear();
  static double at(const Vec3& a, std::size_t axis) {
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
  }
  double folded(double x, std::size_t axis) const;
  std::int32_t index(double x, std::size_t axis) const;
  std::array<std::int32_t, 2> cells(double x, double reach, std::size_t axis) const;
  std::int32_t wrapped(std::int32_t c, std::size_t axis) const {
    const std::int32_t n = count_[axis];
    return !periodic_[axis] ? c : c < 0 ? c + n : c >= n ? c - n : c;
  }
  std::size_t cell(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }

  double radius_;
  std::array<double, 3> origin_{}, size_{}, period_{};
  std::array<bool, 3> periodic_{};
  std::array<std::int32_t, 3> count_{};
  std::vector<std::int32_t> from_, to_;  // range of balls of each cell
};

}  // namespace mahlwerk::soft

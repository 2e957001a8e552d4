// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::observe {

/// Balls sorted by the cubic cells of a grid, to find those near a point.
class SortedByCell {
 public:
  SortedByCell(std::span<const scene::Ball> balls, double side) : side_(side) {
    for (std::size_t i = 0; i < balls.size(); ++i) all_.push_back({cell_of(balls[i].position), i});
    std::ranges::sort(all_, [](const Entry& a, const Entry& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.ball < b.ball;
    });
  }
  /// Calls `f(first, last)` for the balls of each cell that is not empty.
  template <class F>
  void each_cell(const F& f) const {
    for (std::size_t from = 0, to = 0; from < all_.size(); from = to) {
      for (to = from; to < all_.size() && all_[to].cell == all_[from].cell;) ++to;
      f(from, to);
    }
  }
  std::size_t ball(std::size_t at) const { return all_[at].ball; }
  /// Calls `f(ball)` for all balls in the 27 cells around a point.
  template <class F>
  void around(const Vec3& p, const F& f) const {
    const Cell c = cell_of(p);
    for (std::int64_t x = c[0] - 1; x <= c[0] + 1; ++x)
      for (std::int64_t y = c[1] - 1; y <= c[1] + 1; ++y) {
        auto at = std::ranges::lower_bound(all_, Cell{x, y, c[2] - 1}, {}, &Entry::cell);
        for (; at != all_.end() && at->cell <= Cell{x, y, c[2] + 1}; ++at) f(at->ball);
      }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    std::size_t ball;
  };
  Cell cell_of(const Vec3& p) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / side_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }

  double side_;
  std::vector<Entry> all_;
};

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/mixing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace mahlwerk::observe {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& p, double side) {
  const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / side)); };
  return {index(p.x), index(p.y), index(p.z)};
}

/// Balls sorted by the cells of a grid.
class SortedByCell {
 public:
  SortedByCell(std::span<const scene::Ball> balls, double side) : side_(side) {
    for (std::size_t i = 0; i < balls.size(); ++i)
      all_.push_back({cell_of(balls[i].position, side), i});
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
    const Cell c = cell_of(p, side_);
    for (std::int64_t x = c[0] - 1; x <= c[0] + 1; ++x)
      for (std::int64_t y = c[1] - 1; y <= c[1] + 1; ++y) {
        auto at = std::ranges::lower_bound(all_, Cell{x, y, c[2] - 1}, {}, &Entry::cell);
        for (; at != all_.end() && at->cell <= Cell{x, y, c[2] + 1}; ++at) f(at->ball);
      }
  }

 private:
  struct Entry {
    Cell cell;
    std::size_t ball;
  };
  double side_;
  std::vector<Entry> all_;
};

double lacey(const SortedByCell& cells, std::span<const std::uint8_t> colours) {
  double balls = 0, marked = 0, count = 0;
  for (const std::uint8_t colour : colours) marked += colour;
  balls = static_cast<double>(colours.size());
  const double share = marked / balls, separated = share * (1 - share);
  double variance = 0;
  cells.each_cell([&](std::size_t from, std::size_t to) {
    const auto n = static_cast<double>(to - from);
    double of = 0;
    for (std::size_t k = from; k < to; ++k) of += colours[cells.ball(k)];
    variance += n * (of / n - share) * (of / n - share);
    ++count;
  });
  variance /= balls;
  const double mixed = separated * count / balls;  // of n-weighted binomial cells
  return separated > mixed ? (separated - variance) / (separated - mixed) : unknown;
}

}  // namespace

MixingIndex mixing_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                         double cell, double reach) {
  MixingIndex found{unknown, unknown};
  double marked = 0;
  for (const std::uint8_t colour : colours) marked += colour;
  const auto count = static_cast<double>(balls.size());
  if (marked == 0 || marked == count) return found;
  found.lacey = lacey(SortedByCell(balls, cell), colours);
  const SortedByCell near(balls, reach);
  double sum = 0, with = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    double all = 0, others = 0;
    near.around(balls[i].position, [&](std::size_t j) {
      if (j == i || !(squared(balls[j].position - balls[i].position) < reach * reach)) return;
      ++all;
      others += colours[j] != colours[i] ? 1 : 0;
    });
    if (all == 0) continue;
    const double expected = (colours[i] != 0 ? count - marked : marked) / (count - 1);
    sum += others / all / expected;
    ++with;
  }
  if (with > 0) found.neighbours = sum / with;
  return found;
}

double common_volume(double a, double b, double distance) {
  constexpr double pi = std::numbers::pi;
  if (distance >= a + b) return 0;
  const double small = std::min(a, b);
  if (distance <= std::abs(a - b)) return 4 * pi / 3 * small * small * small;
  const double gap = a + b - distance;
  return pi * gap * gap * (distance * distance + 2 * distance * (a + b) - 3 * (a - b) * (a - b)) /
         (12 * distance);
}

double packing_around(std::span<const scene::Ball> balls, const Vec3& point, double radius) {
  double volume = 0;
  for (const scene::Ball& b : balls)
    volume += common_volume(radius, b.radius, norm(b.position - point));
  return volume / (4 * std::numbers::pi / 3 * radius * radius * radius);
}

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/grid.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::soft {
namespace {

/// Spreads the low 21 bits to every third bit of 63 (Morton code).
std::uint64_t spread(std::uint64_t a) {
  a &= 0x1fffff;
  a = (a | a << 32) & 0x1f00000000ffff;
  a = (a | a << 16) & 0x1f0000ff0000ff;
  a = (a | a << 8) & 0x100f00f00f00f00f;
  a = (a | a << 4) & 0x10c30c30c30c30c3;
  return (a | a << 2) & 0x1249249249249249;
}

}  // namespace

Grid::Grid(const PositionBounds& bounds, double radius, double margin, const Vec3& periods)
    : radius_(radius) {
  constexpr double max_cells_per_axis = 1 << 20;
  const double cell = 2 * radius + margin;
  std::array<double, 3> extent{};
  for (std::size_t a = 0; a < 3; ++a) {
    period_[a] = at(periods, a);
    periodic_[a] = std::isfinite(period_[a]);
    double least = -0.5 * period_[a], most = 0.5 * period_[a];
    if (!periodic_[a]) least = most = 0;
    if (!periodic_[a] && bounds.count > 0) least = at(bounds.low, a), most = at(bounds.high, a);
    origin_[a] = least;
    extent[a] = most - least;
  }
  // Enlarges the cells if a few balls in a large volume would need too many.
  const double enough = 4096 + 8.0 * static_cast<double>(bounds.count);
  double wide = cell;
  const auto cells_of = [&](double size) {
    double all = 1;
    for (const double e : extent) all *= std::floor(e / size) + 1;
    return all;
  };
  while (cells_of(wide) > enough) wide *= 1.2;
  for (std::size_t a = 0; a < 3; ++a) {
    const double n = periodic_[a] ? std::max(1.0, std::floor(extent[a] / wide))
                                  : std::floor(extent[a] / wide) + 1;
    count_[a] = static_cast<std::int32_t>(std::min(n, max_cells_per_axis));
    size_[a] = periodic_[a] ? extent[a] / count_[a] : wide;
  }
}

double Grid::folded(double x, std::size_t axis) const {
  return periodic_[axis] ? std::remainder(x, period_[axis]) : x;
}
std::int32_t Grid::index(double x, std::size_t axis) const {
  const double c = std::floor((x - origin_[axis]) / size_[axis]);
  return static_cast<std::int32_t>(std::clamp(c, 0.0, static_cast<double>(count_[axis] - 1)));
}
std::uint64_t Grid::key(const Vec3& p) const {
  std::uint64_t all = 0;
  for (std::size_t a = 0; a < 3; ++a)
    all |= spread(static_cast<std::uint64_t>(index(folded(at(p, a), a), a))) << a;
  return all;
}

std::size_t Grid::cell(const Vec3& p) const {
  return cell(index(folded(p.x, 0), 0), index(folded(p.y, 1), 1), index(folded(p.z, 2), 2));
}

void Grid::clear() {
  const auto count = static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                     static_cast<std::size_t>(count_[2]);
  from_.assign(count, 0);
  to_.assign(count, 0);
}

std::array<std::int32_t, 2> Grid::cells(double x, double reach, std::size_t axis) const {
  if (!periodic_[axis]) return {index(x - reach, axis), index(x + reach, axis)};
  const double from = (folded(x, axis) - origin_[axis]) / size_[axis], more = reach / size_[axis];
  const auto low = static_cast<std::int32_t>(std::floor(from - more));
  const auto high = static_cast<std::int32_t>(std::floor(from + more));
  if (high - low + 1 >= count_[axis]) return {0, count_[axis] - 1};
  return {low, high};
}

}  // namespace mahlwerk::soft

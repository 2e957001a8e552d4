// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/sphere_union.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mahlwerk::geometry {
namespace {

/// Integrals over a column of unit area at x, y: of 1, z and z^2.
struct ColumnIntegrals {
  double length = 0, first = 0, second = 0;
};

/// Sorts `pieces`, the intervals of a column in the spheres, and integrates over their union.
ColumnIntegrals over_union(std::vector<std::pair<double, double>>& pieces, Hollows hollows) {
  std::ranges::sort(pieces);
  ColumnIntegrals sum;
  const auto add = [&](double low, double high) {
    sum.length += high - low;
    sum.first += (high * high - low * low) / 2;
    sum.second += (high * high * high - low * low * low) / 3;
  };
  auto [low, high] = pieces.front();
  for (const auto& [from, to] : pieces) {
    if (from > high && hollows == Hollows::open) {
      add(low, high);
      low = from, high = to;
    }
    high = std::max(high, to);
  }
  add(low, high);
  return sum;
}

}  // namespace

SolidMoments union_moments(std::span<const MemberSphere> spheres, int columns, Hollows hollows) {
  Vec3 low{INFINITY, INFINITY, 0}, high{-INFINITY, -INFINITY, 0};
  for (const MemberSphere& s : spheres) {
    low.x = std::min(low.x, s.centre.x - s.radius),
    high.x = std::max(high.x, s.centre.x + s.radius);
    low.y = std::min(low.y, s.centre.y - s.radius),
    high.y = std::max(high.y, s.centre.y + s.radius);
  }
  const double step = std::max(high.x - low.x, high.y - low.y) / columns;
  const auto count = [&](double length) { return static_cast<int>(std::ceil(length / step)); };
  const int nx = count(high.x - low.x), ny = count(high.y - low.y);
  const double hx = (high.x - low.x) / nx, hy = (high.y - low.y) / ny;
  double volume = 0;
  Vec3 first, squares, products;
  std::vector<std::pair<double, double>> pieces;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const double x = low.x + (i + 0.5) * hx, y = low.y + (j + 0.5) * hy;
      pieces.clear();
      for (const MemberSphere& s : spheres) {
        const double dx = x - s.centre.x, dy = y - s.centre.y;
        const double left = s.radius * s.radius - dx * dx - dy * dy;
        if (!(left > 0)) continue;
        const double half = std::sqrt(left);
        pieces.emplace_back(s.centre.z - half, s.centre.z + half);
      }
      if (pieces.empty()) continue;
      const auto [length, along, second] = over_union(pieces, hollows);
      volume += length;
      first += Vec3{x * length, y * length, along};
      squares += Vec3{x * x * length, y * y * length, second};
      products += Vec3{x * y * length, y * along, x * along};
    }
  const double area = hx * hy;
  SolidMoments m;
  m.volume = area * volume;
  m.centroid = first / volume;
  const Vec3& c = m.centroid;
  m.squares = area * (squares - volume * Vec3{c.x * c.x, c.y * c.y, c.z * c.z});
  m.products = area * (products - volume * Vec3{c.x * c.y, c.y * c.z, c.z * c.x});
  return m;
}

}  // namespace mahlwerk::geometry

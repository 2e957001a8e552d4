// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/box_tree.hpp"

#include <cmath>
#include <limits>

namespace mahlwerk::geometry {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

float below(double x) {
  return std::nextafter(static_cast<float>(x), -infinite);
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), infinite);
}

}  // namespace

BoxTree::Box BoxTree::Box::empty() {
  const Four most{infinite, infinite, infinite, infinite};
  Box box;
  box.low = most, box.high = -most;
  return box;
}

void BoxTree::Box::add(const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    const double x = p.x * axes[0][k] + p.y * axes[1][k] + p.z * axes[2][k];
    low[k] = std::min(low[k], below(x));
    high[k] = std::max(high[k], above(x));
  }
}

void BoxTree::Box::add(const Box& other) {
  low = other.low < low ? other.low : low;
  high = other.high > high ? other.high : high;
}

/// Splits at the median along the axis on which the centres of the boxes spread most.
BoxTree::Item BoxTree::build(std::span<Item> items) {
  for (const Item& i : items)
    for (int k = 0; k < 3; ++k)
      widest_ = std::max({widest_, std::abs(static_cast<double>(i.box.low[k])),
                          std::abs(static_cast<double>(i.box.high[k]))});
  if (items.size() == 1) return items[0];
  const auto middle = [](const Item& i, int k) { return i.box.low[k] + i.box.high[k]; };
  int axis = 0;
  float widest = -1;
  for (int k = 0; k < 3; ++k) {
    const auto [least, most] =
        std::ranges::minmax(items, {}, [&](const Item& i) { return middle(i, k); });
    const float spread = middle(most, k) - middle(least, k);
    if (spread > widest) widest = spread, axis = k;
  }
  const std::size_t half = items.size() / 2;
  std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(half), {},
                           [&](const Item& i) { return middle(i, axis); });
  const auto id = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  const Item a = build(items.first(half)), b = build(items.subspan(half));
  nodes_[static_cast<std::size_t>(id)] = {{a.box, b.box}, {a.id, b.id}};
  Item all{id, a.box};
  all.box.add(b.box);
  return all;
}

/// The smaller one of a box along the axes and one along the mean normal of the pieces and the
/// direction in which they extend most across it.
BoxTree::Box BoxTree::smaller_around(const Box& along_axes, std::span<const Piece> pieces) {
  Vec3 area, far_corner;
  for (const Piece& piece : pieces) area += piece.area;
  if (!(squared(area) > 0)) return along_axes;
  const Vec3 normal = area / norm(area);
  double most = 0;
  const Vec3 from = pieces[0].corner[0];
  for (const Piece& piece : pieces)
    for (const Vec3& c : piece.corner) {
      const Vec3 way = c - from, across = way - dot(way, normal) * normal;
      if (squared(across) > most) most = squared(across), far_corner = across;
    }
  if (!(most > 0)) return along_axes;
  const Vec3 first = far_corner / std::sqrt(most), second = cross(normal, first);
  Box box = Box::empty();
  const auto column = [](double a, double b, double c) {
    return Four{static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), 0};
  };
  box.axes = {column(first.x, second.x, normal.x), column(first.y, second.y, normal.y),
              column(first.z, second.z, normal.z)};
  for (const Piece& piece : pieces)
    for (const Vec3& c : piece.corner) box.add(c);
  const auto surface = [](const Box& b) {
    const Four size = b.high - b.low;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  };
  return surface(box) < surface(along_axes) ? box : along_axes;
}

}  // namespace mahlwerk::geometry

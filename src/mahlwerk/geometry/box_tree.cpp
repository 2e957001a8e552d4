// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/box_tree.hpp"

#include <cmath>
#include <limits>

namespace mahlwerk::geometry {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

float below(double x) {
  return std::nextafter(static_cast<float>(x), -far);
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), far);
}

}  // namespace

BoxTree::Box BoxTree::Box::empty() {
  const Four most{far, far, far, far};
  return {most, -most};
}

void BoxTree::Box::add(const Vec3& p) {
  const std::array<double, 3> x{p.x, p.y, p.z};
  for (int k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], below(x[static_cast<std::size_t>(k)]));
    high[k] = std::max(high[k], above(x[static_cast<std::size_t>(k)]));
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

}  // namespace mahlwerk::geometry

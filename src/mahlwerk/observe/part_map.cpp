// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/part_map.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::observe {

PartGrid::PartGrid(const Vec3& least, const Vec3& most, double finest) {
  const std::array from{least.x, least.y, least.z}, to{most.x, most.y, most.z};
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, to[k] - from[k]);
  edge_ = std::max(longest / along_longest, finest);
  constexpr double rounding = 1e-9;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = to[k] - from[k];
    counts_[k] = std::max(1, static_cast<int>(std::ceil(length / edge_ - rounding)));
    least_[k] = 0.5 * (from[k] + to[k] - counts_[k] * edge_);
  }
  for (int s = 0; s < sides; ++s) {
    const auto [along, across] = counts(static_cast<Side>(s));
    first_[static_cast<std::size_t>(s) + 1] = first_[static_cast<std::size_t>(s)] + along * across;
  }
}

std::array<int, 2> PartGrid::axes(Side side) {
  if (side <= right) return {1, 2};
  return side <= back ? std::array{0, 2} : std::array{0, 1};
}

std::array<int, 2> PartGrid::counts(Side side) const {
  const auto [along, across] = axes(side);
  return {counts_[static_cast<std::size_t>(along)], counts_[static_cast<std::size_t>(across)]};
}

int PartGrid::cell_of(const Vec3& where, const Vec3& outward) const {
  // Faces at 45 degrees to two axes go to the same view all over, whatever the rounding.
  constexpr double preferred = 1.001;
  const double x = std::abs(outward.x), y = std::abs(outward.y),
               z = preferred * std::abs(outward.z);
  const Side side = z >= std::max(x, y)  ? (outward.z < 0 ? bottom : top)
                    : preferred * x >= y ? (outward.x < 0 ? left : right)
                                         : (outward.y < 0 ? front : back);
  const std::array p{where.x, where.y, where.z};
  const auto slot = [&](int axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double most = counts_[k] - 1;
    return static_cast<int>(std::clamp(std::floor((p[k] - least_[k]) / edge_), 0.0, most));
  };
  const auto [along, across] = axes(side);
  return first(side) + slot(across) * counts(side)[0] + slot(along);
}

PartGrid::Side PartGrid::side(int cell) const {
  return static_cast<Side>(std::ranges::upper_bound(first_, cell) - first_.begin() - 1);
}

PartGrid::Bounds PartGrid::bounds(int cell) const {
  const Side of = side(cell);
  const int in_view = cell - first(of), columns = counts(of)[0];
  const auto range = [&](int axis, int at) {
    const double from = least_[static_cast<std::size_t>(axis)];
    return std::array{from + at * edge_, from + (at + 1) * edge_};
  };
  const auto [along, across] = axes(of);
  return {range(along, in_view % columns), range(across, in_view / columns)};
}

}  // namespace mahlwerk::observe

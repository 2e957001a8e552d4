// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/bed.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::observe {
namespace {

constexpr int enough = 3;  // bodies that hold a ball in place

/// A ball in the jar's own axes.
struct Placed {
  Vec3 at;
  double radius = 0, mass = 0;
};

/// Balls by columns of a square grid across the jar's axis, so that balls within `reach` of each
/// other are in the same or in neighbouring columns.
class Columns {
 public:
  Columns(const std::vector<Placed>& balls, double reach, double period)
      : balls_(balls), period_(period) {
    const auto [x0, x1] = std::ranges::minmax(balls, {}, [](const Placed& b) { return b.at.x; });
    const auto [y0, y1] = std::ranges::minmax(balls, {}, [](const Placed& b) { return b.at.y; });
    x_ = x0.at.x, y_ = y0.at.y;
    // No more columns than a few a ball, however far a ball is from the others.
    const double across = std::sqrt(4 * static_cast<double>(balls.size()));
    width_ = std::max({reach, (x1.at.x - x_) / across, (y1.at.y - y_) / across});
    wide_ = static_cast<std::size_t>((x1.at.x - x_) / width_) + 1;
    high_ = static_cast<std::size_t>((y1.at.y - y_) / width_) + 1;
    first_.assign(wide_ * high_ + 1, 0);
    for (const Placed& b : balls) ++first_[column(b.at) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    sorted_.resize(balls.size());
    std::vector<std::size_t> next = first_;
    for (std::size_t i = 0; i < balls.size(); ++i) sorted_[next[column(balls[i].at)]++] = i;
  }

  /// The number of balls within `gap` of ball `i`, counted up to `most`.
  int near(std::size_t i, double gap, int most) const {
    const Placed& b = balls_[i];
    const std::size_t cx = column_x(b.at), cy = column_y(b.at);
    int found = 0;
    for (std::size_t y = cy > 0 ? cy - 1 : 0; y < std::min(cy + 2, high_); ++y)
      for (std::size_t x = cx > 0 ? cx - 1 : 0; x < std::min(cx + 2, wide_); ++x)
        for (std::size_t k = first_[y * wide_ + x]; k < first_[y * wide_ + x + 1]; ++k)
          if (sorted_[k] != i && touches(b, balls_[sorted_[k]], gap) && ++found >= most)
            return found;
    return found;
  }

 private:
  bool touches(const Placed& a, const Placed& b, double gap) const {
    Vec3 d = a.at - b.at;
    if (period_ > 0) d.z = std::remainder(d.z, period_);
    const double within = a.radius + b.radius + gap;
    return squared(d) < within * within;
  }
  std::size_t column_x(const Vec3& p) const {
    return static_cast<std::size_t>((p.x - x_) / width_);
  }
  std::size_t column_y(const Vec3& p) const {
    return static_cast<std::size_t>((p.y - y_) / width_);
  }
  std::size_t column(const Vec3& p) const { return column_y(p) * wide_ + column_x(p); }

  const std::vector<Placed>& balls_;
  double period_, x_ = 0, y_ = 0, width_ = 1;
  std::size_t wide_ = 1, high_ = 1;
  std::vector<std::size_t> first_, sorted_;
};

/// The walls near a ball: whether it is at the jar's side, and how many others are near.
struct Walls {
  bool at_side = false;
  int others = 0;
};
template <class S>
Walls walls_near(const S& jar, const Placed& b, double gap, double radius) {
  constexpr double side = 0.7;  // of the normal along the jar's axis: an end rather than the side
  Walls walls;
  if constexpr (std::is_same_v<S, geometry::Mesh> || std::is_same_v<S, geometry::Attritor>) {
    walls.at_side = radius - math::hypot(b.at.x, b.at.y) - b.radius < gap;
  } else {
    for (int face = 0; face < jar.faces && !walls.at_side; ++face) {
      const geometry::Gap wall = jar.gap(face, b.at);
      if (!(wall.distance - b.radius < gap)) continue;
      if (std::abs(wall.inward.z) < side)
        walls.at_side = true;
      else
        ++walls.others;
    }
  }
  return walls;
}

double period_along_axis(const geometry::AnyShape& jar) {
  const double period = geometry::periods(jar).z;
  return std::isfinite(period) ? period : 0;
}

}  // namespace

double mass_outside_bed(const std::vector<scene::Ball>& balls, const geometry::AnyShape& jar,
                        const Rotation& own, double radius) {
  if (balls.empty()) return 0;
  std::vector<Placed> placed;
  double largest = 0, outside = 0;
  for (const scene::Ball& b : balls) {
    placed.push_back({own.apply_inverse(b.position), b.radius, b.mass()});
    largest = std::max(largest, b.radius);
  }
  const Columns columns(placed, 2 * largest * (1 + support_gap), period_along_axis(jar));
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Placed& b = placed[i];
    const double gap = support_gap * 2 * b.radius;
    if (columns.near(i, gap, enough) >= enough) continue;
    const Walls walls =
        std::visit([&](const auto& s) { return walls_near(s, b, gap, radius); }, jar);
    if (!walls.at_side && walls.others + columns.near(i, gap, enough) < enough) outside += b.mass;
  }
  return outside;
}

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/observe/cells.hpp"
#include "mahlwerk/observe/images.hpp"

namespace mahlwerk::observe {
namespace {

constexpr double most_grid_points = 2e7;
constexpr double about_places = 4000;

using Index = std::array<std::int64_t, 3>;

/// Points of a regular grid around the balls, each with what is known of it. Its spacing has no
/// ratio of small whole numbers to the diameter, so that lattices are sampled evenly.
class BedGrid {
 public:
  /// `with_images`: the balls and their images as far as touch a ball in the jar.
  BedGrid(const PackedJar& jar, std::span<const scene::Ball> with_images)
      : jar_(jar), depth_(packing_radius(jar) + jar.diameter) {
    lay_out();
    if (!too_coarse()) cover(with_images);
  }
  /// Whether the balls are so far apart that the grid does not resolve their bed.
  bool too_coarse() const { return spacing_ > jar_.diameter; }

  /// Calls `f(point)` for each `every`-th point along each axis that is near balls and between the
  /// outermost centres.
  template <class F>
  void candidates(std::int64_t every, const F& f) const {
    for (std::int64_t x = rim_[0]; x < count_[0] - rim_[0]; x += every)
      for (std::int64_t y = rim_[1]; y < count_[1] - rim_[1]; y += every)
        for (std::int64_t z = rim_[2]; z < count_[2] - rim_[2]; z += every)
          if (known_[at({x, y, z})] == covered) f(Index{x, y, z});
  }
  double spacing() const { return spacing_; }  ///< [m]
  /// Whether no place where another ball fits is within a sphere's radius and a diameter.
  bool in_bed(const Index& p) {
    for (const Index& away : sphere_)
      if (fits(sum(p, away))) return false;
    return true;
  }
  Vec3 point(const Index& i) const {
    return {coordinate(i, 0), coordinate(i, 1), coordinate(i, 2)};
  }

 private:
  enum State : std::uint8_t { unknown, covered, room, wall };

  static double of(const Vec3& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  }
  bool periodic(std::size_t axis) const { return std::isfinite(of(jar_.periods, axis)); }
  double coordinate(const Index& i, std::size_t axis) const {
    return low_[axis] + (static_cast<double>(i[axis]) + 0.5) * side_[axis];
  }
  static Index sum(const Index& a, const Index& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
  std::size_t at(const Index& i) const {
    return static_cast<std::size_t>((i[0] * count_[1] + i[1]) * count_[2] + i[2]);
  }
  /// The same point of the grid of a periodic jar; false where it is beyond the grid.
  bool fold(Index& i) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (periodic(a)) i[a] = (i[a] % count_[a] + count_[a]) % count_[a];
      if (i[a] < 0 || i[a] >= count_[a]) return false;
    }
    return true;
  }
  /// Spacing and extent: the box of the centres and `depth_` more on each side, or a period.
  void lay_out() {
    std::array<double, 3> length{};
    double volume = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const scene::Ball& b : jar_.balls) {
        low = std::min(low, of(b.position, a)), high = std::max(high, of(b.position, a));
      }
      low_[a] = periodic(a) ? -0.5 * of(jar_.periods, a) : low;
      length[a] = periodic(a) ? of(jar_.periods, a) : high - low;
      volume *= length[a] + (periodic(a) ? 0 : 2 * depth_);
    }
    spacing_ = std::max(jar_.diameter / std::numbers::phi, math::cbrt(volume / most_grid_points));
    const auto whole = [](double x) { return static_cast<std::int64_t>(std::ceil(x)); };
    for (std::size_t a = 0; a < 3; ++a) {
      count_[a] = std::max<std::int64_t>(1, whole(length[a] / spacing_));
      side_[a] = periodic(a) ? length[a] / static_cast<double>(count_[a]) : spacing_;
      rim_[a] = periodic(a) ? 0 : whole((depth_ + spacing_) / spacing_);
      low_[a] -= static_cast<double>(rim_[a]) * spacing_;
      count_[a] += 2 * rim_[a];
    }
    // One spacing more, as places between the points of the grid are not seen.
    std::array<std::int64_t, 3> reach{};
    for (std::size_t a = 0; a < 3; ++a) reach[a] = whole((depth_ + spacing_) / side_[a]);
    for (std::int64_t x = -reach[0]; x <= reach[0]; ++x)
      for (std::int64_t y = -reach[1]; y <= reach[1]; ++y)
        for (std::int64_t z = -reach[2]; z <= reach[2]; ++z) {
          const Vec3 away{static_cast<double>(x) * side_[0], static_cast<double>(y) * side_[1],
                          static_cast<double>(z) * side_[2]};
          if (norm(away) < depth_ + spacing_) sphere_.push_back({x, y, z});
        }
  }
  /// Marks the points where another ball of the mean diameter would overlap one that is there.
  void cover(std::span<const scene::Ball> with_images) {
    known_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]), unknown);
    for (const scene::Ball& b : with_images) {
      const double reach = b.radius + 0.5 * jar_.diameter;
      Index from{}, to{};
      for (std::size_t a = 0; a < 3; ++a) {
        const double c = of(b.position, a) - low_[a];
        from[a] = std::max<std::int64_t>(
            0, static_cast<std::int64_t>(std::floor((c - reach) / side_[a] - 0.5)));
        to[a] = std::min(count_[a] - 1, static_cast<std::int64_t>((c + reach) / side_[a]));
      }
      for (std::int64_t x = from[0]; x <= to[0]; ++x)
        for (std::int64_t y = from[1]; y <= to[1]; ++y)
          for (std::int64_t z = from[2]; z <= to[2]; ++z)
            if (squared(point({x, y, z}) - b.position) < reach * reach)
              known_[at({x, y, z})] = covered;
    }
  }
  /// Whether another ball of the mean diameter fits there.
  bool fits(Index i) {
    const double half = 0.5 * jar_.diameter;
    if (!fold(i)) return jar_.clearance(point(i), half) >= half;
    std::uint8_t& state = known_[at(i)];
    if (state == unknown) state = jar_.clearance(point(i), half) >= half ? room : wall;
    return state == room;
  }

  const PackedJar& jar_;
  double depth_;  // [m] a sphere's radius and a diameter
  double spacing_ = 0;
  std::array<double, 3> low_{}, side_{};
  Index count_{}, rim_{};
  std::vector<Index> sphere_;
  std::vector<std::uint8_t> known_;
};

}  // namespace

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

std::vector<LocalPacking> packing_in_bed(const PackedJar& jar) {
  std::vector<LocalPacking> found;
  if (jar.balls.empty()) return found;
  const double radius = packing_radius(jar);
  double largest = 0, volume = 0;
  for (const scene::Ball& b : jar.balls) {
    largest = std::max(largest, b.radius);
    volume += 4 * std::numbers::pi / 3 * b.radius * b.radius * b.radius;
  }
  const std::vector<scene::Ball> all = images(jar.balls, jar.periods, radius + largest).balls;
  BedGrid grid(jar, all);
  if (grid.too_coarse()) return found;
  constexpr double usual = 0.6;  // packing, for the volume of the bed
  const double apart = math::cbrt(volume / usual / about_places) / grid.spacing();
  const SortedByCell near(all, radius + largest);
  std::vector<scene::Ball> within;
  grid.candidates(std::max<std::int64_t>(1, std::llround(apart)), [&](const Index& i) {
    const Vec3 p = grid.point(i);
    if (!(jar.clearance(p, radius) >= radius) || !grid.in_bed(i)) return;
    within.clear();
    near.around(p, [&](std::size_t k) { within.push_back(all[k]); });
    found.push_back({p, packing_around(within, p, radius)});
  });
  return found;
}

}  // namespace mahlwerk::observe

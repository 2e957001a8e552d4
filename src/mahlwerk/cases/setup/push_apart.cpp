// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/push_apart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/setup/places.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

/// Soft spheres of unit stiffness that lose their energy as fast as may be: "fast inertial
/// relaxation", Bitzek et al., Phys. Rev. Lett. 97, 170201 (2006).
class Soft {
 public:
  Soft(std::vector<Placed>& balls, const geometry::AnyShape& shape, const Room& room, double gap)
      : balls_(balls), shape_(shape), room_(room), gap_(gap) {
    const auto [least, most] = std::ranges::minmax(balls, {}, &Placed::radius);
    smallest_ = least.radius;
    std::ptrdiff_t sizes = 1;
    skin_ = 0.6 * smallest_;
    const std::size_t n = balls.size();
    force_.resize(n);
    speed_.resize(n);
    for (const Placed& b : balls) {
      mass_.push_back(b.radius * b.radius / (smallest_ * smallest_));
      margin_.push_back(wall_clearance(shape, b.radius, gap));
    }
    constexpr std::ptrdiff_t few = 4;
    for (std::size_t i = 1; i < n; ++i) sizes += balls[i].radius != balls[i - 1].radius ? 1 : 0;
    many_sizes_ = sizes > few;
    double mean = 0;
    for (const Placed& b : balls) mean += b.radius / static_cast<double>(n);
    if (many_sizes_) skin_ = 0.6 * mean;
    find_neighbours();
  }

  Pushed run(std::int64_t most, const std::atomic<bool>* stop) {
    constexpr double at_rest = 1e-3;  // force left over, of that in the contacts
    Pushed end;
    for (;;) {
      if (stop != nullptr && *stop) throw Interrupted();
      feel();
      end.moves += static_cast<std::int64_t>(balls_.size());
      end.free = pair_overlap_ <= 0.5 * gap_ && wall_overlap_ <= 0.5;
      if (end.free || net_ <= at_rest * at_rest * pressing_ || end.moves > most) break;
      move();
    }
    end.largest = largest_;
    end.typical = contacts_ > 0 ? 1 + gap_ - overlaps_ / static_cast<double>(contacts_) : 1.0;
    return end;
  }

 private:
  double radii(std::pair<int, int> pair) const {
    return at(pair.first).radius + at(pair.second).radius;
  }
  const Placed& at(int i) const { return balls_[static_cast<std::size_t>(i)]; }

  /// All pairs near enough to overlap before a ball has moved by half the skin.
  void find_neighbours() {
    pairs_.clear();
    std::vector<Grid> grids;  // one for each size, or for all down to half as wide
    for (std::size_t from = 0, to = 0; from < balls_.size(); from = to) {
      const double radius = balls_[from].radius, least = many_sizes_ ? 0.5 * radius : radius;
      for (to = from; to < balls_.size() && balls_[to].radius >= least;) ++to;
      const double reach = 2 * radius * (1 + gap_) + skin_;
      Grid& own = grids.emplace_back(room_, reach, to - from);
      for (std::size_t i = from; i < to; ++i) {
        for (const Grid& grid : grids) near(grid, static_cast<int>(i));
        own.add(static_cast<int>(i), balls_[i].place);
      }
    }
    listed_.clear();
    for (const Placed& b : balls_) listed_.push_back(b.place);
  }
  void near(const Grid& grid, int i) {
    grid.around(at(i).place, [&](int j) {
      const double reach = (at(i).radius + at(j).radius) * (1 + gap_) + skin_;
      if (squared(room_.between(at(i).place, at(j).place)) < reach * reach)
        pairs_.emplace_back(i, j);
      return true;
    });
  }

  /// Forces, and how far from free everything is.
  void feel() {
    pair_overlap_ = wall_overlap_ = pressing_ = net_ = overlaps_ = 0;
    contacts_ = 0;
    largest_ = 1;
    std::ranges::fill(force_, Vec3{});
    for (const auto& pair : pairs_) feel(pair);
    std::visit([&](const auto& shape) { feel_walls(shape); }, shape_);
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (balls_[i].held) force_[i] = {};
      net_ += squared(force_[i]);
    }
  }
  void feel(std::pair<int, int> pair) {
    const Vec3 apart = room_.between(at(pair.first).place, at(pair.second).place);
    const double sum = radii(pair), wanted = sum * (1 + gap_), d2 = squared(apart);
    if (d2 >= wanted * wanted || (at(pair.first).held && at(pair.second).held)) return;
    const double d = std::sqrt(d2), overlap = wanted - d;
    const Vec3 push = d > 0 ? overlap / d * apart : Vec3{0, 0, overlap};
    force_[static_cast<std::size_t>(pair.first)] -= push;
    force_[static_cast<std::size_t>(pair.second)] += push;
    pressing_ += overlap * overlap;
    overlaps_ += overlap / sum;
    ++contacts_;
    pair_overlap_ = std::max(pair_overlap_, overlap / sum);
    largest_ = std::min(largest_, d / sum);
  }
  template <class S>
  void feel_walls(const S& shape) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (balls_[i].held) continue;
      const double r = balls_[i].radius, wanted = r + margin_[i];
      geometry::each_wall(shape, balls_[i].place, r, wanted, [&](int, const geometry::Gap& gap) {
        const double overlap = wanted - gap.distance;
        if (!(overlap > 0)) return;
        force_[i] += 2 * overlap * gap.inward;
        pressing_ += 4 * overlap * overlap;
        wall_overlap_ = std::max(wall_overlap_, overlap / margin_[i]);
        largest_ = std::min(largest_, gap.distance / r);
      });
    }
  }

  void move() {
    constexpr double longest = 0.35;  // the stiffest of a packing's oscillations takes 1.3
    double power = 0, v2 = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      power += dot(force_[i], speed_[i]);
      v2 += squared(speed_[i]);
    }
    if (power > 0) {
      const double turn = net_ > 0 ? turn_ * std::sqrt(v2 / net_) : 0.0;
      for (std::size_t i = 0; i < balls_.size(); ++i)
        speed_[i] = (1 - turn_) * speed_[i] + turn * force_[i];
      if (++downhill_ > 5) {
        step_ = std::min(1.1 * step_, longest);
        turn_ *= 0.99;
      }
    } else {
      std::ranges::fill(speed_, Vec3{});
      step_ = std::max(0.5 * step_, 0.02);
      turn_ = 0.1;
      downhill_ = 0;
    }
    double farthest = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      speed_[i] += step_ / mass_[i] * force_[i];
      Vec3 way = step_ * speed_[i];
      const double far = norm(way), most = 0.5 * smallest_;  // nobody jumps past anybody
      if (far > most) way = most / far * way;
      balls_[i].place = room_.home(balls_[i].place + way);
      farthest = std::max(farthest, squared(room_.between(listed_[i], balls_[i].place)));
    }
    if (farthest > 0.25 * skin_ * skin_) find_neighbours();
  }

  std::vector<Placed>& balls_;
  const geometry::AnyShape& shape_;
  const Room& room_;
  double gap_, smallest_ = 0, skin_ = 0;
  bool many_sizes_ = false;  // a grid for each would be searched in vain
  std::vector<std::pair<int, int>> pairs_;
  std::vector<Vec3> listed_, force_, speed_;  // where each was when pairs were listed
  std::vector<double> mass_, margin_;

  double pair_overlap_ = 0;  // largest, of the radii's sum
  double wall_overlap_ = 0;  // largest, of the margin
  double largest_ = 1, overlaps_ = 0;
  double pressing_ = 0, net_ = 0;  // sums of squares: forces of contacts, forces on balls
  std::int64_t contacts_ = 0;
  double step_ = 0.1, turn_ = 0.1;
  int downhill_ = 0;
};

}  // namespace

Pushed push_apart(std::vector<Placed>& balls, const geometry::AnyShape& shape, const Room& room,
                  double gap, std::int64_t most, const std::atomic<bool>* stop) {
  return Soft(balls, shape, room, gap).run(most, stop);
}

}  // namespace mahlwerk::cases

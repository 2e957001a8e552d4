// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/push_apart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/setup/position_sampler.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

/// Energy minimisation of soft spheres of unit stiffness by FIRE, the "fast inertial relaxation
/// engine" of Bitzek et al., Phys. Rev. Lett. 97, 170201 (2006), with a Verlet list.
class OverlapRelaxation {
 public:
  OverlapRelaxation(std::vector<PlacedBall>& balls, const geometry::AnyShape& shape,
                    const Domain& domain, double gap, const Obstacles* obstacles)
      : balls_(balls), shape_(shape), domain_(domain), gap_(gap), obstacles_(obstacles) {
    const auto [least, most] = std::ranges::minmax(balls, {}, &PlacedBall::radius);
    smallest_ = least.radius;
    std::ptrdiff_t sizes = 1;
    skin_ = 0.6 * smallest_;
    const std::size_t n = balls.size();
    force_.resize(n);
    velocity_.resize(n);
    for (const PlacedBall& b : balls) {
      mass_.push_back(b.radius * b.radius / (smallest_ * smallest_));
      margin_.push_back(wall_clearance(shape, b.radius, gap));
    }
    constexpr std::ptrdiff_t few = 4;
    for (std::size_t i = 1; i < n; ++i) sizes += balls[i].radius != balls[i - 1].radius ? 1 : 0;
    many_sizes_ = sizes > few;
    double mean = 0;
    for (const PlacedBall& b : balls) mean += b.radius / static_cast<double>(n);
    if (many_sizes_) skin_ = 0.6 * mean;
    find_neighbours();
  }

  PushApartResult run(std::int64_t most, const std::atomic<bool>* stop) {
    constexpr double at_rest = 1e-3;  // net force over contact force
    PushApartResult end;
    for (;;) {
      if (stop != nullptr && *stop) throw Interrupted();
      compute_forces();
      end.moves += static_cast<std::int64_t>(balls_.size());
      end.free = pair_overlap_ <= 0.5 * gap_ && wall_overlap_ <= 0.5;
      if (end.free || net_force2_ <= at_rest * at_rest * contact_force2_ || end.moves > most) break;
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
  const PlacedBall& at(int i) const { return balls_[static_cast<std::size_t>(i)]; }

  /// Rebuilds the Verlet list: all pairs that may overlap before a ball has moved by half the skin.
  void find_neighbours() {
    pairs_.clear();
    std::vector<Grid> grids;  // one for each size, or for each range of sizes down to half
    for (std::size_t from = 0, to = 0; from < balls_.size(); from = to) {
      const double radius = balls_[from].radius, least = many_sizes_ ? 0.5 * radius : radius;
      for (to = from; to < balls_.size() && balls_[to].radius >= least;) ++to;
      const double reach = 2 * radius * (1 + gap_) + skin_;
      Grid& own = grids.emplace_back(domain_, reach, to - from);
      for (std::size_t i = from; i < to; ++i) {
        for (const Grid& grid : grids) add_pairs(grid, static_cast<int>(i));
        own.add(static_cast<int>(i), balls_[i].position);
      }
    }
    listed_positions_.clear();
    for (const PlacedBall& b : balls_) listed_positions_.push_back(b.position);
  }
  void add_pairs(const Grid& grid, int i) {
    grid.for_each_near(at(i).position, [&](int j) {
      const double reach = (at(i).radius + at(j).radius) * (1 + gap_) + skin_;
      if (squared(domain_.minimum_image(at(i).position, at(j).position)) < reach * reach)
        pairs_.emplace_back(i, j);
      return true;
    });
  }

  /// Computes the forces and the measures of overlap.
  void compute_forces() {
    pair_overlap_ = wall_overlap_ = contact_force2_ = net_force2_ = overlaps_ = 0;
    contacts_ = 0;
    largest_ = 1;
    std::ranges::fill(force_, Vec3{});
    for (const auto& pair : pairs_) add_pair_force(pair);
    std::visit([&](const auto& shape) { add_wall_forces(shape); }, shape_);
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (balls_[i].fixed) force_[i] = {};
      net_force2_ += squared(force_[i]);
    }
  }
  void add_pair_force(std::pair<int, int> pair) {
    const Vec3 apart = domain_.minimum_image(at(pair.first).position, at(pair.second).position);
    const double sum = radii(pair), wanted = sum * (1 + gap_), d2 = squared(apart);
    if (d2 >= wanted * wanted || (at(pair.first).fixed && at(pair.second).fixed)) return;
    const double d = std::sqrt(d2), overlap = wanted - d;
    const Vec3 push = d > 0 ? overlap / d * apart : Vec3{0, 0, overlap};
    force_[static_cast<std::size_t>(pair.first)] -= push;
    force_[static_cast<std::size_t>(pair.second)] += push;
    contact_force2_ += overlap * overlap;
    overlaps_ += overlap / sum;
    ++contacts_;
    pair_overlap_ = std::max(pair_overlap_, overlap / sum);
    largest_ = std::min(largest_, d / sum);
  }
  template <class S>
  void add_wall_forces(const S& shape) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (balls_[i].fixed) continue;
      const double r = balls_[i].radius, wanted = r + margin_[i];
      const auto push = [&](const geometry::Gap& gap) {
        const double overlap = wanted - gap.distance;
        if (!(overlap > 0)) return;
        force_[i] += 2 * overlap * gap.inward;
        contact_force2_ += 4 * overlap * overlap;
        wall_overlap_ = std::max(wall_overlap_, overlap / margin_[i]);
        largest_ = std::min(largest_, gap.distance / r);
      };
      geometry::for_each_near_face(shape, balls_[i].position, r, wanted,
                                   [&](int, const geometry::Gap& gap) { push(gap); });
      if (obstacles_ != nullptr) obstacles_->near(balls_[i].position, r, wanted, push);
    }
  }

  void move() {
    constexpr double longest = 0.35;  // the fastest oscillation of a packing has a period of 1.3
    double power = 0, v2 = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      power += dot(force_[i], velocity_[i]);
      v2 += squared(velocity_[i]);
    }
    if (power > 0) {
      const double mixed_force = net_force2_ > 0 ? mixing_ * std::sqrt(v2 / net_force2_) : 0.0;
      for (std::size_t i = 0; i < balls_.size(); ++i)
        velocity_[i] = (1 - mixing_) * velocity_[i] + mixed_force * force_[i];
      if (++downhill_steps_ > 5) {
        step_ = std::min(1.1 * step_, longest);
        mixing_ *= 0.99;
      }
    } else {
      std::ranges::fill(velocity_, Vec3{});
      step_ = std::max(0.5 * step_, 0.02);
      mixing_ = 0.1;
      downhill_steps_ = 0;
    }
    double farthest = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      velocity_[i] += step_ / mass_[i] * force_[i];
      Vec3 way = step_ * velocity_[i];
      const double far = norm(way), most = 0.5 * smallest_;  // no ball jumps past another
      if (far > most) way = most / far * way;
      balls_[i].position = domain_.wrap(balls_[i].position + way);
      farthest = std::max(farthest,
                          squared(domain_.minimum_image(listed_positions_[i], balls_[i].position)));
    }
    if (farthest > 0.25 * skin_ * skin_) find_neighbours();
  }

  std::vector<PlacedBall>& balls_;
  const geometry::AnyShape& shape_;
  const Domain& domain_;
  double gap_, smallest_ = 0, skin_ = 0;
  const Obstacles* obstacles_;  // null: none
  bool many_sizes_ = false;     // a grid for each size would be mostly empty
  std::vector<std::pair<int, int>> pairs_;
  std::vector<Vec3> listed_positions_, force_, velocity_;  // positions when pairs_ was built
  std::vector<double> mass_, margin_;

  double pair_overlap_ = 0;  // largest, over the sum of radii
  double wall_overlap_ = 0;  // largest, over the margin
  double largest_ = 1, overlaps_ = 0;
  double contact_force2_ = 0,
         net_force2_ = 0;  // sums of squares of contact forces and of net forces on balls
  std::int64_t contacts_ = 0;
  double step_ = 0.1, mixing_ = 0.1;
  int downhill_steps_ = 0;
};

}  // namespace

PushApartResult push_apart(std::vector<PlacedBall>& balls, const geometry::AnyShape& shape,
                           const Domain& domain, double gap, std::int64_t most,
                           const std::atomic<bool>* stop, const Obstacles* obstacles) {
  return OverlapRelaxation(balls, shape, domain, gap, obstacles).run(most, stop);
}

}  // namespace mahlwerk::cases

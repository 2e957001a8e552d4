// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/setup/position_sampler.hpp"
#include "mahlwerk/cases/setup/push_apart.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::size_t large = 10000;  // balls; larger charges gain from sorting in memory
constexpr double min_gap = 1e-3;      // between balls placed one by one, over the sum of radii

/// Balls of one size of one set.
struct Portion {
  std::size_t set = 0;
  double ball = 0;      // [m] diameter of a ball
  double diameter = 0;  // [m] of the room that it takes: of a body, in any orientation
  std::size_t count = 0;
  std::size_t from = 0;  // index of its first ball in placed_
};

std::vector<Portion> portions(const std::vector<BallSet>& sets) {
  std::vector<Portion> found;
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const SizeClass& size : sets[i].sizes())
      found.push_back({i, size.diameter, sets[i].reach() * size.diameter,
                       static_cast<std::size_t>(size.count)});
  return found;
}

/// Horizontal layers of the jar, one for each set.
class Layers {
 public:
  /// Layers without `up` are the whole jar. The shares of the jar's volume are those of the balls'
  /// volumes, by random points of the jar.
  Layers(const geometry::AnyShape& shape, const std::vector<BallSet>& sets, const Vec3* up,
         const Obstacles* obstacles)
      : up_(up), top_(sets.size(), INFINITY) {
    if (up == nullptr) return;
    constexpr std::size_t points = 20'000;  // heights to within a percent of the jar
    Random random(1, 0);
    const PositionSampler sampler(shape, 0.5 * largest_ball(sets), obstacles);
    std::vector<double> heights(points);
    for (double& h : heights) h = dot(sampler.draw(random), *up);
    std::ranges::sort(heights);
    double all = 0, below = 0;
    for (const BallSet& set : sets) all += static_cast<double>(set.count) * ball_volume(set);
    for (std::size_t i = 0; i + 1 < sets.size(); ++i) {
      below += static_cast<double>(sets[i].count) * ball_volume(sets[i]);
      const double rank = below / all * static_cast<double>(points - 1);
      top_[i] = heights[static_cast<std::size_t>(rank)];
    }
  }

  /// A random position in the layer of a set; anywhere if the layer is too thin to be found.
  Vec3 draw(const PositionSampler& sampler, std::size_t set, Random& random) const {
    Vec3 p = sampler.draw(random);
    for (int tries = 100'000; up_ != nullptr && !holds(set, p) && tries > 0; --tries)
      p = sampler.draw(random);
    return p;
  }

 private:
  bool holds(std::size_t set, const Vec3& p) const {
    const double height = dot(p, *up_);
    return height <= top_[set] && (set == 0 || height > top_[set - 1]);
  }

  const Vec3* up_;
  std::vector<double> top_;  // [m] upper end of each set's layer
};

/// Places a charge, largest balls first: by random sequential addition, else by pushing apart.
class ChargeFiller {
 public:
  ChargeFiller(const geometry::AnyShape& shape, const std::vector<BallSet>& sets, Random& random,
               const std::atomic<bool>* stop, const Vec3* up, const Obstacles* obstacles)
      : shape_(shape),
        obstacles_(obstacles),
        sets_(sets),
        random_(random),
        stop_(stop),
        layers_(shape, sets, up, obstacles),
        portions_(portions(sets)) {
    order_.resize(portions_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, std::greater(), [&](auto i) { return portions_[i].diameter; });
    for (const std::size_t i : order_) {
      portions_[i].from = count_;
      count_ += portions_[i].count;
    }
    domain_.periods = geometry::periods(shape);
    for (const std::size_t i : order_) {
      const Vec3& box = samplers_.emplace_back(shape, 0.5 * portions_[i].diameter, obstacles).box();
      domain_.half = {std::max(domain_.half.x, box.x), std::max(domain_.half.y, box.y),
                      std::max(domain_.half.z, box.z)};
    }
  }

  void place() {
    if (place_one_by_one()) return;
    dense_ = true;
    if (infeasible()) throw too_many_balls();
    const int starts = count_ <= 1000 ? 20 : count_ <= 10000 ? 2 : 1;  // large charges vary little
    // 2e4 moves a ball: of 120 charges of 46 to 57 % no feasible one needed more, one above 1e4.
    const std::int64_t moves = sweeps(3000, std::min(4e8, 2e4 * static_cast<double>(count_)));
    moves_left_ = moves;
    for (int start = 0; start < starts && moves_left_ > 0; ++start) {
      if (start > 0) place_one_by_one();
      if (count_ > large) sort_along_curve();
      for (const double smaller : {min_gap, 0.1 * min_gap, 1e-3 * min_gap})
        if (try_push_apart(smaller)) return;
    }
    moves_left_ = moves;
    if (obstacles_ != nullptr && place_wedged_anew()) return;
    throw too_many_balls();
  }

  /// By set, in the order of the case.
  std::vector<scene::Ball> balls() const {
    std::vector<scene::Ball> all;
    all.reserve(count_);
    for (const Portion& portion : portions_) {
      const BallSet& set = sets_[portion.set];
      const double inertia_ratio = set.inertia_ratio(portion.ball);
      for (std::size_t n = 0; n < portion.count; ++n)
        all.push_back({.radius = 0.5 * portion.ball,
                       .density = set.layers().mean_density(0.5 * portion.ball),
                       .position = placed_[portion.from + n].position,
                       .velocity = {},
                       .spin = {},
                       .kind = static_cast<std::int32_t>(portion.set),
                       .inertia_ratio = inertia_ratio});
    }
    return all;
  }

 private:
  /// Random sequential addition: puts each ball at a random position free of the earlier balls.
  /// False if some found no free position; these balls are left overlapping.
  bool place_one_by_one() {
    placed_.assign(count_, {});
    std::vector<Grid> grids;
    place_given(grids);
    std::size_t crowded = 0;
    double widest = 0;  // [m] largest ball of the last grid, for sizes down to half of it
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const Portion& portion = portions_[order_[k]];
      if (!sets_[portion.set].positions.empty()) continue;
      if (widest == 0 || portion.diameter <= 0.5 * widest) {
        widest = portion.diameter;
        grids.emplace_back(domain_, widest * (1 + min_gap), count_of_similar_size(k));
      }
      crowded = place(portion, samplers_[k], grids, crowded);
    }
    return crowded == 0;
  }
  /// Places the balls of one size; adds the number of balls without a free position to `crowded`.
  std::size_t place(const Portion& portion, const PositionSampler& sampler,
                    std::vector<Grid>& grids, std::size_t crowded) {
    const double radius = 0.5 * portion.diameter;
    for (std::size_t next = portion.from; next < portion.from + portion.count; ++next) {
      if (stop_ != nullptr && *stop_) throw Interrupted();
      Vec3 p = layers_.draw(sampler, portion.set, random_);
      bool found = free(p, radius, grids);
      for (int tries = tries_left(crowded); !found && tries > 0; --tries) {
        p = layers_.draw(sampler, portion.set, random_);
        found = free(p, radius, grids);
      }
      crowded += found ? 0 : 1;
      grids.back().add(static_cast<int>(next), p);
      placed_[next] = {p, radius};
    }
    return crowded;
  }
  /// Number of balls, from `k` in the order on, that are wider than half those at `k`.
  std::size_t count_of_similar_size(std::size_t k) const {
    std::size_t many = 0;
    const double half = 0.5 * portions_[order_[k]].diameter;
    for (; k < order_.size() && portions_[order_[k]].diameter > half; ++k)
      many += portions_[order_[k]].count;
    return many;
  }
  /// Places the balls with given positions, without a check for overlaps.
  void place_given(std::vector<Grid>& grids) {
    std::size_t given = 0;
    for (const BallSet& set : sets_) given += set.positions.size();
    if (given == 0) return;
    Grid& grid = grids.emplace_back(domain_, largest_ball(sets_) * (1 + min_gap), given);
    for (const Portion& portion : portions_) {
      std::size_t next = portion.from;
      for (const Vec3& p : sets_[portion.set].positions) {
        grid.add(static_cast<int>(next), p);
        placed_[next++] = {p, 0.5 * portion.diameter, true};
      }
    }
  }
  /// Number of random positions to try for a ball: many for few balls; few once the charge must be
  /// pushed apart in any case.
  int tries_left(std::size_t crowded) const {
    if (crowded > 0 || dense_) return 20;
    return static_cast<int>(std::clamp(2e7 / static_cast<double>(count_), 200.0, 1e5));
  }
  bool free(const Vec3& p, double radius, const std::vector<Grid>& grids) const {
    return std::ranges::all_of(grids, [&](const Grid& grid) {
      return grid.for_each_near(p, [&](int i) {
        const PlacedBall& o = placed_[static_cast<std::size_t>(i)];
        return norm(domain_.minimum_image(p, o.position)) >= (1 + min_gap) * (radius + o.radius);
      });
    });
  }

  /// Sorts the balls of each size along a space-filling curve (Z-order), so that neighbours in
  /// space are near in memory. Balls of one size without given positions are interchangeable.
  void sort_along_curve() {
    for (const Portion& portion : portions_) {
      if (!sets_[portion.set].positions.empty()) continue;
      const auto first = placed_.begin() + static_cast<std::ptrdiff_t>(portion.from);
      std::vector<std::pair<std::uint64_t, PlacedBall>> keyed;
      keyed.reserve(portion.count);
      for (std::size_t n = 0; n < portion.count; ++n)
        keyed.emplace_back(domain_.z_order_index(first[static_cast<std::ptrdiff_t>(n)].position),
                           first[static_cast<std::ptrdiff_t>(n)]);
      std::ranges::stable_sort(keyed, {}, [](const auto& one) { return one.first; });
      std::ranges::transform(keyed, first, [](const auto& one) { return one.second; });
    }
  }

  bool try_push_apart(double smaller) {
    if (moves_left_ <= 0) return false;
    const std::int64_t enough = sweeps(10'000, 0);  // converging charges need far fewer
    const PushApartResult end = push_apart(placed_, shape_, domain_, smaller,
                                           std::min(moves_left_, enough), stop_, obstacles_);
    moves_left_ -= end.moves;
    largest_ = std::max(largest_, end.largest);
    typical_ = std::max(typical_, end.typical);
    return end.free;
  }
  /// Balls that others have pushed into a gap narrower than they are, between a part and the wall
  /// or another part, stay there: nothing pushes them out. They get new places, until all are free.
  bool place_wedged_anew() {
    constexpr double gap = 1e-3 * min_gap;  // the last of place()
    while (!try_push_apart(gap)) {
      bool found = false;
      for (std::size_t k = 0; k < order_.size(); ++k) {
        const Portion& portion = portions_[order_[k]];
        for (std::size_t i = portion.from; i < portion.from + portion.count; ++i) {
          const PlacedBall& ball = placed_[i];
          if (ball.fixed || clearance(ball) >= ball.radius) continue;
          placed_[i].position = samplers_[k].draw(random_);
          found = true;
        }
      }
      if (!found || moves_left_ <= 0) return false;
    }
    return true;
  }
  /// [m] Of a ball's centre, to the wall and to parts.
  double clearance(const PlacedBall& ball) const {
    return std::min(geometry::nearest_wall(shape_, ball.position, ball.radius),
                    obstacles_->clearance(ball.position, ball.radius));
  }

  /// Bound on the work in moves of single balls: `moves`, but at least `least` sweeps over all
  /// balls.
  std::int64_t sweeps(double least, double moves) const {
    return static_cast<std::int64_t>(std::max(least * static_cast<double>(count_), moves));
  }

  double filling() const {
    double volume = 0;
    for (const BallSet& set : sets_) volume += static_cast<double>(set.count) * ball_volume(set);
    return volume / geometry::volume(shape_);
  }
  /// Whether many balls of nearly one size are denser than any random packing: pushing apart cannot
  /// succeed.
  bool infeasible() {
    constexpr double soon_reached = 0.59, never_reached = 0.68;
    const bool alike = portions_[order_.front()].diameter < 1.5 * portions_[order_.back()].diameter;
    if (count_ <= large || !alike || filling() < never_reached) return false;
    sort_along_curve();
    typical_ = math::cbrt(soon_reached / filling());
    return true;
  }

  /// The error for a charge that does not fit, with the filling that was reached.
  InputError too_many_balls() {
    double size = largest_;
    double hope = 0.995 * std::min(typical_, 1.0);
    for (int tries = 8; tries > 0 && hope > size; --tries, hope *= 0.985)
      if (fits(hope)) size = hope;
    return InputError(Fault{
        "balls",
        fmt::format("{} balls that fill {:.1f} % of the jar cannot be placed at random: {:.1f} % "
                    "was reached",
                    count_, 100 * filling(), 100 * filling() * size * size * size),
        "give fewer or smaller balls or a larger jar", "too-many-balls"});
  }
  /// Whether the balls, with radii scaled by `size`, can be pushed apart.
  bool fits(double size) {
    std::vector<PlacedBall> smaller = placed_;
    for (PlacedBall& b : smaller) b.radius *= size;
    return push_apart(smaller, shape_, domain_, 1e-6,
                      sweeps(300, std::min(5e7, 1.5e3 * static_cast<double>(count_))), stop_,
                      obstacles_)
        .free;
  }

  const geometry::AnyShape& shape_;
  const Obstacles* obstacles_;
  const std::vector<BallSet>& sets_;
  Random& random_;
  const std::atomic<bool>* stop_;
  Layers layers_;
  std::vector<Portion> portions_;   // in the order of the case
  std::vector<std::size_t> order_;  // of portions, largest balls first
  std::size_t count_ = 0;
  Domain domain_;
  std::vector<PositionSampler> samplers_;  // for each portion, in the order of order_
  std::vector<PlacedBall> placed_;
  bool dense_ = false;           // random sequential addition has failed
  std::int64_t moves_left_ = 0;  // remaining moves of single balls
  double largest_ = 0, typical_ = 0;
};

}  // namespace

std::vector<scene::Ball> fill(const geometry::AnyShape& shape, const std::vector<BallSet>& sets,
                              Random& random, const std::atomic<bool>* stop, const Vec3* up,
                              const Obstacles* obstacles) {
  ChargeFiller filler(shape, sets, random, stop, up, obstacles);
  filler.place();
  return filler.balls();
}

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The event engine with neighbour lists, in a dense elastic fluid, against an engine that tests all
// pairs before every collision.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mahlwerk/event/collision_prediction.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::dense_fluid_test {
namespace {

/// Equal smooth elastic spheres in a periodic box. No cells, no lists, no event queue.
class AllPairs {
 public:
  struct Collision {
    double time;
    int ball, other;
  };

  AllPairs(std::vector<scene::Ball> balls, double side)
      : balls_(std::move(balls)), periods_{side, side, side} {}

  Collision next() {
    Collision first{std::numeric_limits<double>::infinity(), -1, -1};
    const int count = static_cast<int>(balls_.size());
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j)
        if (const double t = until_touch(ball(i), ball(j)); t < first.time) first = {t, i, j};
    for (scene::Ball& b : balls_)
      b.position = event::nearest_image(b.position + first.time * b.velocity, periods_);
    now_ += first.time;
    scene::Ball &a = ball(first.ball), &b = ball(first.other);
    const Vec3 r = event::nearest_image(b.position - a.position, periods_), n = r / norm(r);
    const Vec3 exchanged = dot(a.velocity - b.velocity, n) * n;
    a.velocity -= exchanged;
    b.velocity += exchanged;
    return {now_, first.ball, first.other};
  }

 private:
  scene::Ball& ball(int i) { return balls_[static_cast<std::size_t>(i)]; }
  double until_touch(const scene::Ball& a, const scene::Ball& b) const {
    const Vec3 r = event::nearest_image(b.position - a.position, periods_),
               u = b.velocity - a.velocity;
    const double way = dot(r, u), reach = a.radius + b.radius, c = squared(r) - reach * reach;
    const double d = way * way - squared(u) * c;
    if (way >= 0 || d <= 0) return std::numeric_limits<double>::infinity();
    return std::max(0.0, c / (std::sqrt(d) - way));
  }

  std::vector<scene::Ball> balls_;
  Vec3 periods_;
  double now_ = 0;
};

TEST(NeighbourLists, of_a_dense_fluid_miss_no_collision_that_a_test_of_all_pairs_finds) {
  constexpr int n = 8, wanted = 2000;
  constexpr double packing = 0.46;  // lists, not cells
  const double side = side_of(n, packing);
  const std::vector<scene::Ball> balls = lattice(n, packing);
  AllPairs plain(balls, side);
  const auto engine = gas(balls, side, {1, 1, INFINITY});
  Recorder seen;
  for (double t = 0.01; std::ssize(seen.all) < wanted; t += 0.01) engine->advance(t, seen);
  double worst = 0;
  for (std::size_t k = 0; k < wanted; ++k) {
    const AllPairs::Collision expected = plain.next();
    ASSERT_EQ(seen.all[k].ball, expected.ball) << "collision " << k << " at " << expected.time;
    ASSERT_EQ(seen.all[k].other, expected.other) << "collision " << k << " at " << expected.time;
    worst = std::max(worst, std::abs(seen.all[k].time - expected.time));
  }
  stays_below("difference of times [s] over 2000 collisions of 512 balls", worst, 1e-10,
              "rounding of 1e-16, some tenfold at each of a ball's eight collisions");
}

}  // namespace
}  // namespace mahlwerk::tests::dense_fluid_test

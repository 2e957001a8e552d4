// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The forces that the soft engine reports are those that move its balls, in the solvers for few and
// for many balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::forces_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr std::size_t as_few = 32, as_crowd = 0;  // soft::Settings::few_ball_limit

std::string arranged(std::size_t balls, std::size_t few) {
  return std::to_string(balls) + (balls > few ? " as a crowd: " : " as few: ");
}

std::unique_ptr<scene::Engine> engine_of(const scene::Chamber& mill,
                                         const std::vector<scene::Ball>& balls, double step,
                                         std::size_t few, bool hop = true) {
  const int faces = geometry::faces(*mill.shape);
  soft::Settings rules{of_law(HertzMindlin{}, Rolling::cdt), step, hop};
  rules.few_ball_limit = few;
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.3, 0.4);
  pair.rolling_friction = 0.02;
  return soft::make_engine(mill, balls, rules, contact::PairTable(1, faces, pair), 0);
}

/// A ball falls from a tenth of its radius. After 0.3 s, some hundred oscillations on its contact,
/// each of which leaves less than half, it is at rest to rounding. The error of the force is then
/// that of rounding the fall velocity, over half a step.
void feels_its_weight(std::size_t count, std::size_t few) {
  const double side = 0.1, radius = 0.003, step = 5e-6;
  std::vector<scene::Ball> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = -0.04 + 0.01 * static_cast<double>(i % 8);
    const double y = -0.04 + 0.01 * static_cast<double>(i / 8);
    balls.push_back({radius, 7850, {x, y, -0.5 * side + 1.1 * radius}, {}, {}});
  }
  const auto engine = engine_of(still_box(side, {0, 0, -gravity}), balls, step, few);
  Recorder none;
  engine->advance(0.3, none);
  const std::vector<Vec3> forces = engine->forces();
  ASSERT_EQ(forces.size(), count);
  const double weight = balls[0].mass() * gravity, fallen = std::sqrt(0.2 * radius * gravity);
  double worst = 0;
  for (const Vec3& f : forces) worst = max_or_nan(worst, norm(f - Vec3{0, 0, weight}));
  states(arranged(count, few) + "force on the first ball [N]", forces[0].z, weight,
         balls[0].mass() * fallen * rounding / (0.5 * step), "m g");
  stays_below(arranged(count, few) + "farthest of all from their weight [N]", worst,
              balls[0].mass() * fallen * rounding / (0.5 * step), "m g");
}

TEST(Forces, a_ball_at_rest_on_the_floor_feels_its_weight) {
  feels_its_weight(1, as_few);
  feels_its_weight(1, as_crowd);
  feels_its_weight(40, as_few);  // more than 32: ManyBodySolver
}

/// (dem.26) is m (v' - v) = (F + F') dt/2 + m (b + b') dt/2, to the rounding of the sums.
TEST(Forces, change_the_momentum_of_every_ball_by_their_mean_over_a_step) {
  const scene::Chamber mill{geometry::Capsule{0.03, 0.02}, shaken(20, 0.015), {}, {0, 0, -gravity}};
  const auto motion = shaken(20, 0.015);
  const double step = 2e-6;
  for (const auto& [count, few] : {std::pair{5, as_few}, {5, as_crowd}, {40, as_few}}) {
    Random random(3, 0);
    std::vector<scene::Ball> balls;
    for (int i = 0; i < count; ++i)
      balls.push_back({0.002,
                       7850,
                       {0.005 * (i % 4 - 1.5), 0.005 * (i / 4 % 4 - 1.5), 0.005 * (i / 16 - 1.0)},
                       random.direction(),
                       30 * random.direction()});
    const auto engine = engine_of(mill, balls, step, few, false);  // no free-flight skips
    const auto body = [&](std::int64_t n) {
      return mill.gravity - motion.frame_motion(static_cast<double>(n) * step).acceleration;
    };
    const double mass = balls[0].mass();
    Recorder none;
    double worst = 0, most = 0, fastest = 0;
    for (std::int64_t n = 0; n < 20000; ++n) {
      const bool looked = n % 7 == 0;
      std::vector<scene::Ball> before;
      std::vector<Vec3> first;
      if (looked) before = engine->balls(), first = engine->forces();
      engine->advance(static_cast<double>(n + 1) * step, none);
      if (!looked) continue;
      const std::vector<scene::Ball> after = engine->balls();
      const std::vector<Vec3> second = engine->forces();
      for (std::size_t b = 0; b < before.size(); ++b) {
        const Vec3 gained = mass * (after[b].velocity - before[b].velocity);
        const Vec3 given = 0.5 * step * (first[b] + second[b] + mass * (body(n) + body(n + 1)));
        worst = max_or_nan(worst, norm(gained - given));
        most = max_or_nan(most, norm(first[b]));
        fastest = max_or_nan(fastest, norm(after[b].velocity));
      }
    }
    EXPECT_GT(most, 10 * mass * gravity) << "nothing touched";
    // A dozen vector additions, each with the rounding error of the speed.
    stays_below(arranged(balls.size(), few) + "momentum unaccounted for [N s]", worst,
                12 * std::sqrt(3) * rounding * mass * fastest, "dem.26");
  }
}

TEST(Forces, of_a_colliding_pair_are_opposite) {
  for (const std::size_t few : {as_few, as_crowd}) {
    const double step = 2e-6;
    const std::vector<scene::Ball> balls{{0.003, 7850, {-0.0031, 0, 0}, {1, 0.2, 0}, {0, 40, 9}},
                                         {0.004, 7850, {0.0041, 0.001, 0}, {}, {}}};
    const auto engine = engine_of(still_box(0.1), balls, step, few);
    Recorder none;
    double most = 0, worst = 0;
    for (int n = 1; n < 1000; ++n) {
      engine->advance(n * step, none);
      const std::vector<Vec3> f = engine->forces();
      most = max_or_nan(most, norm(f[0]));
      worst = max_or_nan(worst, norm(f[0] + f[1]));
    }
    ASSERT_EQ(none.all.size(), 1U);
    EXPECT_GT(most, 1);
    if (few == as_few) {
      EXPECT_EQ(engine->forces()[0], Vec3{}) << "in free flight";
    }
    // ManyBodySolver computes forces from differences of velocities of 1 m/s.
    stays_below(arranged(2, few) + "sum of both forces [N]", worst,
                few == as_crowd ? 8 * balls[1].mass() * rounding / (0.5 * step) : 0,
                "Newton's third law");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::forces_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every rolling-resistance rule has the properties in its row of contact/rolling.hpp, and those of
// any force between two bodies.
#include "mahlwerk/contact/rolling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::rolling_test {
namespace {

constexpr int tries = 40;
/// A collision takes about 100 steps with about ten roundings of 1.1e-16 each, in quantities up to
/// ten times those that they are compared with.
constexpr double roundings = 100 * 10 * 1.1e-16 * 10;

/// Two balls that collide obliquely while they spin, under one rule. Without damping and friction
/// only rolling resistance can change their energy.
Impact collision(contact::Rolling rule, Random& random, bool conservative = false) {
  std::vector<scene::Ball> both(2);
  for (scene::Ball& ball : both) {
    ball.radius = random.uniform(1e-3, 1e-2);
    ball.density = random.uniform(2000, 8000);
    ball.spin = random.uniform(10, 500) * random.direction();
  }
  both[0].velocity = {random.uniform(0.2, 3), random.uniform(-1, 1), random.uniform(-1, 1)};
  contact::Pair pair = pair_of({1e9, 0.3}, {1e9, 0.3}, conservative ? 1 : random.uniform(0.2, 0.9),
                               conservative ? 0 : 0.4);
  pair.rolling_friction = random.uniform(0.01, 0.2);
  const Impact found = impact(both, pair, of_law(contact::HertzMindlin{}, rule), 0.01);
  EXPECT_EQ(found.energy_balance.collisions, 1);
  return found;
}

Vec3 momentum(const std::vector<scene::Ball>& balls) {
  Vec3 sum;
  for (const scene::Ball& b : balls) sum += b.mass() * b.velocity;
  return sum;
}
Vec3 angular_momentum(const std::vector<scene::Ball>& balls) {
  Vec3 sum;
  for (const scene::Ball& b : balls)
    sum += b.mass() * (cross(b.position, b.velocity) + 0.4 * b.radius * b.radius * b.spin);
  return sum;
}
double energy(const std::vector<scene::Ball>& balls) {
  double sum = 0;
  for (const scene::Ball& b : balls)
    sum += 0.5 * b.mass() * (squared(b.velocity) + 0.4 * b.radius * b.radius * squared(b.spin));
  return sum;
}

TEST(RollingRules, act_and_react) {
  for (const contact::RollingRule& rule : contact::rolling_rules) {
    Random random(5, 1);
    double way = 0, turn = 0;
    for (int i = 0; i < tries; ++i) {
      const Impact found = collision(rule.rule, random);
      const double all = found.before[0].mass() * norm(found.before[0].velocity);
      way = max_or_nan(way, norm(momentum(found.after) - momentum(found.before)) / all);
      const double arm = found.before[0].radius + found.before[1].radius;
      turn = max_or_nan(
          turn, norm(angular_momentum(found.after) - angular_momentum(found.before)) / (all * arm));
    }
    stays_below(std::string(rule.name) + ": momentum is kept, of its size", way, roundings,
                "Newton; roundings of the steps");
    if (rule.opposite)
      stays_below(std::string(rule.name) + ": angular momentum is kept, of its size", turn,
                  roundings, "torques of both bodies are opposite; roundings of the steps");
    else
      EXPECT_GT(turn, roundings) << rule.name << ": torques of both bodies are not opposite";
  }
}

/// Largest relative gain of energy in collisions where nothing but rolling resistance dissipates.
double largest_gain(contact::Rolling rule) {
  Random random(6, 1);
  double most = -INFINITY;
  for (int i = 0; i < tries; ++i) {
    const Impact found = collision(rule, random, true);
    most = max_or_nan(most, energy(found.after) / energy(found.before) - 1);
  }
  return most;
}

TEST(RollingRules, make_no_energy) {
  const double of_the_step = std::abs(largest_gain(contact::Rolling::none));
  for (const contact::RollingRule& rule : contact::rolling_rules)
    stays_below(std::string(rule.name) + ": gain of a collision, of its energy",
                largest_gain(rule.rule), of_the_step, "resistance only takes; error of the step");
}

TEST(RollingRules, take_energy_if_they_say_that_they_resist) {
  for (const contact::RollingRule& rule : contact::rolling_rules) {
    Random random(7, 1);
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i < tries; ++i) {
      const double lost = collision(rule.rule, random).energy_balance.lost_rolling;
      ASSERT_FALSE(std::isnan(lost)) << rule.name;
      least = std::min(least, lost), most = std::max(most, lost);
    }
    EXPECT_EQ(most > 0, rule.resists) << rule.name;
    EXPECT_GE(least, 0) << rule.name;
  }
}

}  // namespace
}  // namespace mahlwerk::tests::rolling_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A feed of balls that are outside at the start: they enter once, mixed, at their rate, and nothing
// is lost in number, mass and energy (flo.2, flo.3).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "statement.hpp"
#include "verification/soft/flowing.hpp"

namespace mahlwerk::tests::fresh_feed_test {
namespace {

using namespace flowing;

/// The grains of another hopper, all outside, in two kinds of half the number each.
std::vector<scene::Ball> fresh_feed(int count) {
  std::vector<scene::Ball> balls = grains(count, 0.001);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls[i].outside = true;
    balls[i].position = {};
    if (2 * i >= balls.size()) balls[i].radius *= 0.8;
  }
  return balls;
}

scene::Flow fresh_flow(double rate) {
  scene::Flow fresh = flow(Feed::rate);
  fresh.rate = rate;
  fresh.returns = false;
  return fresh;
}

TEST(FreshFeed, fills_an_empty_jar_and_keeps_number_mass_and_energy) {
  const scene::Chamber jar = hopper(0.016);
  const std::vector<scene::Ball> start = fresh_feed(400);
  const auto run = engine(jar, start, fresh_flow(1500));
  FlowObserver seen;
  double number = 0, mass = 0, energy = 0;
  for (int k = 1; k <= 100; ++k) {
    run->advance(0.003 * k, seen);
    const auto balls = run->balls();
    const auto inside =
        static_cast<double>(std::ranges::count(balls, false, &scene::Ball::outside));
    number = std::max(number, std::abs(inside - seen.count(true) + seen.count(false)));
    mass = max_or_nan(mass, std::abs(mass_of(balls, false) - seen.mass(true) + seen.mass(false)));
    energy = max_or_nan(energy, std::abs(run->energy_balance().residual()));
  }
  std::vector<std::int32_t> entered;
  for (const scene::Passage& p : seen.all)
    if (p.entered != 0) entered.push_back(p.ball);
  std::ranges::sort(entered);
  states("balls that entered", seen.count(true), 400, 0, "the whole feed, once");
  EXPECT_EQ(std::ranges::adjacent_find(entered), entered.end()) << "none entered twice";
  EXPECT_GT(seen.count(false), 50);
  states("balls that are missing", number, 0, 0, "inside + left - entered = 0 (flo.2)");
  stays_below("mass that is missing, relative", mass / mass_of(start, true), 1e-12,
              "rounding of the sums (flo.2)");
  stays_below("energy that is missing over the dissipated", energy / run->energy_balance().lost(),
              3 * error_without_flow(jar), "three times that without flow (flo.3)");
}

/// Balls that start from rest at one height and not at one time never meet in free fall: the jar
/// fills until as many leave as enter, each after the time of its fall.
TEST(FreshFeed, falls_through_an_empty_jar_in_the_time_of_free_fall) {
  scene::Chamber jar = hopper(0.016);
  jar.parts.clear();
  scene::Flow rain = fresh_flow(500);
  rain.inlet_size = {0.02, 0.02, 0};
  const auto run = engine(jar, fresh_feed(150), rain);
  FlowObserver seen;
  run->advance(0.25, seen);
  EXPECT_TRUE(seen.hits.empty());
  const double fall = std::sqrt(2 * (rain.inlet.z - rain.outlet.z) / gravity),
               between_moves = 64 * 1e-5;
  std::vector<double> entered(150, -1);
  double worst = 0, left = 0;
  for (const scene::Passage& p : seen.all) {
    double& since = entered[static_cast<std::size_t>(p.ball)];
    if (p.entered == 0) ++left, worst = max_or_nan(worst, std::abs(p.time - since - fall));
    since = p.time;
  }
  EXPECT_GT(left, 50);
  states("worst residence time less that of the fall [s]", worst, 0, between_moves,
         "balls are moved every 64th step");
  const auto balls = run->balls();
  const auto inside = static_cast<double>(std::ranges::count(balls, false, &scene::Ball::outside));
  states("steady holdup", inside, rain.rate * fall, 1 + rain.rate * between_moves,
         "rate times the time of the fall (flo.5)");
}

/// The first half of the feed has as many balls of each size as the second, but for chance.
TEST(FreshFeed, is_mixed) {
  const auto run = engine(hopper(0.016), fresh_feed(400), fresh_flow(1000));
  FlowObserver seen;
  run->advance(0.2, seen);
  double large = 0, all = 0;
  for (const scene::Passage& p : seen.all)
    if (p.entered != 0) ++all, large += p.ball < 200 ? 1 : 0;
  EXPECT_GT(all, 150);
  states("share of the large half", large / all, 0.5, 4 * 0.5 / std::sqrt(2 * all),
         "four standard deviations of drawing half of them without return");
}

TEST(FreshFeed, by_mass_enters_at_its_mass_rate) {
  scene::Flow by_mass = fresh_flow(1);
  by_mass.mass_rate = 0.008;
  const std::vector<scene::Ball> balls = fresh_feed(400);
  const auto run = engine(hopper(0.016), balls, by_mass);
  FlowObserver seen;
  run->advance(0.2, seen);
  states("mass that entered [kg]", seen.mass(true), by_mass.mass_rate * 0.2,
         balls.front().mass() + by_mass.mass_rate * 64e-5, "rate times time, within a ball");
}

TEST(FreshFeed, that_recirculates_enters_again) {
  scene::Flow circuit = fresh_flow(3000);
  circuit.returns = true;
  const auto run = engine(hopper(0.016), fresh_feed(200), circuit);
  FlowObserver seen;
  run->advance(0.3, seen);
  EXPECT_GT(seen.count(true), 220);
}

}  // namespace
}  // namespace mahlwerk::tests::fresh_feed_test

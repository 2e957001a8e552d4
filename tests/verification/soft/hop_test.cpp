// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Free-flight skips (hops), and the convergence of the soft engine to the event engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "crowd.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::hop_test {
namespace {

using contact::HertzMindlin;

struct Followed {
  std::vector<scene::Collision> seen;
  scene::EnergyBalance energy_balance;
};
Followed followed(const scene::Chamber& mill, const std::vector<scene::Ball>& balls,
                  const contact::Pair& pair, double step, double time, bool hop) {
  const auto engine = soft_engine(mill, balls, of_law(HertzMindlin{}), pair, step, hop);
  Recorder recorder;
  engine->advance(time, recorder);
  return {recorder.all, engine->energy_balance()};
}

/// Largest differences of the first collisions of two runs.
struct Difference {
  double time = 0, speed = 0;
};
Difference difference(const Followed& a, const Followed& b, std::size_t count) {
  Difference d;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(a.seen[i].ball, b.seen[i].ball) << i;
    EXPECT_EQ(a.seen[i].other, b.seen[i].other) << i;
    d.time = max_or_nan(d.time, std::abs(a.seen[i].time - b.seen[i].time));
    d.speed = max_or_nan(d.speed, std::abs(a.seen[i].approach - b.seen[i].approach));
  }
  return d;
}

/// A free-flight skip (hop) is exact. Steps follow a mill that oscillates with w and A to
/// A (w dt)^2. Each bounce amplifies this error. The amplification is measured with a start
/// displaced by the same amount.
void same_collisions(const std::string& what, const scene::Chamber& mill,
                     const std::vector<scene::Ball>& balls, double e, std::size_t count,
                     double least_ratio = 10) {
  const contact::Pair pair = pair_of({200e9, 0.3}, {200e9, 0.3}, e, 0.3);
  const contact::PairTable pairs(1, 6, pair);
  const double step = soft::time_steps(balls, HertzMindlin{}, pairs, 3).recommended(0.2, 50);
  const auto& motion = std::get<kinematics::Vibration>(*mill.motion);
  const double off = motion.amplitude * std::pow(2 * std::numbers::pi * motion.frequency * step, 2);
  const Followed hops = followed(mill, balls, pair, step, 0.2, true);
  const Followed steps = followed(mill, balls, pair, step, 0.2, false);
  ASSERT_GE(std::min(hops.seen.size(), steps.seen.size()), count);
  const Difference found = difference(hops, steps, count);
  Difference grown;  // of an error of either sign
  for (const double aside : {off, -off}) {
    std::vector<scene::Ball> nudged = balls;
    nudged[0].position.z += aside;
    const Followed other = followed(mill, nudged, pair, step, 0.2, true);
    ASSERT_GE(other.seen.size(), count);
    const Difference d = difference(hops, other, count);
    grown = {std::max(grown.time, d.time), std::max(grown.speed, d.speed)};
  }
  stays_below(what + ", times of touch [s]", found.time, 2 * step + 2 * grown.time,
              "two steps, or what its error grows to");
  stays_below(what + ", speeds of approach [m/s]", found.speed,
              2 * step * motion.bounds().acceleration.z + 2 * grown.speed,
              "two steps of the mill's acceleration, or what its error grows to");
  const double ratio = static_cast<double>(steps.energy_balance.time_steps) /
                       static_cast<double>(hops.energy_balance.time_steps);
  std::printf("    %-58s %lld steps with hops, %lld without: a ratio of %.0f\n", what.c_str(),
              static_cast<long long>(hops.energy_balance.time_steps),
              static_cast<long long>(steps.energy_balance.time_steps), ratio);
  EXPECT_GE(ratio, least_ratio);
}

scene::Chamber box_mill() {
  return {geometry::Box{0.03, 0.03, 0.04}, shaken(20, 0.015), {}, {0, 0, -gravity}};
}

TEST(Hops, one_ball_in_a_vibration_mill_collides_the_same) {
  same_collisions("one ball", box_mill(), {ball_a({0.001, 0.002, 0.003}, {0.3, 0.2, 0})}, 0.9, 8);
}
TEST(Hops, three_balls_in_a_vibration_mill_collide_the_same) {
  const std::vector<scene::Ball> balls{ball_a({-0.006, -0.004, -0.003}, {0.5, 0.2, 0.1}),
                                       ball_a({0.006, -0.004, 0.001}, {-0.4, 0.3, 0}),
                                       ball_a({0.001, 0.006, 0.004}, {0.1, -0.5, 0.2})};
  same_collisions("three balls", box_mill(), balls, 0.9, 10);
}

TEST(Hops, a_hundred_balls_in_a_vibration_mill_collide_the_same) {
  const scene::Chamber mill{geometry::Box{0.2, 0.2, 0.25}, shaken(20, 0.015), {}, {0, 0, -gravity}};
  same_collisions("a hundred balls", mill, lattice_of(100, 0.035, {0.003}), 0.9, 25, 3);
}

/// Smooth balls, e the same at all speeds: the engines differ only by the duration of contacts.
TEST(TowardsEvent, collisions_tend_to_the_event_engine_s_as_contacts_shorten) {
  const scene::Chamber mill = box_mill();
  const scene::Ball ball = ball_a({0.001, 0.002, 0.003}, {0.3, 0.2, 0});
  event::Rules rules;
  rules.bounce = {0.9, 1, 0};
  const auto sharp = event::one_ball(mill, ball, rules);
  Recorder expected;
  sharp->advance(0.3, expected);
  constexpr std::size_t count = 8;
  double first_time = 0, first_speed = 0, time = 0, speed = 0, first_contact = 0, contact = 0;
  for (const double modulus : {1e9, 1e10, 1e11, 1e12}) {
    const contact::Pair pair = pair_of({modulus, 0.3}, {modulus, 0.3}, 0.9, 0);
    contact = contact_time(of_law(HertzMindlin{}), touching(pair, ball), 2);
    const Followed soft = followed(mill, {ball}, pair, contact / 4000, 0.3, true);
    ASSERT_GE(soft.seen.size(), count);
    time = speed = 0;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(soft.seen[i].other, expected.all[i].other) << i;
      time = max_or_nan(time, std::abs(soft.seen[i].time - expected.all[i].time));
      speed = max_or_nan(speed, std::abs(soft.seen[i].approach - expected.all[i].approach));
    }
    std::printf("    E %.0e Pa, t_c %.3g s: times off by %.3g s, speeds by %.3g m/s\n", modulus,
                contact, time, speed);
    if (first_time == 0) first_time = time, first_speed = speed, first_contact = contact;
  }
  const double shorter = first_contact / contact;
  states("order of the times in t_c", std::log(first_time / time) / std::log(shorter), 1, 0.15,
         "a contact delays by a share of its time");
  states("order of the speeds in t_c", std::log(first_speed / speed) / std::log(shorter), 1, 0.15,
         "the mill moves on meanwhile");
  stays_below("times of 8 collisions at the stiffest, in t_c", time / contact, 8,
              "each contact delays by one t_c at most");
}

}  // namespace
}  // namespace mahlwerk::tests::hop_test

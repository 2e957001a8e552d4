// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bitwise reproducibility of the soft engine: a run gives the same bits if it is cut, or stopped
// and resumed. Faulty runs stop with an error.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "reproducible_runs.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::cuts_test {
namespace {

TEST(SoftCuts, do_not_change_a_run_by_a_bit) {
  constexpr double time = 0.08;
  for (const auto& [what, make] : runs()) {
    SCOPED_TRACE(what);
    const auto whole = make(0), pieces = make(0);
    Recorder in_one, in_many;
    whole->advance(time, in_one);
    EXPECT_GT(in_one.all.size(), 5U);
    Random random(3, 0);
    std::vector<double> cuts{time};
    for (int i = 0; i < 300; ++i) cuts.push_back(random.uniform(0, time));
    for (const scene::Collision& c : in_one.all)
      cuts.insert(cuts.end(), {c.time - 2e-6, c.time, c.time + 2e-6, c.time + c.duration});
    std::ranges::sort(cuts);
    for (const double cut : cuts)
      if (cut <= time) pieces->advance(cut, in_many);
    expect_same(in_one, in_many);
    expect_same(*whole, *pieces);
  }
}

TEST(SoftArchives, go_on_to_the_bit) {
  constexpr double time = 0.05;
  for (const auto& [what, make] : runs())
    for (const double when : {0.0, 1e-4, 0.0173, 0.031, 0.0444}) {
      SCOPED_TRACE(what + " at " + std::to_string(when));
      const auto whole = make(0), first = make(0), second = make(0);
      Recorder in_one, in_two;
      whole->advance(when, in_one);
      whole->advance(time, in_one);
      first->advance(when, in_two);
      copy_state(*first, *second);
      expect_same(*first, *second);
      second->advance(time, in_two);
      expect_same(in_one, in_two);
      expect_same(*whole, *second);
    }
}

TEST(SoftArchives, cut_short_or_too_long_are_refused) {
  const Make make = runs().front().second;
  const auto engine = make(0);
  Recorder none;
  engine->advance(0.02, none);
  Archive out;
  engine->serialize(out);
  for (std::size_t size = 0; size < out.bytes().size(); size += 1 + size / 20) {
    Archive in(out.bytes().substr(0, size));
    EXPECT_THROW(make(0)->serialize(in), RunError) << size;
  }
  Archive in(out.bytes() + "x");
  make(0)->serialize(in);
  EXPECT_THROW(in.finish(), RunError);
}

/// Number of steps from the first one in which a fault can occur to the error.
std::int64_t steps_until_error(scene::Engine& engine, double step, std::int64_t wrong_from) {
  Recorder none;
  try {
    engine.advance(1000 * step + static_cast<double>(wrong_from) * step, none);
  } catch (const RunError& e) {
    std::printf("    %s\n", e.what());
    return std::lround(engine.energy_balance().time / step) - wrong_from;
  }
  return 1000;
}

TEST(SoftFaults, a_step_far_too_long_stops_the_run_within_100_steps) {
  // Steps of twice the contact time or more: the ball passes through the contact at wrong
  // positions, or leaves the box. (With a step of one contact time a ball survives some bounces,
  // because the ends of a contact are integrated.)
  for (const double share : {2.0, 3.0, 5.0}) {
    const contact::Pair pair = soft_pair();
    scene::Ball ball = ball_a({}, {0.1, 0.2, -2});
    const double step = share * contact_time(of_law(HertzMindlin{}), touching(pair, ball), 2);
    const auto engine = soft_engine(still_box(0.1), {ball}, of_law(HertzMindlin{}), pair, step);
    const auto flight = static_cast<std::int64_t>(0.046 / 2 / step);
    EXPECT_LE(steps_until_error(*engine, step, flight), 100) << share;
  }
}

TEST(SoftFaults, a_force_that_is_no_number_stops_the_run_within_100_steps) {
  for (const bool hop : {false, true})
    for (const int count : {1, 12}) {
      std::vector<scene::Ball> balls = charge(count);
      balls[0].position.z = 0.004 - 0.05;
      balls[0].velocity = {0, 0, -1};
      contact::Pair pair = soft_pair();
      pair.modulus = NAN;
      const auto engine =
          soft_engine(still_box(0.1), balls, of_law(HertzMindlin{}), pair, 1e-5, hop);
      EXPECT_LE(steps_until_error(*engine, 1e-5, 0), 100 + 100) << count;  // 100 until touch
    }
}

/// Regression test of a run that once stopped with an error: the wall takes nearly all energy of a
/// ball, which is then at rest in the laboratory.
TEST(SoftFaults, a_ball_nearly_stopped_by_a_wall_is_none) {
  const scene::Chamber mill{
      geometry::Box{0.03, 0.03, 0.04}, shaken(20, 0.015), {}, {0, 0, -gravity}};
  const contact::Pair pair = pair_of({200e9, 0.3}, {200e9, 0.3}, 0.9, 0.3);
  const auto engine = soft_engine(mill, {ball_a({0.001, 0.002, 0.003}, {0.3, 0.2, 0})},
                                  of_law(HertzMindlin{}), pair, 3.9398e-7);
  Recorder none;
  EXPECT_NO_THROW(engine->advance(0.2, none));
}

/// The wall contact point of a wall that is near but cannot be touched yet is not computed. It once
/// kept the value of an earlier one, in the middle of the jar.
TEST(SoftFaults, a_ball_between_near_walls_touches_none) {
  const contact::Pair pair = pair_of({200e9, 0.3}, {200e9, 0.3}, 0.7, 0.3);
  const double radius = 0.01;
  for (const double gap : {1e-5, 1e-4, 2.9e-4})  // the skin is 3e-4
    for (const bool hop : {false, true}) {
      const double side = 2 * (radius + gap), step = 1e-6;
      const scene::Chamber box = still_box(side);
      const auto engine = soft_engine(box, {{radius, 7850, {}, {0.1, 0.07, 0.03}, {}}},
                                      of_law(HertzMindlin{}), pair, step, hop);
      Recorder seen;
      engine->advance(gap / 0.1 - 2 * step, seen);
      EXPECT_EQ(engine->energy_balance().lost(), 0);
      EXPECT_EQ(engine->energy_balance().contact_time, 0);
      engine->advance(0.05, seen);
      EXPECT_GT(seen.all.size(), 5U);
      for (const scene::Collision& c : seen.all) {
        const double most =
            std::max({std::abs(c.where.x), std::abs(c.where.y), std::abs(c.where.z)});
        EXPECT_NEAR(most, 0.5 * side, 1e-5) << "at a wall";
      }
    }
}

/// At the start of a shaken jar, balls at rest have no energy. The energy that the wall gives them
/// is not an energy jump.
TEST(SoftFaults, a_charge_at_rest_in_a_shaken_jar_is_none) {
  const scene::Chamber mill{
      geometry::Box{0.03, 0.03, 0.04}, shaken(20, 0.01), {}, {0, 0, -gravity}};
  std::vector<scene::Ball> balls = charge(18);
  for (scene::Ball& b : balls) b.velocity = b.spin = {};
  const auto engine = soft_engine(mill, balls, of_law(HertzMindlin{}), soft_pair(0.6), 2e-6, true);
  Recorder none;
  EXPECT_NO_THROW(engine->advance(0.1, none));
}

}  // namespace
}  // namespace mahlwerk::tests::cuts_test

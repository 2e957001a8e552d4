// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The event engine for many balls, compared with the engine for one ball and with conservation
// laws.
#include "many_balls.hpp"

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::many_balls_test {
namespace {

using namespace tests;

TEST(ManyBalls, one_of_them_goes_the_way_of_the_engine_for_one) {
  scene::Ball ball = ball_a({0.001, 0, 0.002}, {0.05, 0.02, 0.1}, {3, 2, 1});
  event::Rules rules = rules_a();
  rules.sustained_mode = event::SustainedContactMode::tc;
  const auto one = event::one_ball(mill_a(), ball, rules);
  const auto many = event::many_balls(mill_a(), {ball}, rules, {1, 1, rules.bounce});
  Recorder a, b;
  one->advance(0.5, a);
  many->advance(0.5, b);
  ASSERT_GE(a.all.size(), 20U);
  ASSERT_GE(b.all.size(), 20U);
  // The two engines find the same touch to the margin of 1e-12 R. Chaos multiplies the difference
  // by a few at each bounce.
  for (std::size_t i = 0; i < 6; ++i) {
    states("time of a collision [s]", b.all[i].time, a.all[i].time, 1e-11, "engine for one ball");
    states("its approach [m/s]", b.all[i].approach, a.all[i].approach, 1e-9, "engine for one ball");
  }
}

TEST(ManyBalls, elastic_gas_conserves_momentum_and_energy) {
  const double side = side_of(8, 0.2);
  const auto engine = gas(lattice(8, 0.2), side, {1, 1, INFINITY});
  const auto sum = [&] {
    Vec3 p{};
    for (const scene::Ball& b : engine->balls()) p += b.mass() * b.velocity;
    return p;
  };
  const Vec3 before = sum();
  const double energy = engine->energy_balance().kinetic;
  Counter counter;
  engine->advance(200, counter);
  stays_below("events without", -static_cast<double>(counter.count), -1e5, "enough to tell");
  stays_below("momentum gained", norm(sum() - before), 512 * 1e-13, "rounding of 1e5 collisions");
  states("energy", engine->energy_balance().kinetic / energy, 1, 1e-11,
         "rounding of 1e5 collisions");
  stays_below("deepest overlap over R", deepest_overlap(engine->balls(), side), 1e-12,
              "hard spheres");
  stays_below("deepest overlap at a collision", engine->energy_balance().deepest_overlap, 1e-12,
              "rounding of places");
}

TEST(ManyBalls, ball_that_collides_on_the_very_border_of_a_periodic_box_is_not_lost) {
  // One ball is hit while it is a hair outside of the cell in which it is still listed, and moves
  // on outwards. The ball that it meets there lies across the periodic boundary.
  constexpr double side = 10;
  const auto ball = [](double x, double speed) {
    return scene::Ball{0.5, 1, {x, 0.3, 0.3}, {speed, 0, 0}, {}};
  };
  for (const double hair : {1e-9, 3e-8, 9e-8, 2e-7}) {
    const auto run = gas({ball(-4.5, -1), ball(-5 - hair + 2.01, -1.01), ball(3.5 - hair, 0.0)},
                         side, {1, 1, INFINITY});
    Recorder seen;
    run->advance(40, seen);
    EXPECT_GE(seen.all.size(), 10U);
    stays_below("deepest overlap at a collision", run->energy_balance().deepest_overlap, 1e-12,
                "hard spheres");
  }
}

TEST(ManyBalls, few_balls_in_the_smallest_box_meet_their_nearest_images) {
  constexpr double side = 2.2;
  const auto run = gas({{0.5, 1, {0, 0, 0}, {1, 0.3, 0.2}, {}},
                        {0.5, 1, {1.05, 0, 0}, {-0.4, 0.7, 0}, {}},
                        {0.5, 1, {0, 1.05, 0.3}, {0, 0, -1}, {}},
                        {0.1, 1, {-0.7, -0.7, 0.7}, {0, 0, -3}, {}}},
                       side, {1, 1, INFINITY});
  const double energy = run->energy_balance().kinetic;
  Counter counter;
  for (int i = 1; i <= 400; ++i) {
    run->advance(2.0 * i, counter);
    ASSERT_LE(deepest_overlap(run->balls(), side), 1e-12);
  }
  EXPECT_GT(counter.count, 200);
  states("energy", run->energy_balance().kinetic / energy, 1, 1e-12, "elastic");
  EXPECT_THROW(gas({{0.5, 1, {}, {}, {}}}, 1.9, {1, 1, INFINITY}), InputError);
}

TEST(ManyBalls, wall_that_sweeps_up_a_ball_at_rest_does_not_pass_into_it) {
  // A ball at rest without gravity, 0.2 mm from a wall. The box turns about x, and the wall reaches
  // the ball.
  kinematics::Tumbling motion;
  motion.speed = 4e4;
  const scene::Chamber mill{geometry::Box{0.1, 0.04, 0.04}, motion, {}, {}};
  const scene::Ball ball{0.005, 7850, {0.01, 0.0148, 0.004}, {}, {}};
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  for (const bool alone : {true, false}) {
    rules.bounce = {0.5, 0, 0.3};
    const auto run = alone ? event::one_ball(mill, ball, rules)
                           : event::many_balls(mill, {ball}, rules, {1, 6, rules.bounce});
    Recorder seen;
    run->advance(1e-4, seen);
    EXPECT_GE(seen.all.size(), 1U);
    stays_below("overlap at the touch over R", run->energy_balance().deepest_overlap, 1e-11,
                "evt.5: a few margins of 1e-12 R");
  }
}

TEST(ManyBalls, search_for_a_ball_that_no_wall_reaches_ends) {
  kinematics::Tumbling motion;
  motion.speed = 4e3;
  const scene::Chamber mill{geometry::Box{0.1, 0.04, 0.04}, motion, {}, {}};
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  const auto run = event::many_balls(mill, {{0.005, 7850, {0.01, 0.01, 0}, {}, {}}}, rules,
                                     {1, 6, {0.5, 0, 0.3}});
  Recorder seen;
  run->advance(0.1, seen);
  EXPECT_EQ(run->energy_balance().time, 0.1);
  EXPECT_TRUE(seen.all.empty());
}

TEST(ManyBalls, balls_in_a_shaken_jar_stay_inside_and_apart) {
  const scene::Chamber mill{geometry::Capsule{0.03, 0.02}, shaken(20, 0.015), {}, {0, 0, -gravity}};
  std::vector<scene::Ball> balls;
  for (int i = 0; i < 27; ++i)
    balls.push_back({0.002 + 0.0002 * (i % 3),
                     7850,
                     Vec3{0.0055 * (i % 3 - 1), 0.0055 * (i / 3 % 3 - 1), 0.0055 * (i / 9 - 1)},
                     {},
                     {}});
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  const auto engine = event::many_balls(mill, balls, rules, {1, 1, {0.9, 0.3, 0.3}});
  Counter counter;
  for (int i = 1; i <= 100; ++i) {
    engine->advance(0.02 * i, counter);
    const auto now = engine->balls();
    ASSERT_LE(deepest_overlap(now), 1e-11);
    for (const scene::Ball& b : now)
      ASSERT_GE(std::get<geometry::Capsule>(*mill.shape).gap(0, b.position).distance - b.radius,
                -1e-12 * 0.05);
  }
  const scene::EnergyBalance a = engine->energy_balance();
  stays_below("collision balance", a.worst_collision, 1e-12, "rounding");
  stays_below("run balance", std::abs(a.residual()) / a.wall_work, 1e-11, "rounding");
}

}  // namespace
}  // namespace mahlwerk::many_balls_test

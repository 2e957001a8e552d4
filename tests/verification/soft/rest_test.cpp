// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Charges at rest: a pile stays, and the time in which nothing moves is passed at once (dem.47).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "crowd.hpp"
#include "mahlwerk/soft/rest_watch.hpp"
#include "reproducible_runs.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::rest_test {
namespace {

TEST(SoftRest, a_pile_of_three_balls_stays) {
  // Two on the floor, held together by the walls; the third lies on them.
  const double r = 0.005;
  const scene::Chamber box{
      geometry::Box{4 * r + 1e-5, 2 * r + 1e-5, 0.04}, kinematics::Still{}, {}, {0, 0, -gravity}};
  for (const Rolling rule : {Rolling::none, Rolling::cdt, Rolling::epsd}) {
    std::vector<scene::Ball> balls{{r, 7850, {-r - 1e-6, 0, r - 0.0199}, {}, {}},
                                   {r, 7850, {r + 1e-6, 0, r - 0.0199}, {}, {}},
                                   {r, 7850, {1e-4, 0, 3 * r - 0.0199}, {0.05, 0.01, 0}, {}}};
    const auto engine = soft_engine(box, balls, of_law(HertzMindlin{}, rule), soft_pair(0.4), 5e-6);
    Recorder none;
    engine->advance(1.5, none);
    const auto settled = engine->balls();
    double fastest = 0, moved = 0;
    for (int i = 1; i <= 50; ++i) {
      engine->advance(1.5 + 0.01 * i, none);
      for (const scene::Ball& b : engine->balls()) fastest = max_or_nan(fastest, norm(b.velocity));
    }
    const auto later = engine->balls();
    for (std::size_t b = 0; b < 3; ++b)
      moved = max_or_nan(moved, norm(later[b].position - settled[b].position));
    const std::string with = ", rolling rule " + std::to_string(static_cast<int>(rule));
    stays_below("fastest of a settled pile [m/s]" + with, fastest, 1e-4, "at rest");
    stays_below("moved in 0.5 s [m]" + with, moved, 0.5 * 1e-4, "at rest");
  }
}

constexpr double step = 5e-6;

/// A charge that falls in a box, computed by the solver for few balls or that for many.
std::unique_ptr<scene::Engine> falling(bool many, bool hop, int count = 18) {
  const scene::Chamber box{
      geometry::Box{0.025, 0.025, 0.03}, kinematics::Still{}, {}, {0, 0, -gravity}};
  soft::Settings settings{of_law(HertzMindlin{}, Rolling::epsd), step, hop};
  settings.few_ball_limit = many ? 0 : 128;
  contact::Pair pair = soft_pair(0.2);
  pair.rolling_friction = 0.1;
  return soft::make_engine(box, lattice_of(count, 0.0063, {0.003, 0.0028}), settings,
                           contact::PairTable(1, 6, pair), 0.37);
}

TEST(SoftRest, is_passed_at_once_and_leaves_the_charge_where_its_steps_would) {
  constexpr double time = 2;
  const double largest = 0.006;
  for (const bool many : {false, true}) {
    const std::string what = many ? ", solver for many" : ", solver for few";
    const auto passed = falling(many, true), stepped = falling(many, false);
    Recorder some, all;
    passed->advance(time, some);
    stepped->advance(time, all);
    const scene::EnergyBalance a = passed->energy_balance(), b = stepped->energy_balance();
    EXPECT_EQ(b.time_steps, std::lround(time / step));
    const double computed = static_cast<double>(a.time_steps) * step;
    stays_below("computed until it rested [s]" + what, computed, 0.9 * time,
                "the charge is at rest at the end");
    EXPECT_EQ(a.time, b.time);
    const auto balls = passed->balls(), others = stepped->balls();
    double moved = 0;
    for (std::size_t k = 0; k < balls.size(); ++k)
      moved = max_or_nan(moved, norm(balls[k].position - others[k].position));
    const double speed = std::sqrt(2 * soft::RestWatch::largest_lift * gravity * largest);
    stays_below("moved meanwhile [m]" + what, moved, speed * time, "dem.47");
    const double mgd = 18 * 7850 * gravity * largest * std::numbers::pi / 6 * std::pow(largest, 3);
    stays_below(
        "difference of what was lost, over m g d" + what, std::abs(a.lost() - b.lost()) / mgd,
        soft::RestWatch::largest_lift + soft::RestWatch::largest_change * time / 0.28, "dem.47");
    states("time of contact over that of all steps" + what, a.contact_time / b.contact_time, 1,
           1e-3, "the same contacts");
    EXPECT_EQ(a.collisions, b.collisions);
  }
}

TEST(SoftRest, has_the_same_bits_however_a_run_is_cut_and_resumed) {
  constexpr double time = 1.5;
  for (const bool many : {false, true}) {
    SCOPED_TRACE(many);
    const auto whole = falling(many, true), pieces = falling(many, true);
    Recorder in_one, in_many;
    whole->advance(time, in_one);
    EXPECT_LT(whole->energy_balance().time_steps, std::lround(time / step)) << "it came to rest";
    for (int cut = 1; cut <= 300; ++cut) pieces->advance(time * cut / 300, in_many);
    expect_same(in_one, in_many);
    expect_same(*whole, *pieces);
    for (const double when : {0.2, 0.5, 1.4}) {
      const auto first = falling(many, true), second = falling(many, true);
      Recorder none;
      first->advance(when, none);
      copy_state(*first, *second);
      expect_same(*first, *second);
      second->advance(time, none);
      expect_same(*whole, *second);
    }
  }
}

TEST(SoftRest, of_one_replicate_does_not_end_the_steps_of_another) {
  const auto one = falling(false, true), other = falling(false, true, 5),
             alone = falling(false, true, 5);
  Recorder seen, none;
  scene::Engine* engines[] = {one.get(), other.get()};
  scene::Observer* observers[] = {&none, &none};
  for (const double time : {0.3, 1.5}) soft::advance_together(engines, time, observers);
  alone->advance(1.5, seen);
  expect_same(*alone, *other);
}

TEST(SoftRest, is_not_the_apex_of_a_flight) {
  const scene::Chamber box{
      geometry::Box{0.05, 0.05, 0.1}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const double up = 1;  // m/s; at the apex after 0.102 s
  soft::Settings settings{of_law(HertzMindlin{}), step, true};
  settings.few_ball_limit = 0;
  const auto engine = soft::make_engine(box, {ball_a({0, 0, -0.04}, {0, 0, up})}, settings,
                                        contact::PairTable(1, 6, soft_pair()), 0);
  Recorder seen;
  engine->advance(up / gravity + 1e-4, seen);
  const double deadline = 0.25;  // it has fallen to the floor
  engine->advance(deadline, seen);
  EXPECT_EQ(seen.all.size(), 1U);
  EXPECT_EQ(engine->energy_balance().time_steps, std::lround(deadline / step));
}

TEST(SoftRest, is_not_that_of_a_ball_that_begins_to_topple) {
  // One ball on another, 0.1 um beside its top: it begins slower than the limit of rest.
  const double r = 0.0025, side = 0.03, beside = 1e-7;
  const scene::Chamber box{
      geometry::Box{side, side, side}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const std::vector<scene::Ball> balls{{r, 7850, {0, 0, r - side / 2}, {}, {}},
                                       {r, 7850, {beside, 0, 3 * r - side / 2}, {}, {}}};
  for (const bool many : {false, true}) {
    soft::Settings settings{of_law(HertzMindlin{}), step, true};
    settings.few_ball_limit = many ? 0 : 128;
    const auto engine =
        soft::make_engine(box, balls, settings, contact::PairTable(1, 6, soft_pair(0.4)), 0);
    Recorder none;
    engine->advance(2, none);
    stays_below("height of the upper ball over that of the lower, in radii",
                (engine->balls()[1].position.z - engine->balls()[0].position.z) / r, 0.1,
                "it has fallen beside it");
  }
}

TEST(SoftRest, is_not_looked_for_in_a_jar_that_turns_or_in_a_liquid) {
  const std::vector<scene::Ball> resting{ball_a({0, 0, -0.05 + 0.005}, {})};
  const auto steps = [&](const kinematics::AnyMotion& motion, bool wet) {
    const scene::Chamber jar{geometry::Box{0.05, 0.05, 0.1}, motion, {}, {0, 0, -gravity}};
    soft::Settings settings{of_law(HertzMindlin{}), step, true};
    settings.few_ball_limit = 0;
    if (wet) settings.liquid = contact::Liquid{.viscosity = 1e-3, .film = 1e-5};
    const auto engine =
        soft::make_engine(jar, resting, settings, contact::PairTable(1, 6, soft_pair()), 0);
    Recorder none;
    engine->advance(0.5, none);
    return engine->energy_balance().time_steps;
  };
  const auto all = std::lround(0.5 / step);
  EXPECT_LT(steps(kinematics::Still{}, false), all);
  EXPECT_EQ(steps(kinematics::Tumbling{1e-9}, false), all);
  EXPECT_EQ(steps(kinematics::Still{}, true), all);
}

}  // namespace
}  // namespace mahlwerk::tests::rest_test

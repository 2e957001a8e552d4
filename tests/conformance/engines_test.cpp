// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What every engine keeps: the event engine of one ball and of many, the soft engine of few balls
// and of many. Each statement is written once; LAMMPS is held to the soft engine elsewhere
// (tests/verification, lammps).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lammps_cases.hpp"
#include "mahlwerk/campaign/run/replicate_engine.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::engines_test {
namespace {

/// An engine, chosen by a case with so many more balls at rest, far from what happens.
struct Variant {
  const char* name;
  const char* engine;
  int others;
  double accuracy;  ///< [1] relative, of the results of a hit
};
constexpr double radius = 5e-3, density = 7850;
const double mass = density * 4 / 3 * std::numbers::pi * std::pow(radius, 3);

struct Start {
  Vec3 position, velocity, spin;
};

std::string triple(const Vec3& v, const char* unit) {
  return fmt::format("[\"{0:.17g} {3}\", \"{1:.17g} {3}\", \"{2:.17g} {3}\"]", v.x, v.y, v.z, unit);
}

/// A case with these balls in a box of 0.4 m.
struct Setting {
  std::vector<Start> balls;
  std::string mill = "kind = \"still\"";
  double gravity = 0, restitution = 0.7, friction = 0.3;
};

cases::Case case_of(const Variant& variant, const Setting& s) {
  std::string positions, velocities, spins;
  const auto add = [&](const Start& b) {
    positions += triple(b.position, "m") + ", ";
    velocities += triple(b.velocity, "m/s") + ", ";
    spins += triple(b.spin, "rad/s") + ", ";
  };
  for (const Start& b : s.balls) add(b);
  for (int i = 0; i < variant.others; ++i)
    add({{-0.15 + 0.02 * i, 0.18, 0.18}, {}, {}});  // near an edge of the box
  return case_of_text(fmt::format(
      "gravity = \"{} m/s2\"\n[mill]\n{}\n[jar]\nkind = \"box\"\nwidth = \"0.4 m\"\ndepth = \"0.4 "
      "m\"\nheight = \"0.4 m\"\nyoungs_modulus = \"50 GPa\"\n[[balls]]\ndiameter = \"10 mm\"\n"
      "density = \"7850 kg/m3\"\nyoungs_modulus = \"50 GPa\"\npositions = [{}]\nvelocities = "
      "[{}]\nspins = [{}]\n[contact]\nrestitution = {}\nfriction = {}\nrolling = \"none\"\n"
      "{}[run]\nengine = \"{}\"\ntime = \"1 s\"\n"
      "settle = \"0 s\"\n",
      s.gravity, s.mill, positions, velocities, spins, s.restitution, s.friction,
      variant.engine == std::string("event") ? "tangential_restitution = 0\n" : "",
      variant.engine));
}

std::unique_ptr<scene::Engine> engine_of(const Variant& variant, const Setting& s) {
  static std::vector<std::unique_ptr<cases::Case>> kept;  // an engine may refer to its case
  kept.push_back(std::make_unique<cases::Case>(case_of(variant, s)));
  return campaign::engine(*kept.back(), 0, 1, nullptr);
}

class Engines : public ::testing::TestWithParam<Variant> {
 protected:
  /// Runs the setting to `time` [s], in `parts` calls.
  void run(const Setting& s, double time, int parts = 1) {
    engine = engine_of(GetParam(), s);
    for (int i = 1; i <= parts; ++i) engine->advance(time * i / parts, records);
  }
  double accuracy() const { return GetParam().accuracy; }
  /// [s] Longest time step of the soft engine in these cases.
  double step() const { return accuracy() > 1e-9 ? 2e-6 : 0; }
  /// [J] Most that the TC rule stores in a body instead of losing it, of bounces at 0.1 mm/s
  /// (man.6).
  static double stored() { return 0.5 * mass * 1e-8; }
  std::unique_ptr<scene::Engine> engine;
  Recorder records;
};

INSTANTIATE_TEST_SUITE_P(All, Engines,
                         ::testing::Values(Variant{"event_one_ball", "event", 0, 1e-12},
                                           Variant{"event_many_balls", "event", 2, 1e-12},
                                           // A fiftieth of a collision (dem.31).
                                           Variant{"soft_few_balls", "soft", 2, 4e-3},
                                           Variant{"soft_many_balls", "soft", 12, 4e-3}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(Engines, let_a_ball_fly_on_its_parabola_with_its_spin) {
  const Vec3 v{0.3, -0.2, 0.5}, spin{1, 2, 3};
  run({.balls = {{{0, 0, 0}, v, spin}}, .gravity = 9.81}, 0.1);
  const scene::Ball ball = engine->balls().front();
  const double t = engine->energy_balance().time;  // a whole number of steps
  const Vec3 expected = t * v + Vec3{0, 0, -0.5 * 9.81 * t * t};
  states("distance from the parabola [m]", norm(ball.position - expected), 0, 1e-12,
         "v t + g t^2/2");
  states("difference of velocity [m/s]", norm(ball.velocity - (v + Vec3{0, 0, -9.81 * t})), 0,
         1e-11, "v + g t");
  EXPECT_EQ(ball.spin, spin);
  EXPECT_TRUE(records.all.empty());
}

TEST_P(Engines, tell_a_head_on_hit_of_the_wall_once_with_its_impulse_and_loss) {
  run({.balls = {{{0, 0, -0.19}, {0, 0, -0.5}, {}}}}, 0.05);
  ASSERT_EQ(records.all.size(), 1U);
  const scene::Collision& hit = records.all.front();
  EXPECT_EQ(hit.ball, 0);
  EXPECT_LT(hit.other, 0);
  states("time of touch [s]", hit.time, (0.01 - radius) / 0.5, step() + 1e-12, "x/v");
  states("normal speed [m/s]", hit.approach, 0.5, 1e-12, "it flew without forces");
  states("normal", hit.normal.z, -1, 1e-12, "from the ball to the bottom");
  states("mass [kg]", hit.mass, mass, 1e-12 * mass, "the ball's own");
  states("impulse [N s]", hit.impulse, mass * 0.5 * 1.7, accuracy() * mass, "m (1 + e) u");
  states("loss [J]", hit.lost(), 0.5 * mass * 0.25 * (1 - 0.49),
         accuracy() * mass + 1.01 * stored(), "m u^2 (1 - e^2)/2");
  states("rebound [m/s]", engine->balls().front().velocity.z, 0.35, accuracy(), "e u");
  EXPECT_EQ(engine->energy_balance().collisions, 1);
}

TEST_P(Engines, turn_a_ball_that_slips_at_the_wall_by_the_friction_of_its_impulse) {
  // Elastic, as dampers pull at the end of a contact. It slips from the first to the last moment:
  // u_t/u_n = 4 is above 7/2 mu (1 + e) = 2.1.
  run({.balls = {{{0, 0, -0.19}, {2, 0, -0.5}, {}}}, .restitution = 1}, 0.05);
  const scene::Ball ball = engine->balls().front();
  const double change = 0.3 * 0.5 * 2;  // [m/s] mu J/m
  states("velocity along the wall [m/s]", ball.velocity.x, 2 - change, 2 * accuracy(),
         "v - mu J/m");
  states("spin [rad/s]", ball.spin.y, 2.5 * change / radius, 2.5 * accuracy() / radius,
         "5 mu J/(2 m r)");
  states("loss along the wall [J]", records.all.at(0).lost_tangential,
         mass * change * (2 - 0.5 * 3.5 * change), 4 * accuracy() * mass + 1.01 * stored(),
         "mu J times the mean slip");
}

TEST_P(Engines, keep_the_momentum_of_two_balls_and_lose_the_share_of_the_restitution) {
  if (GetParam().others == 0) return;  // one ball
  run({.balls = {{{-0.05, 0, 0}, {0.6, 0, 0}, {}}, {{0.05, 0, 0}, {-0.2, 0, 0}, {}}}}, 0.15);
  ASSERT_EQ(records.all.size(), 1U);
  const std::vector<scene::Ball> balls = engine->balls();
  states("sum of velocities [m/s]", balls[0].velocity.x + balls[1].velocity.x, 0.4, 1e-12,
         "momentum");
  states("separation [m/s]", balls[1].velocity.x - balls[0].velocity.x, 0.7 * 0.8, accuracy(),
         "e times the approach");
  states("mass [kg]", records.all[0].mass, mass / 2, 1e-12 * mass, "m/2");
  states("loss [J]", records.all[0].lost(), 0.25 * mass * 0.64 * (1 - 0.49),
         accuracy() * mass + 2.01 * stored(), "m u^2 (1 - e^2)/4");
}

/// A box that moves up and down: 8 mm sin(2 pi 15 Hz t).
Setting shaken() {
  return {.balls = {{{0, 0, -0.18}, {0.3, 0.1, -0.2}, {20, 10, 5}}},
          .mill = "kind = \"vibration\"\nfrequency = \"15 Hz\"\namplitude = \"8 mm\"",
          .gravity = 9.81};
}

TEST_P(Engines, book_the_work_of_a_moving_wall_as_loss_and_energy) {
  run(shaken(), 1);
  const scene::EnergyBalance energy = engine->energy_balance();
  EXPECT_GT(records.all.size(), 4U);
  const double scale = std::abs(energy.wall_work) + energy.lost() + energy.initial_energy;
  stays_below("residual over work and losses", std::abs(energy.residual()) / scale,
              std::max(1e-11, 0.1 * accuracy()), "dem.32");
}

TEST_P(Engines, do_the_work_of_each_impulse_at_the_speed_of_the_wall) {
  Setting s = shaken();
  s.friction = 0;
  run(s, 1);
  const double w = 2 * std::numbers::pi * 15;
  double work = 0;
  for (const scene::Collision& hit : records.all)
    work -= hit.impulse * hit.normal.z * 8e-3 * w * std::cos(w * (hit.time + 0.5 * hit.duration));
  // Contacts of 30 us: the wall's speed changes by w^2 A times half of this.
  states("work [J]", engine->energy_balance().wall_work, work,
         1e-3 * std::abs(work) + (accuracy() > 1e-9 ? 1e-2 : 1e-12) * std::abs(work),
         "sum of J n v_wall");
}

TEST_P(Engines, tell_every_collision_once_and_lose_nothing_else) {
  run(shaken(), 1);
  double lost = 0;
  for (const scene::Collision& hit : records.all) lost += hit.lost();
  const scene::EnergyBalance energy = engine->energy_balance();
  states("losses [J]", energy.lost() - energy.lost_lasting - energy.lost_open, lost,
         1e-9 * energy.lost(), "the records");
  for (std::size_t i = 1; i < records.all.size(); ++i)
    EXPECT_GE(records.all[i].time + records.all[i].duration,
              records.all[i - 1].time + records.all[i - 1].duration - 1e-12)
        << "they come in the order of their end";
}

TEST_P(Engines, give_the_same_bits_however_a_run_is_cut) {
  run(shaken(), 0.5);
  const std::vector<scene::Ball> whole = engine->balls();
  const std::size_t count = records.all.size();
  records.all.clear();
  run(shaken(), 0.5, 37);
  EXPECT_EQ(records.all.size(), count);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(engine->balls()[i].position, whole[i].position);
    EXPECT_EQ(engine->balls()[i].spin, whole[i].spin);
  }
}

TEST_P(Engines, go_on_from_a_state_with_the_same_bits) {
  run(shaken(), 0.5);
  Archive saved;
  const auto first = engine_of(GetParam(), shaken());
  Recorder before, after;
  first->advance(0.23, before);
  first->serialize(saved);
  const auto second = engine_of(GetParam(), shaken());
  Archive reading(saved.bytes());
  second->serialize(reading);
  reading.finish();
  second->advance(0.5, after);
  EXPECT_EQ(before.all.size() + after.all.size(), records.all.size());
  EXPECT_EQ(second->balls().front().position, engine->balls().front().position);
  EXPECT_EQ(second->energy_balance().wall_work, engine->energy_balance().wall_work);
}

TEST_P(Engines, end_at_the_time_that_is_asked_for) {
  run(shaken(), 0.123);
  states("time [s]", engine->energy_balance().time, 0.123, step() + 1e-15, "within a step");
}

TEST_P(Engines, stop_when_they_are_told) {
  engine = engine_of(GetParam(), shaken());
  const std::atomic<bool> stop = true;
  engine->stop_on(&stop);
  engine->advance(1, records);
  EXPECT_LT(engine->energy_balance().time, 1);
}

}  // namespace
}  // namespace mahlwerk::tests::engines_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Stirrers in a jar at rest that a motor turns, or that turn freely (kin.24 to kin.26).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "crowd.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"
#include "one_ball.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::stirrer_drive_test {
namespace {

using kinematics::Motor;
using kinematics::PartMotion;

constexpr double pi = std::numbers::pi, time_step = 2e-6, full = -20;  // [s], [rad/s]

scene::MachinePart on_shaft(geometry::AnySolid solid, const Vec3& position) {
  scene::MachinePart part;
  part.solid = std::move(solid);
  part.position = position;
  part.motion.kind = PartMotion::Kind::turning;
  part.motion.speed = full;
  return part;
}

/// Two blades across each other on one shaft.
scene::Chamber paddles(const Vec3& down) {
  scene::Chamber mill{geometry::Cylinder{0.06, 0.05}, kinematics::Still{}, {}, down};
  mill.parts.push_back(on_shaft(geometry::BladeSolid{0.045, 0.003, 0.04}, {0, 0, -0.003}));
  mill.parts.push_back(on_shaft(geometry::BladeSolid{0.003, 0.045, 0.04}, {0, 0, 0.003}));
  return mill;
}
scene::Chamber attritor(const Vec3& down) {
  geometry::Attritor jar;
  jar.diameter = 0.06, jar.height = 0.05, jar.shaft_diameter = 0.01, jar.shaft_clearance = 0.004;
  jar.arms = 4, jar.arm_diameter = 0.005, jar.arm_span = 0.046;
  jar.arm_clearance = 0.006, jar.arm_spacing = 0.01, jar.rotor_speed = full;
  jar.complete();
  return {jar, kinematics::Still{}, {}, down};
}

std::unique_ptr<scene::Engine> engine_of(scene::Chamber mill, const Motor& motor,
                                         const std::vector<scene::Ball>& balls, std::size_t few,
                                         double friction, int threads = 1) {
  mill.motion = kinematics::driven(kinematics::Still{}, motor, full);
  const auto wall = soft::moving_wall(mill);
  soft::Settings settings{of_law(contact::HertzMindlin{}, contact::Rolling::none), time_step, true};
  settings.few_ball_limit = few;
  settings.threads = threads;
  const contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, friction);
  return soft::make_engine(mill, balls, settings, contact::PairTable(1, wall->faces(), pair), 0);
}

/// Balls of 3 mm, clear of all arms and blades.
std::vector<scene::Ball> balls_between(const scene::Chamber& mill, std::size_t count) {
  const auto wall = soft::moving_wall(mill);
  const auto axes = wall->axes(0);
  std::vector<scene::Ball> all;
  for (const scene::Ball& b : lattice_of(4000, 0.0034, {0.0015}, 0.05)) {
    double gap = std::hypot(b.position.x, b.position.y) < 0.022 ? geometry::never : 0;
    for (int face = 0; face < wall->faces(); ++face)
      gap = std::min(gap, wall->gap_distance(face, b.position, axes, 0.01, nullptr));
    if (all.size() < count && gap > 0.0016) all.push_back(b);
  }
  return all;
}

double angular_momentum(const std::vector<scene::Ball>& balls) {
  double sum = 0;
  for (const scene::Ball& b : balls) {
    const double mass = b.density * 4 * pi / 3 * std::pow(b.radius, 3);
    sum += mass * cross(b.position, b.velocity).z + 0.4 * mass * b.radius * b.radius * b.spin.z;
  }
  return sum;
}

/// Without friction the round vessel turns no ball about its axis: the stirrer alone does.
TEST(StirrerDrive, that_turns_freely_keeps_angular_momentum_and_energy_of_stirrer_and_balls) {
  const Motor free{.inertia = 4e-6, .torque = 0, .start_speed = 20};
  for (const scene::Chamber& mill : {paddles({}), attritor({})})
    for (const std::size_t few : {128U, 0U}) {
      const std::vector<scene::Ball> balls = balls_between(mill, 60);
      ASSERT_EQ(balls.size(), 60U);
      const auto engine = engine_of(mill, free, balls, few, 0);
      // The stirrer turns by -20 rad/s about z; its speed counts in its own sense.
      const auto momentum = [&] {
        return angular_momentum(engine->balls()) -
               free.inertia * engine->energy_balance().mill_speed;
      };
      const double before = momentum();
      Recorder none;
      double largest = 0;
      for (int k = 1; k <= 20; ++k) {
        engine->advance(0.02 * k, none);
        largest = std::max(largest, std::abs(momentum() - before));
      }
      const scene::EnergyBalance a = engine->energy_balance();
      EXPECT_LT(a.mill_speed, 19.5) << "the balls have braked the stirrer";
      // The stirrer gets each impulse 4 to 8 steps later: of a force of some 3 N at 0.023 m.
      stays_below("change of angular momentum [N m s]", largest, 3 * 0.023 * 8 * time_step,
                  "no outer torque");
      states("work of the stirrer on the balls [J]", a.wall_work,
             0.5 * free.inertia * 400 - a.drive_kinetic, 2e-3 * a.wall_work,
             "energy of the stirrer");
    }
}

TEST(StirrerDrive, without_load_comes_to_speed_exponentially) {
  const Motor motor{.inertia = 2e-5, .torque = 0.01};
  // One ball at rest beneath the arms and blades, without weight.
  const std::vector<scene::Ball> ball{{0.001, 7850, {0, 0, -0.0235}, {}, {}}};
  const double tau = motor.inertia * std::abs(full) / motor.torque;
  for (const std::size_t few : {64U, 0U}) {
    scene::Chamber mill = paddles({});
    for (scene::MachinePart& part : mill.parts) part.position.z += 0.006;
    const auto engine = engine_of(mill, motor, ball, few, 0.3);
    Recorder none;
    for (const double t : {0.01, 0.04, 0.2}) {
      engine->advance(t, none);
      const scene::EnergyBalance a = engine->energy_balance();
      states("speed [rad/s]", a.mill_speed, std::abs(full) * (1 - std::exp(-t / tau)), 1e-4,
             "exponential approach; the run ends at a step");
      states("angle [rad]", a.mill_angle, std::abs(full) * (t - tau * (1 - std::exp(-t / tau))),
             1e-4, "its integral");
    }
    EXPECT_EQ(engine->energy_balance().collisions, 0);
  }
}

TEST(StirrerDrive, gives_the_charge_what_the_motor_does_not_keep) {
  const Motor motor{.inertia = 1e-5, .torque = 0.004};
  const Vec3 down{0, 0, -gravity};
  for (const scene::Chamber& mill : {paddles(down), attritor(down)})
    for (const std::size_t few : {128U, 0U}) {
      const auto engine = engine_of(mill, motor, balls_between(mill, 100), few, 0.4);
      Recorder none;
      engine->advance(0.25, none);
      const scene::EnergyBalance a = engine->energy_balance();
      states("work of the motor [J]", a.motor_work, a.wall_work + a.drive_kinetic,
             1e-3 * a.motor_work, "books of the drive (kin.26)");
      EXPECT_GT(a.wall_work, 0.02 * a.motor_work);
      EXPECT_LT(a.mill_speed, 19.9) << "its speed falls under load";
      EXPECT_LT(std::abs(a.residual()), 1e-3 * a.wall_work + 1e-7);
    }
}

TEST(StirrerDrive, has_the_same_bits_on_any_number_of_threads_and_after_a_restart) {
  const Motor motor{.inertia = 1e-5, .torque = 0.004};
  const scene::Chamber mill = paddles({0, 0, -gravity});
  const std::vector<scene::Ball> balls = balls_between(mill, 100);
  for (const std::size_t few : {128U, 0U}) {
    const auto make = [&](int threads) { return engine_of(mill, motor, balls, few, 0.4, threads); };
    Recorder none;
    const auto whole = make(1), threads = make(2), first = make(1), resumed = make(1);
    whole->advance(0.06, none);
    threads->advance(0.0123, none);
    threads->advance(0.06, none);
    first->advance(0.031, none);
    copy_state(*first, *resumed);
    resumed->advance(0.06, none);
    for (const auto* other : {threads.get(), resumed.get()}) {
      const auto a = whole->balls(), b = other->balls();
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
      EXPECT_EQ(whole->energy_balance().mill_speed, other->energy_balance().mill_speed);
      EXPECT_EQ(whole->energy_balance().motor_work, other->energy_balance().motor_work);
    }
  }
}

}  // namespace
}  // namespace mahlwerk::tests::stirrer_drive_test

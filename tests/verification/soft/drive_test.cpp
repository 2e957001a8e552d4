// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Mills whose speed a motor and the charge decide (kin.24 to kin.26).
#include "mahlwerk/kinematics/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "crowd.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"
#include "one_ball.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::drive_test {
namespace {

using kinematics::Drive;
using kinematics::Motor;

constexpr double pi = std::numbers::pi;

TEST(Drive, without_load_comes_to_speed_exponentially) {
  const Motor motor{.inertia = 0.02, .torque = 0.5};
  for (const double speed : {12.0, -12.0}) {
    Drive drive(motor, speed);
    drive.restart(0.37);
    constexpr double step = 1e-4;
    const double tau = motor.inertia * std::abs(speed) / motor.torque;
    int k = 0;
    for (; k < 20000; ++k) drive.advance(0.37 + step * (k + 1), 0, k % 16 == 0);
    for (const double t : {0.1, 0.5, 1.3, 2.0}) {
      // The trapezoidal rule errs by (step/tau)^2/12 t/tau exp(-t/tau), below 1e-7.
      const kinematics::Clock at = drive.clock(0.37 + t);
      states("rate", at.rate, 1 - std::exp(-t / tau), 1e-7, "exponential approach");
      states("time of the mill [s]", at.time, t - tau * (1 - std::exp(-t / tau)), 1e-7,
             "its integral");
    }
    states("speed [rad/s]", drive.speed(0.37 + step * k),
           std::abs(speed) * (1 - std::exp(-step * k / tau)), 1e-6, "exponential approach");
    states("work of the motor [J]", drive.motor_work(0.37 + step * k),
           drive.kinetic(0.37 + step * k), 1e-7, "no load: all is kinetic");
  }
}

TEST(Drive, of_an_induction_motor_has_the_torque_of_Kloss) {
  const Motor motor{
      .kind = Motor::Kind::induction, .inertia = 1, .torque = 30, .breakdown_slip = 0.25};
  states("at breakdown slip [N m]", motor.torque_at(0.75), 30, 1e-12, "largest torque");
  states("without load [N m]", motor.torque_at(1), 0, 1e-12, "no slip");
  states("at standstill [N m]", motor.torque_at(0), 30 * 2 / (1 / 0.25 + 0.25), 1e-12, "Kloss");
  states("above its speed [N m]", motor.torque_at(1.25), -30, 1e-12, "a generator");
  EXPECT_LT(motor.torque_at(0.7), 30);
  EXPECT_LT(motor.torque_at(0.8), 30);
}

TEST(Drive, at_constant_load_turns_where_motor_and_load_balance) {
  const Motor motor{.inertia = 0.02, .torque = 0.5};
  Drive drive(motor, 12);
  constexpr double step = 1e-3, load = 0.2;
  for (int k = 0; k < 10000; ++k) drive.advance(step * (k + 1), -load * step * (k + 1), true);
  const double tau = motor.inertia * 12 / motor.torque;  // and what is left of the start
  states("speed [rad/s]", drive.speed(10), 12 * (1 - load / motor.torque),
         12 * std::exp(-10 / tau) + 1e-12, "T0 (1 - n/n0) = load");
}

/// A drum of its own in each run.
scene::Chamber drum(const Motor& motor, double speed, const Vec3& down,
                    geometry::AnyShape shape = geometry::Cylinder{0.04, 0.04}) {
  return {std::move(shape), kinematics::driven(kinematics::Tumbling{speed}, motor, speed),
          scene::mounted_along({1, 0, 0}), down};
}

constexpr double time_step = 2e-6;

std::unique_ptr<scene::Engine> engine_of(const scene::Chamber& mill,
                                         const std::vector<scene::Ball>& balls, std::size_t few,
                                         int threads = 1) {
  const auto wall = soft::moving_wall(mill);
  soft::Settings settings{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), time_step, true};
  settings.few_ball_limit = few;
  settings.threads = threads;
  return soft::make_engine(mill, balls, settings, contact::PairTable(1, wall->faces(), some_pair()),
                           0.37);
}

double angular_momentum(const std::vector<scene::Ball>& balls) {
  double sum = 0;
  for (const scene::Ball& b : balls) {
    const double mass = b.density * 4 * pi / 3 * std::pow(b.radius, 3);
    sum += mass * cross(b.position, b.velocity).x + 0.4 * mass * b.radius * b.radius * b.spin.x;
  }
  return sum;
}

TEST(Drive, of_a_free_jar_keeps_angular_momentum_and_energy_of_jar_and_balls) {
  const Motor free{.inertia = 2e-5, .torque = 0, .start_speed = 12};
  const std::vector<scene::Ball> balls = lattice_of(30, 0.0063, {0.003}, 0.3);
  for (const std::size_t few : {64, 0}) {
    const auto engine = engine_of(drum(free, 12, {}), balls, few);
    const auto momentum = [&] {
      return angular_momentum(engine->balls()) + free.inertia * engine->energy_balance().mill_speed;
    };
    const double before = momentum();
    Recorder none;
    double largest = 0;
    for (int k = 1; k <= 40; ++k) {
      engine->advance(0.05 * k, none);
      largest = std::max(largest, std::abs(momentum() - before));
    }
    const scene::EnergyBalance a = engine->energy_balance();
    EXPECT_LT(std::abs(a.mill_speed), 11) << "the balls have braked the jar";
    // The jar gets each impulse 4 to 8 steps later: of a force of at most some 30 N at 0.02 m.
    stays_below("change of angular momentum [N m s]", largest, 30 * 0.02 * 8 * time_step,
                "no outer torque");
    states("work of the jar on the balls [J]", a.wall_work,
           0.5 * free.inertia * 144 - a.drive_kinetic, 1e-3 * a.wall_work, "energy of the jar");
    states("work of the motor [J]", a.motor_work, 0, 1e-15, "no motor");
  }
}

TEST(Drive, gives_the_charge_what_the_motor_does_not_keep) {
  const Motor motor{.inertia = 1e-4, .torque = 0.02};
  const std::vector<scene::Ball> balls = lattice_of(60, 0.0055, {0.0025}, 0.1);
  const auto engine = engine_of(drum(motor, 20, {0, 0, -gravity}), balls, 0);
  Recorder none;
  engine->advance(0.6, none);
  const scene::EnergyBalance a = engine->energy_balance();
  // The lag of 8 steps over the 0.1 s in which the mill changes its speed.
  states("work of the motor [J]", a.motor_work, a.wall_work + a.drive_kinetic,
         1.6e-4 * a.motor_work, "books of the drive (kin.26)");
  EXPECT_GT(a.wall_work, 0.05 * a.motor_work);
  EXPECT_LT(a.mill_speed, 19.9) << "its speed falls under load";
  EXPECT_LT(std::abs(a.residual()), 1e-3 * a.wall_work + 1e-7);
}

TEST(Drive, under_a_charge_of_many_balls_bears_their_weight) {
  // Chunks of the solver are emptied every 64 steps: their loads must arrive.
  const Motor motor{.inertia = 3e-4, .torque = 0.05};
  const auto engine = engine_of(drum(motor, 20, {0, 0, -gravity}, geometry::Cylinder{0.06, 0.06}),
                                lattice_of(700, 0.0043, {0.002}, 0.1), 0);
  Recorder none;
  engine->advance(0.15, none);
  const scene::EnergyBalance a = engine->energy_balance();
  states("work of the motor [J]", a.motor_work, a.wall_work + a.drive_kinetic,
         1.6e-4 * a.motor_work, "books of the drive (kin.26)");
  EXPECT_GT(a.wall_work, 0.1 * a.motor_work);
}

TEST(Drive, whose_inertia_is_too_small_for_the_steps_is_refused) {
  const Motor motor{.inertia = 1e-9, .torque = 0.5};
  EXPECT_THROW(engine_of(drum(motor, 20, {0, 0, -gravity}), {{0.003, 7850, {}, {}, {}}}, 64),
               InputError);
}

TEST(Drive, has_the_same_bits_on_any_number_of_threads_and_after_a_restart) {
  const Motor motor{.inertia = 3e-5, .torque = 0.01};
  const Vec3 down{0, 0, -gravity};
  geometry::LifterCylinder lifters;
  lifters.diameter = lifters.height = 0.04;
  lifters.lifters = 4, lifters.lifter_height = lifters.lifter_width = 0.004;
  lifters.lifter_face_angle = pi / 2;
  lifters.complete();
  const std::vector<scene::Ball> balls = lattice_of(60, 0.0055, {0.0025}, 0.1);
  for (const std::size_t few : {64, 0}) {
    const auto make = [&](int threads) {
      return engine_of(drum(motor, 20, down, lifters), balls, few, threads);
    };
    Recorder none;
    const auto whole = make(1), threads = make(2), first = make(1), resumed = make(1);
    whole->advance(0.03, none);
    threads->advance(0.0123, none);
    threads->advance(0.03, none);
    first->advance(0.011, none);
    copy_state(*first, *resumed);
    resumed->advance(0.03, none);
    for (const auto* other : {threads.get(), resumed.get()}) {
      const auto a = whole->balls(), b = other->balls();
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].position, b[i].position);
        EXPECT_EQ(a[i].spin, b[i].spin);
      }
      EXPECT_EQ(whole->energy_balance().mill_speed, other->energy_balance().mill_speed);
      EXPECT_EQ(whole->energy_balance().motor_work, other->energy_balance().motor_work);
    }
    EXPECT_GT(whole->energy_balance().mill_speed, 1);
  }
}

TEST(Drive, that_the_balls_turn_too_fast_ends_the_run_with_a_message) {
  // A heavy charge that spins in a light jar.
  const Motor free{.inertia = 1e-9, .torque = 0, .start_speed = 0};
  std::vector<scene::Ball> balls{{0.004, 7850, {0, 0, -0.01599}, {0, 2, 0}, {}}};
  for (const std::size_t few : {64, 0}) {
    const auto engine = engine_of(drum(free, 5, {0, 0, -gravity}), balls, few);
    Recorder none;
    EXPECT_THROW(engine->advance(0.1, none), RunError);
  }
}

}  // namespace
}  // namespace mahlwerk::tests::drive_test

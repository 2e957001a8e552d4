// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine in jars with parts: a lifter carries a ball to the angle given by the forces, an
// arm of a stirrer hits like a moving wall, and the work of the stirrer is stored or dissipated.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::parts_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

constexpr double pi = std::numbers::pi;

std::unique_ptr<scene::Engine> run_in(const scene::Chamber& chamber,
                                      const std::vector<scene::Ball>& balls,
                                      const contact::Pair& pair, double step,
                                      std::size_t few = 32) {
  soft::Settings rules{of_law(HertzMindlin{}, Rolling::none), step, false};
  rules.few_ball_limit = few;
  const int faces = geometry::faces(*chamber.shape);
  return soft::make_engine(chamber, balls, rules, contact::PairTable(1, faces, pair), 0);
}

geometry::Attritor stirrer(double speed) {
  geometry::Attritor jar;
  jar.diameter = 0.1, jar.height = 0.12, jar.shaft_diameter = 0.02, jar.shaft_clearance = 0.01;
  jar.arms = 4, jar.arm_diameter = 0.008, jar.arm_span = 0.08;
  jar.arm_clearance = 0.02, jar.arm_spacing = 0.02, jar.rotor_speed = speed;
  jar.complete();
  return jar;
}

/// Balls of 6 mm on a lattice that touch nothing.
template <class S>
std::vector<scene::Ball> random_balls_in(const S& jar, std::size_t count) {
  constexpr double radius = 0.003;
  std::vector<scene::Ball> balls;
  Random random(4, 0);
  for (double z = -0.056; z < 0.056; z += 0.0065)
    for (double y = -0.046; y < 0.047; y += 0.0065)
      for (double x = -0.046; x < 0.047; x += 0.0065) {
        double gap = geometry::never;
        for (int face = 0; face < jar.faces; ++face)
          gap = std::min(gap, jar.gap(face, {x, y, z}).distance);
        if (gap > radius && balls.size() < count)
          balls.push_back({radius, 7850, {x, y, z}, 0.01 * random.direction(), {}});
      }
  return balls;
}

TEST(LifterJar, a_ball_without_friction_leaves_the_shell_where_the_forces_say) {
  geometry::LifterCylinder jar;
  jar.diameter = 0.2, jar.height = 0.05;
  jar.lifters = 1, jar.lifter_height = 0.02, jar.lifter_width = 0.01;
  jar.lifter_face_angle = 0.5 * pi;
  jar.complete();
  // The drum lies along x and turns about it. The lifter, at the jar's own x axis, starts low.
  const double radius = 0.005, turn = 5, aside = 0.5 * jar.lifter_width + radius;
  const double shell = 0.5 * jar.diameter - radius, out = std::sqrt(shell * shell - aside * aside);
  const Rotation mount = scene::mounted_along({1, 0, 0});
  const kinematics::Tumbling mill{turn};
  const scene::Chamber chamber{jar, mill, mount, {0, 0, -gravity}};
  // The lifter is at the angle a to the horizontal. The ball rides ahead of it.
  const Vec3 along0 = mount * Vec3{1, 0, 0}, aside0 = mount * Vec3{0, 1, 0};
  const double sense = dot(cross(mill.spin(0), along0), aside0) > 0 ? 1 : -1;
  const Vec3 place = out * along0 + sense * aside * aside0;
  const contact::Pair pair = pair_of({1e11, 0.3}, {1e11, 0.3}, 0.3, 0);
  const scene::Ball ball{radius, 7850, place, cross(mill.spin(0), place), {}};
  const auto engine = run_in(chamber, {ball}, pair, 2e-7);
  Recorder seen;
  engine->advance(0.5, seen);
  const auto on_shell = std::ranges::find_if(
      seen.all, [](const scene::Collision& c) { return c.other == ~0 && c.time < 1e-3; });
  ASSERT_NE(on_shell, seen.all.end());
  const Vec3 bar = mill.rotation(on_shell->duration) * along0;
  // The force k x^1.5 of the shell falls by m g w per second. During the last time t the contact
  // oscillates too slowly to follow: 1.5 k^(2/3) (m g w t)^(1/3) t^2 = m.
  const double k = 4.0 / 3 * pair.modulus * std::sqrt(radius), m = ball.mass();
  const double t =
      std::pow(m / (1.5 * std::pow(k, 2.0 / 3) * std::cbrt(m * gravity * turn)), 3.0 / 7);
  // Along the side of the lifter, g sin(a) exceeds the component of the centripetal force.
  states("angle of the bar over the horizontal [rad]", std::asin(bar.z),
         std::asin(turn * turn * out / gravity), 2 * turn * t, "balance along the bar");
}

TEST(StirredJar, an_arm_drives_a_ball_at_rest_off_as_a_moving_wall_does) {
  constexpr double turn = 5, radius = 0.003, e = 0.5, far = 0.03;
  const geometry::Attritor jar = stirrer(turn);
  for (const std::size_t few : {32, 0}) {
    // The ball is level with the lowest arm, a little ahead of it, without gravity.
    const double z = jar.arm_clearance - 0.5 * jar.height, ahead = radius + 0.5 * jar.arm_diameter;
    scene::Chamber chamber{jar, kinematics::Still{}, {}, {}};
    const auto engine = run_in(chamber, {{radius, 7850, {far, ahead + 1e-5, z}, {}, {}}},
                               pair_of({1e9, 0.3}, {1e9, 0.3}, e, 0), 2e-7, few);
    Recorder seen;
    engine->advance(1e-3, seen);
    ASSERT_EQ(seen.all.size(), 1U);
    EXPECT_EQ(seen.all[0].other, ~4);  // the first arm
    // Corrections of first order: the arm turns by w t during the contact, and before it while it
    // closes the gap of 1e-5 m at the speed w far.
    const double slack = turn * far * (turn * seen.all[0].duration + 1e-5 / far);
    states("speed of approach [m/s]", seen.all[0].approach, turn * far, slack, "w r of the arm");
    states("speed of the ball [m/s]", norm(engine->balls()[0].velocity), (1 + e) * turn * far,
           (1 + e) * slack, "(1 + e) w r");
  }
}

TEST(StirredJar, what_the_stirrer_puts_in_is_stored_or_lost) {
  const geometry::Attritor jar = stirrer(40);
  const scene::Chamber chamber{jar, kinematics::Still{}, {}, {0, 0, -gravity}};
  const auto balls = random_balls_in(jar, 400);
  ASSERT_EQ(balls.size(), 400U);
  const auto engine = run_in(chamber, balls, pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, 0.4), 5e-6);
  Recorder seen;
  engine->advance(0.15, seen);
  const scene::EnergyBalance a = engine->energy_balance();
  EXPECT_GT(a.wall_work, 0.1);
  stays_below("balance over the stirrer's work", std::abs(a.residual()) / a.wall_work, 1e-3,
              "a hundredth of the step's share of a contact, squared (dem.26)");
  // A stirrer at rest does no work.
  const auto still = run_in({stirrer(0), kinematics::Still{}, {}, {0, 0, -gravity}}, balls,
                            pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, 0.4), 5e-6);
  still->advance(0.05, seen);
  states("work of walls at rest [J]", still->energy_balance().wall_work, 0, 0, "they do not move");
}

/// The stirrer turns back within 0.1 s to 0.2 s: s = 0.1 + 0.1 (u - 2 u^3 + u^4).
TEST(StirredJar, with_a_speed_over_time_has_its_clock_and_its_work_is_stored_or_lost) {
  constexpr double turn = 40;
  const kinematics::SpeedProgram program({{0, 1}, {0.1, 1}, {0.2, -1}});
  scene::Chamber chamber{stirrer(turn), kinematics::Still{}, {}, {0, 0, -gravity}};
  chamber.motion = kinematics::programmed(kinematics::AnyMotion(kinematics::Still{}), program);
  const auto wall = soft::moving_wall(chamber);
  for (const auto& [t, clock, rate] : {std::array{0.05, 0.05, 1.0},
                                       {0.125, 0.1 + 0.1 * (0.25 - 2 / 64. + 1 / 256.), 0.6875},
                                       {0.15, 0.13125, 0.0},
                                       {0.3, 0.0, -1.0}}) {
    const Vec3 arm = wall->axes(t).rotor * Vec3{1, 0, 0};
    states("x of an arm", arm.x, std::cos(turn * clock), 1e-12, "cos w s");
    states("y of an arm", arm.y, std::sin(turn * clock), 1e-12, "sin w s");
    soft::DriveSample sample;
    wall->sample_drive(t, 1, 0, {&sample, 1});
    states("spin of the stirrer [rad/s]", sample.rotor_spin.z, turn * rate, 1e-12, "w ds/dt");
  }
  const auto balls = random_balls_in(stirrer(turn), 400);
  const auto engine = run_in(chamber, balls, pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, 0.4), 5e-6);
  Recorder seen;
  engine->advance(0.25, seen);
  const scene::EnergyBalance a = engine->energy_balance();
  EXPECT_GT(a.wall_work, 0.05);
  stays_below("balance over the stirrer's work", std::abs(a.residual()) / a.wall_work, 1e-3,
              "as above");
}

void moves_few_and_many_alike(const scene::Chamber& chamber,
                              const std::vector<scene::Ball>& balls) {
  const contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, 0.4);
  const auto few = run_in(chamber, balls, pair, 5e-6, 1000);
  const auto crowd = run_in(chamber, balls, pair, 5e-6, 0);
  Recorder of_few, of_crowd;
  few->advance(0.05, of_few);
  crowd->advance(0.05, of_crowd);
  EXPECT_GT(of_few.all.size(), 100U);
  EXPECT_EQ(of_few.all.size(), of_crowd.all.size());
  double apart = 0;
  const auto one = few->balls(), other = crowd->balls();
  for (std::size_t i = 0; i < one.size(); ++i)
    apart = max_or_nan(apart, norm(one[i].position - other[i].position));
  stays_below("positions apart [m]", apart, 1e-9, "sums in another order, grown over 0.05 s");
}

TEST(StirredJar, few_balls_and_a_crowd_are_moved_alike) {
  const geometry::Attritor jar = stirrer(40);
  moves_few_and_many_alike({jar, kinematics::Still{}, {}, {0, 0, -gravity}},
                           random_balls_in(jar, 60));
}

TEST(LifterJar, few_balls_and_a_crowd_are_moved_alike) {
  geometry::LifterCylinder jar;
  jar.diameter = 0.1, jar.height = 0.05;
  jar.lifters = 12, jar.lifter_height = 0.008, jar.lifter_width = 0.01;
  jar.lifter_face_angle = 1.2;
  jar.complete();
  const Rotation mount = scene::mounted_along({1, 0, 0});
  std::vector<scene::Ball> balls = random_balls_in(jar, 120);
  for (scene::Ball& b : balls) b.position = mount * b.position;
  moves_few_and_many_alike({jar, kinematics::Tumbling{20}, mount, {0, 0, -gravity}}, balls);
}

}  // namespace
}  // namespace mahlwerk::tests::parts_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Results for whole mills: power by three routes, and the motion of the charge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::mill_power_test {
namespace {

/// A mill with balls so soft that half a minute is computed in a second.
cases::Case mill(const kinematics::AnyMotion& motion, const geometry::Cylinder& jar,
                 std::int64_t count, double diameter) {
  cases::Case c;
  c.mill.motion = motion;
  c.mill.jar_axis = std::visit([](const auto& m) { return m.jar_axis; }, motion);
  c.jar.shape = jar;
  c.jar.elastic = {20e6, 0.3};
  c.balls = {{count, diameter, 7850, "", {20e6, 0.3}}};
  c.contact.rule = {.restitution = 0.5, .tangential_restitution = 0, .friction = 0.7};
  c.contact.rolling_friction = 0.01;
  c.run.engine = cases::EngineName::soft;
  c.run.settle = 1;
  c.run.time = 5;
  c.observe.threshold = 0.1;
  return c;
}

constexpr double drum_radius = 0.05, ball = 0.01;  // [m]

/// A slice of a drum that turns at `share` of the speed at which a ball is pinned to the wall.
cases::Case drum(double share, std::int64_t count) {
  const double critical = std::sqrt(gravity / (drum_radius - 0.5 * ball));
  return mill(kinematics::Tumbling{share * critical}, {2 * drum_radius, 0.0125}, count, ball);
}

cases::Case planetary() {
  kinematics::Planetary motion;
  motion.orbit_radius = 0.07, motion.speed = 30, motion.ratio = -2;
  cases::Case c = mill(motion, {0.042, 0.0125}, 8, 0.006);
  c.run.settle = 0.2;
  c.run.time = 2;
  return c;
}

double named(const results::Outcome& outcome, const std::string& name) {
  const auto list = results::summarise(outcome).quantities;
  return std::ranges::find(list, name, &results::Quantity::name)->value;
}

/// What the charge stores meanwhile is the difference. The energy of the eight balls in the
/// planetary jar varies by 2.8 mJ, the dissipation is 0.28 W * 8 s. The ratio then varies by
/// sqrt(2) * 2.8 mJ / 2.2 J = 0.002 (measured in six runs of 2 s: 0.007), a fifth of the tolerance.
TEST(MillPower, drawn_is_dissipated) {
  for (const auto& [name, what] : {std::pair("drum", drum(0.7, 24)), {"planetary", planetary()}}) {
    cases::Case longer = what;
    longer.run.time *= 4;
    const results::Outcome outcome = campaign::run(longer);
    const double drawn = named(outcome, "drawn_power");
    states(std::string(name) + ": drawn over dissipated power",
           drawn / named(outcome, "dissipated_power"), 1, 0.01, "energy balance after settling");
    EXPECT_GT(named(outcome, "collision_rate"), 50) << name;
    states(std::string(name) + ": power_imbalance", named(outcome, "power_imbalance"),
           drawn / named(outcome, "dissipated_power") - 1, 1e-15, "drawn over dissipated, less 1");
  }
}

/// Moment of the charge's weight about the drum's axis, and angular momentum of the charge.
struct Turning {
  double weight = 0, momentum = 0;  // [N m], [N m s]
};
Turning turning_of(const std::vector<scene::Ball>& balls) {
  Turning sum;
  for (const scene::Ball& b : balls) {
    const Vec3 axis = kinematics::lying, m = b.mass() * Vec3{0, 0, -gravity};
    sum.weight += dot(axis, cross(b.position, m));
    sum.momentum += dot(axis, b.mass() * cross(b.position, b.velocity) + b.inertia() * b.spin);
  }
  return sum;
}

/// The shaft supports the charge: its torque equals the moment of the weight, except for the change
/// of the angular momentum.
TEST(MillPower, of_a_drum_is_speed_times_the_moment_of_the_weight) {
  const cases::Case mill_case = drum(0.7, 24);
  const auto engine = campaign::engine(mill_case, 0);
  Recorder recorder;
  engine->advance(1, recorder);
  const double work = engine->energy_balance().wall_work;
  const Turning begin = turning_of(engine->balls());
  constexpr int looks = 5000;
  constexpr double apart = 1e-3;  // [s]
  double moment = 0.5 * begin.weight;
  for (int i = 1; i <= looks; ++i) {
    engine->advance(1 + apart * i, recorder);
    moment += (i < looks ? 1 : 0.5) * turning_of(engine->balls()).weight;
  }
  const double of_shaft = turning_of(engine->balls()).momentum - begin.momentum - apart * moment;
  const double speed = std::get<kinematics::Tumbling>(*mill_case.mill.motion).speed;
  states("work of the shaft over that of the walls",
         speed * of_shaft / (engine->energy_balance().wall_work - work), 1, 1e-3,
         "angular momentum; the engine's balance closes to 1e-3");
  const results::Outcome outcome = campaign::run(mill_case);
  const double torque = named(outcome, "shaft_torque");
  states("shaft_torque over the mean moment of the weight", torque * looks / -moment, 1, 0.01,
         "angular momentum gained in 5 s is less than 1 %");
  const observe::Charge& charge = outcome.replicates[0].charge;
  double lever = 0;  // [kg m]
  const observe::PlaneField& field = charge.in_carrier;
  const double width = 2 * field.half() / observe::PlaneField::cells;
  for (int j = 0; j < observe::PlaneField::cells; ++j)
    for (int i = 0; i < observe::PlaneField::cells; ++i)
      lever += field.density(i, j) * field.cell_area() * ((i + 0.5) * width - field.half());
  states("moment of the density's weight over shaft_torque", gravity * std::abs(lever) / torque, 1,
         0.05, "looks at the charge, some hundred independent ones");
}

/// The lids are smooth, so that a slice moves like a long drum.
cases::Case between_smooth_lids(cases::Case c, double friction, double rolling) {
  c.contact.rule.restitution = 0.3;
  c.contact.rule.friction = friction;
  c.contact.rolling_friction = rolling;
  contact::BounceRule smooth = c.contact.rule;
  smooth.friction = 0;
  c.contact.pairs = {{{"balls", "jar.bottom"}, smooth}, {{"balls", "jar.top"}, smooth}};
  return c;
}

TEST(Regime, a_slow_drum_cascades) {
  cases::Case mill_case = between_smooth_lids(drum(0.3, 30), 0.5, 0.01);
  mill_case.run.time = 3;
  const results::Outcome slow = campaign::run(mill_case);
  std::printf("    %s\n", results::regime_reason(slow).c_str());
  EXPECT_EQ(results::regime(slow), "cascading");
  EXPECT_LT(named(slow, "toe_angle"), 0) << "the charge lies about the lowest point";
  EXPECT_GT(named(slow, "shoulder_angle"), 30) << "and is carried up";
  EXPECT_LT(named(slow, "shoulder_angle"), 120);
  stays_below("mass in the emptiest sector", named(slow, "emptiest_sector"), 0.1, "a free surface");
}

/// Rotation presses a ball on the wall with F = 1.21 times its weight. To neither slide nor roll,
/// the ball needs a friction of sin t/(F + cos t) at the angle t from the lowest point, at most
/// 1/sqrt(F^2 - 1) = 1.47.
TEST(Regime, a_fast_drum_whose_friction_holds_the_balls_centrifuges) {
  cases::Case mill_case = between_smooth_lids(drum(1.1, 15), 2, 2);
  mill_case.run.settle = 3;
  mill_case.run.time = 1;
  const results::Outcome fast = campaign::run(mill_case);
  std::printf("    %s\n", results::regime_reason(fast).c_str());
  EXPECT_EQ(results::regime(fast), "centrifuging");
  states("Froude number", named(fast, "froude_number"), 1.21, 1e-12, "1.1 of the critical speed");
  stays_below("slip of the balls at the wall", named(fast, "wall_slip_ratio"), 0.02,
              "they turn with it");
  mill_case.contact.rule.friction = mill_case.contact.rolling_friction = 0.9;
  EXPECT_NE(results::regime(campaign::run(mill_case)), "centrifuging") << "less than 1.47";
}

}  // namespace
}  // namespace mahlwerk::tests::mill_power_test

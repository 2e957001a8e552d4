// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Hollow and coated balls in the event engine: mass, moment of inertia, and what follows from it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/ball_layers.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::hollow_balls_test {
namespace {

constexpr double r = 0.004;
constexpr std::array ratios{0.4, 0.5, 2.0 / 3};

scene::Ball ball_with(double ratio, const Vec3& position = {}, const Vec3& velocity = {},
                      const Vec3& spin = {}) {
  scene::Ball ball = ball_a(position, velocity, spin);
  ball.inertia_ratio = ratio;
  return ball;
}

/// Mass and moment of inertia of a sphere of layers, by the midpoint rule over its radius.
struct Moments {
  double mass = 0, inertia = 0;
};
Moments integrated(const scene::BallLayers& layers, double radius) {
  constexpr int steps = 1'000'000;
  const double core = radius - layers.coating_thickness,
               hole = layers.wall_thickness ? core - *layers.wall_thickness : 0;
  Moments m;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * radius / steps;
    const double density = x < hole ? 0 : x < core ? layers.density : layers.coating_density;
    const double shell = 4 * std::numbers::pi * x * x * density * radius / steps;
    m.mass += shell;
    m.inertia += 2.0 / 3 * shell * x * x;
  }
  return m;
}

TEST(HollowBalls, mass_and_inertia_are_the_integrals_over_their_layers) {
  using Layers = scene::BallLayers;
  for (const Layers& layers :
       {Layers{7850, {}, 0, 0}, Layers{7850, 0.001, 0, 0}, Layers{7850, {}, 0.0005, 15000},
        Layers{7850, 0.0015, 0.001, 2000}}) {
    const Moments m = integrated(layers, r);
    scene::Ball ball{r, layers.mean_density(r), {}, {}, {}};
    ball.inertia_ratio = layers.inertia_ratio(r);
    // A layer boundary inside a step of the rule: relative error of 3/steps or 5/steps at most.
    states("mass [kg]", ball.mass(), m.mass, 1e-5 * m.mass, "integral");
    states("I [kg m2]", ball.inertia(), m.inertia, 1e-5 * m.inertia, "integral");
  }
}

TEST(HollowBalls, inertia_ratio_goes_from_two_fifths_to_two_thirds) {
  const auto ratio = [](double wall) {
    return scene::BallLayers{7850, wall, 0, 0}.inertia_ratio(r);
  };
  states("solid", scene::BallLayers{7850, {}, 0, 0}.inertia_ratio(r), 0.4, 0, "2/5");
  states("almost solid", ratio(0.999 * r), 0.4, 1e-8, "2/5");
  // 2/5 (1 - q^5)/(1 - q^3) = 2/3 (1 - t + ...) for q = 1 - t.
  states("shell of a thousandth", ratio(1e-3 * r), 2.0 / 3 * (1 - 1e-3), 1e-6, "2/3 (1 - t/R)");
  states("shell of a half", ratio(0.5 * r), 0.4 * (31.0 / 32) / (7.0 / 8), 1e-15,
         "2/5 (1 - 1/32)/(1 - 1/8)");
}

/// Throws a ball onto the floor of a wide box at rest without gravity.
scene::Ball after_one_bounce(double ratio, const contact::BounceRule& rule, const Vec3& velocity,
                             const Vec3& spin, scene::EnergyBalance* balance = nullptr) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {0, 0, 0}};
  event::Rules rules;
  rules.bounce = rule;
  const auto engine =
      event::one_ball(still, ball_with(ratio, {0, 0, -1 + r + 1e-3}, velocity, spin), rules);
  Recorder recorder;
  engine->advance(1.5e-3 / -velocity.z, recorder);
  EXPECT_EQ(recorder.all.size(), 1U);
  if (balance != nullptr) *balance = engine->energy_balance();
  return engine->balls().front();
}

TEST(HollowBalls, sliding_ball_that_sticks_in_a_bounce_keeps_one_over_one_plus_k) {
  for (const double k : ratios) {
    const scene::Ball b = after_one_bounce(k, {0.5, 0, INFINITY}, {1, 0, -1}, {});
    states(fmt::format("v_x after, k = {:.3f} [m/s]", k), b.velocity.x, 1 / (1 + k), 1e-15,
           "1/(1 + k): 5/7 solid, 3/5 thin shell");
    states("  w R after [m/s]", r * b.spin.y, 1 / (1 + k), 1e-14, "it rolls");
    states("  inertia ratio told", b.inertia_ratio, k, 0, "as given");
  }
}

TEST(HollowBalls, slip_is_reduced_to_e_t_of_itself_and_energy_closes) {
  for (const double k : ratios)
    for (const double e_t : {1.0, 0.3, -0.4, -1.0}) {
      const Vec3 velocity{0.7, -0.4, -1.2}, spin{30, -50, 80};
      scene::EnergyBalance balance;
      const scene::Ball b = after_one_bounce(k, {0.9, e_t, INFINITY}, velocity, spin, &balance);
      const Vec3 n{0, 0, -1};
      const auto slip = [&](const Vec3& v, const Vec3& w) {
        return tangential_part(v + r * cross(w, n), n);
      };
      const std::string at = fmt::format(", k = {:.3f}, e_t = {}", k, e_t);
      states("slip after" + at + " [m/s]",
             norm(slip(b.velocity, b.spin) - e_t * slip(velocity, spin)), 0, 1e-15, "e_t");
      states("  residual over energy", balance.residual() / balance.initial_energy, 0, 1e-14,
             "energy balance with k m R^2 w^2/2");
    }
}

/// Rules with which a ball that falls by a micrometre enters a sustained contact at once.
event::Rules staying(double mu) {
  event::Rules rules;
  rules.bounce = {0, 1, mu};
  rules.sustained_friction = mu;
  return rules;
}

TEST(HollowBalls, sliding_turns_into_rolling_at_one_over_one_plus_k) {
  const double mu = 0.2, u0 = 0.5;
  const scene::Chamber box{geometry::Cylinder{4, 2}, kinematics::Still{}, {}, {0, 0, -gravity}};
  for (const double k : ratios) {
    const double stops = u0 / ((1 + 1 / k) * mu * gravity);
    const auto engine =
        event::one_ball(box, ball_with(k, {0, 0, -1 + r + 1e-12}, {u0, 0, 0}), staying(mu));
    Recorder recorder;
    engine->advance(0.9 * stops, recorder);
    const double t = engine->energy_balance().time;
    states(fmt::format("speed while sliding, k = {:.3f} [m/s]", k),
           engine->balls().front().velocity.x, u0 - mu * gravity * t, 1e-6,
           "u0 - mu g t; contact begins 5e-7 s late");
    states("  spin while sliding [m/s]", r * engine->balls().front().spin.y, mu * gravity * t / k,
           3e-6, "mu g t/k");
    engine->advance(2 * stops, recorder);
    const scene::Ball b = engine->balls().front();
    // Sliding ends when the slip is below 1e-4 m/s.
    states("  speed in the end [m/s]", b.velocity.x, u0 / (1 + k), 1e-4, "u0/(1 + k)");
    states("  it rolls: v - w R [m/s]", b.velocity.x - r * b.spin.y, 0, 1e-12, "no slip");
    const scene::EnergyBalance a = engine->energy_balance();
    states("  energy lost by sliding [J]", a.lost(), 0.5 * b.mass() * k / (1 + k) * u0 * u0, 1e-9,
           "1/2 k/(1 + k) m u0^2");
  }
}

TEST(HollowBalls, roll_down_an_incline_at_g_sin_over_one_plus_k) {
  const double slope = 0.2;  // [rad]
  const scene::Chamber box{geometry::Cylinder{4, 2},
                           kinematics::Still{},
                           {},
                           {gravity * std::sin(slope), 0, -gravity * std::cos(slope)}};
  for (const double k : ratios) {
    const auto engine = event::one_ball(box, ball_with(k, {0, 0, -1 + r + 1e-12}), staying(0.5));
    Recorder recorder;
    engine->advance(0.3, recorder);
    const double t = engine->energy_balance().time;
    states(fmt::format("speed, k = {:.3f} [m/s]", k), engine->balls().front().velocity.x,
           gravity * std::sin(slope) / (1 + k) * t, 1e-5, "g sin(a) t/(1 + k)");
    states("  residual over energy",
           engine->energy_balance().residual() / engine->energy_balance().kinetic, 0, 1e-9,
           "energy balance");
  }
}

/// A solid ball and a shell of another mass meet obliquely in the engine for many balls.
TEST(HollowBalls, slip_of_two_different_balls_is_reduced_to_e_t_of_itself) {
  for (const double e_t : {0.5, 0.0, -0.7}) {
    scene::Ball a = ball_with(0.4, {-0.01, 0, 0}, {1, 0.2, 0}, {0, 40, -90}),
                b = ball_with(2.0 / 3, {0.01, 0.003, 0}, {-0.5, 0, 0.1}, {10, 0, 30});
    b.density = 2000;
    const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {0, 0, 0}};
    event::Rules rules;
    rules.sustained_mode = event::SustainedContactMode::none;
    const auto engine =
        event::many_balls(still, {a, b}, rules, contact::BounceTable(1, 3, {0.8, e_t, INFINITY}));
    Recorder recorder;
    engine->advance(0.02, recorder);
    ASSERT_EQ(recorder.all.size(), 1U);
    const auto after = engine->balls();
    const Vec3 n = recorder.all[0].normal;
    const auto slip = [&](const scene::Ball& i, const scene::Ball& j) {
      return tangential_part(i.velocity - j.velocity + r * cross(i.spin + j.spin, n), n);
    };
    states(fmt::format("slip after, e_t = {} [m/s]", e_t),
           norm(slip(after[0], after[1]) - e_t * slip(a, b)), 0, 1e-14, "e_t");
    const scene::EnergyBalance balance = engine->energy_balance();
    states("  residual over energy", balance.residual() / balance.initial_energy, 0, 1e-14,
           "energy balance");
    states("  inertia ratio told", after[1].inertia_ratio, 2.0 / 3, 0, "as given");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::hollow_balls_test

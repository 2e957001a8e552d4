// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Capillary bridges: force, rupture and the energy that they take.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::capillary_test {
namespace {

using contact::Capillary;
using contact::EffectivePair;

constexpr double water = 0.0728;  // [N/m]
constexpr double radius = 0.001, angle = 0.4;

contact::Pair wet_pair(double e = 1, double mu = 0) {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, e, mu);
  pair.surface_tension = water;
  return pair;
}
Capillary law_of(double volume, double theta = angle) {
  Capillary law;
  law.bridge_volume = volume;
  law.contact_angle = theta;
  return law;
}
scene::Ball ball_of(double speed = 0, double r = radius) {
  return {r, 2500, {}, {0, 0, -speed}, {}};
}
/// Attraction at a gap, from the law itself.
double attraction(const Capillary& law, const EffectivePair& t, double gap) {
  const auto k = law.coefficients(t, 0);
  double m[contact::law_history_size] = {};
  return -Capillary::evaluate<double>(k.data(), m, -gap, 0).force;
}

TEST(Capillary, force_at_touch_is_2_pi_R_gamma_cos_theta_and_twice_it_at_a_wall) {
  const contact::Pair pair = wet_pair();
  const double one = 2 * std::numbers::pi * radius * water * std::cos(angle);
  states("two equal balls [N]",
         attraction(law_of(1e-12), touching(pair, std::vector{ball_of(), ball_of()}), 0), one,
         1e-15, "Willett et al. 2000");
  states("ball and wall [N]", attraction(law_of(1e-12), touching(pair, ball_of()), 0), 2 * one,
         1e-15, "Derjaguin's radius 2 R* = 2 R");
  states("balls of radius 1 and 3 mm [N]",
         attraction(law_of(1e-12), touching(pair, std::vector{ball_of(), ball_of(0, 0.003)}), 0),
         1.5 * one, 1e-15, "2 R_1 R_2/(R_1 + R_2) = 1.5 mm");
}

/// A bridge that holds a ball which slides past stores no slip: the ball, which comes back, loses
/// by sliding no more than it loses across the normal.
TEST(Capillary, slip_of_a_bridge_across_a_gap_is_no_loss_of_the_next_touch) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const scene::Chamber box = still_box(0.1, {0, 0, -gravity});
    scene::Ball ball = ball_of();
    ball.position.z = -0.05 + radius + 2e-5;  // within the reach of the bridge
    ball.velocity = {1, 0, -0.02};
    const auto engine = soft::make_engine(box, {ball}, {of_law(law_of(1e-11)), 8e-6, false, few},
                                          contact::PairTable(1, 6, wet_pair(0.9, 0.3)));
    Recorder none;
    engine->advance(0.004, none);
    const scene::EnergyBalance energy = engine->energy_balance();
    EXPECT_GT(energy.lost_tangential + energy.lost_open, 0);
    stays_below(few == 0 ? "sliding over all losses, many" : "sliding over all losses, few",
                energy.slid / energy.lost(), 1, "sliding is part of the losses");
  }
}

TEST(Capillary, a_bridge_to_the_wall_that_is_longer_than_a_radius_stores_its_energy) {
  Capillary law = law_of(1e-12);
  law.bridge_volume = 0, law.bridge_ratio = 0.1;
  const contact::Pair pair = wet_pair();
  const EffectivePair t = touching(pair, ball_of());
  ASSERT_GT(law.pull_off_distance(t), 1.1 * radius);
  const auto coefficients = law.coefficients(t, 0);
  const double none[2] = {};
  scene::Ball ball = ball_of();
  ball.position.z = -0.05 + radius + 1e-6;
  ball.velocity = {0, 0, -1};
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const auto engine = soft::make_engine(still_box(0.1), {ball}, {of_law(law), 1e-6, false, few},
                                          contact::PairTable(1, 6, pair), 0);
    Recorder recorder;
    double gap = 0;
    for (double time = 0; gap < 1.05 * radius && time < 0.01;) {
      engine->advance(time += 1e-5, recorder);
      gap = engine->balls()[0].position.z + 0.05 - radius;
    }
    ASSERT_LT(gap, law.pull_off_distance(t));
    const double expected = law.elastic_energy(coefficients, none, -gap);
    states(fmt::format("stored at {:.3g} m, {} balls [J]", gap, few == 0 ? "many" : "few"),
           engine->energy_balance().elastic, expected, 1e-9 * expected, "the law's own energy");
  }
}

/// The closed form by the half-separation S of the paper: 1 + 2.1 S+ + 10 S+^2, S+ = S (R/V)^(1/2).
TEST(Capillary, force_falls_with_the_gap_as_willetts_closed_form) {
  const EffectivePair t = touching(wet_pair(), std::vector{ball_of(), ball_of()});
  constexpr double volume = 1e-12;  // V/R^3 = 0.001
  for (const double gap : {1e-6, 1e-5, 5e-5, 1e-4}) {
    const double half = 0.5 * gap * std::sqrt(radius / volume);
    states(fmt::format("F over F_0 at {} m", gap),
           attraction(law_of(volume), t, gap) / attraction(law_of(volume), t, 0),
           1 / (1 + 2.1 * half + 10 * half * half), 1e-14, "Willett et al. 2000, eq. 12");
  }
}

TEST(Capillary, volume_by_ratio_is_that_of_the_radius_2_R_star) {
  Capillary law;
  law.bridge_ratio = 0.002;
  const EffectivePair t = touching(wet_pair(), std::vector{ball_of(), ball_of()});
  states("V [m3]", law.volume(t), 0.002 * radius * radius * radius, 1e-26, "ratio R^3");
}

/// Work to break a bridge: the integral of F from touch to rupture, by Simpson's rule.
double work_of_rupture(const Capillary& law, const EffectivePair& t) {
  constexpr int steps = 2000;
  const double h = law.pull_off_distance(t) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i)
    sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * attraction(law, t, i * h);
  return sum * h / 3;
}

TEST(Capillary, elastic_energy_is_the_work_of_the_bridge) {
  const EffectivePair t = touching(wet_pair(), ball_of());
  for (const double volume : {1e-13, 1e-12, 1e-11}) {
    const Capillary law = law_of(volume);
    const double work = work_of_rupture(law, t);
    states(fmt::format("stored at rupture over work, V = {} m3", volume),
           law.elastic_energy(law.coefficients(t, 0), nullptr, -law.pull_off_distance(t)) / work, 1,
           1e-10, "integral of F");
  }
}

/// Rebound of elastic bodies: what is lost is the work of rupture, independent of speed.
TEST(Capillary, collision_loses_the_work_of_rupture_and_slow_balls_stick) {
  const contact::Pair pair = wet_pair();
  for (const bool wall : {true, false}) {
    std::vector<scene::Ball> balls{ball_of()};
    if (!wall) balls.push_back(ball_of());
    const EffectivePair t = touching(pair, balls);
    const Capillary law = law_of(1e-12);
    const double work = work_of_rupture(law, t), sticking = std::sqrt(2 * work / t.mass);
    for (const double faster : {0.95, 1.1, 1.5, 3.0, 10.0}) {
      const double speed = faster * sticking;
      balls[0].velocity = wall ? Vec3{0, 0, -speed} : Vec3{speed, 0, 0};
      const Impact found = impact(balls, pair, of_law(law), 1.0 / 500);
      const std::string at =
          fmt::format("at {} of the sticking speed, {}", faster, wall ? "wall" : "two balls");
      if (faster < 1) {
        states("collisions ended " + at, static_cast<double>(found.energy_balance.collisions), 0, 0,
               "the bridge holds");
        continue;
      }
      const double energy = 0.5 * t.mass * speed * speed;
      // Jumps of the force at touch and rupture are placed within a step to second order; the rest
      // is the time step squared.
      states("lost over work of rupture " + at, found.record.lost_normal / work, 1,
             2e-3 * energy / work, "work of the bridge");
      states("  residual over energy", found.energy_balance.residual() / energy, 0, 2e-3,
             "energy balance");
      states("  e", found.restitution, std::sqrt(1 - 1 / (faster * faster)), 3e-3,
             "sqrt(1 - (v_s/v)^2)");
    }
  }
}

TEST(Capillary, bridge_forms_at_touch_and_ruptures_at_lians_distance) {
  const contact::Pair pair = wet_pair();
  const Capillary law = law_of(1e-12);
  const double distance = (1 + 0.5 * angle) * 1e-4;
  states("rupture distance [m]", law.pull_off_distance(touching(pair, ball_of())), distance, 1e-17,
         "(1 + theta/2) V^(1/3), Lian et al. 1993");
  const double side = 0.04;
  // Towards the wall, but never touching: no force within the rupture distance.
  for (const bool touches : {false, true}) {
    scene::Ball ball = ball_of(0.1);
    ball.position.z = -0.5 * side + radius + (touches ? 1e-6 : 0.5 * distance);
    if (!touches) ball.velocity = {0.05, 0, 0};
    const double step = law.shortest_time(touching(pair, ball), 0.1) / 500;
    const auto engine = soft_engine(still_box(side), {ball}, of_law(law), pair, step);
    Recorder recorder;
    double last_gap = 0, time = 0;
    bool ended = false;
    while (time < 0.004 && !ended) {
      time += step;
      engine->advance(time, recorder);
      ended = !recorder.all.empty();
      if (!ended) last_gap = engine->balls()[0].position.z + 0.5 * side - radius;
    }
    if (touches)
      states("gap at the end of the contact [m]", last_gap, distance, 2 * 0.1 * step,
             "Lian et al. 1993, two steps");
    else
      states("speed of a near miss [m/s]", engine->balls()[0].velocity.z, 0, 0,
             "a bridge forms at touch");
  }
}

TEST(Capillary, dry_pair_collides_as_with_hertz_and_mindlin) {
  contact::Pair pair = wet_pair(0.7, 0.3);
  pair.surface_tension = 0;
  scene::Ball ball = ball_of(1);
  ball.velocity.x = 0.4;
  const Impact dry = impact({ball}, pair, of_law(Capillary{}), 1.0 / 50),
               plain = impact({ball}, pair, of_law(contact::HertzMindlin{}), 1.0 / 50);
  states("v_z [m/s]", dry.after[0].velocity.z, plain.after[0].velocity.z, 0, "same bits");
  states("v_x [m/s]", dry.after[0].velocity.x, plain.after[0].velocity.x, 0, "same bits");
  states("spin [rad/s]", dry.after[0].spin.y, plain.after[0].spin.y, 0, "same bits");
}

}  // namespace
}  // namespace mahlwerk::tests::capillary_test

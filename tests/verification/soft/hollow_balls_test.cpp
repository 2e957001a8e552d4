// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Hollow balls in the soft engine: what follows from their moment of inertia.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::soft_hollow_balls_test {
namespace {

using contact::HertzMindlin;

constexpr double radius = 0.005;
constexpr std::array ratios{0.4, 0.5, 2.0 / 3};
constexpr contact::ElasticConstants glass{1e8, 0.25};

scene::Ball ball_with(double ratio, const Vec3& position, const Vec3& velocity) {
  scene::Ball ball{radius, 2500, position, velocity, {}};
  ball.inertia_ratio = ratio;
  return ball;
}

/// Runs a ball that lies on the floor of a box, pressed by `pull` [m/s2].
std::unique_ptr<scene::Engine> on_floor(double ratio, const Vec3& velocity, const Vec3& pull,
                                        double mu, contact::Rolling rolling, double mu_r = 0) {
  constexpr double side = 1;
  contact::Pair pair = pair_of(glass, glass, 0.5, mu);
  pair.rolling_friction = mu_r;
  const scene::Ball ball = ball_with(ratio, {-0.4, 0, -0.5 * side + radius}, velocity);
  const double step = soft::time_steps({ball}, HertzMindlin{}, contact::PairTable(1, 6, pair), 0.5)
                          .recommended(0.125, 50);
  return soft_engine(still_box(side, pull), {ball}, of_law(HertzMindlin{}, rolling), pair, step);
}

TEST(SoftHollowBalls, sliding_ball_rolls_in_the_end_at_one_over_one_plus_k) {
  const double u0 = 0.5, mu = 0.2;
  for (const double k : ratios) {
    const auto engine = on_floor(k, {u0, 0, 0}, {0, 0, -gravity}, mu, contact::Rolling::none);
    Recorder none;
    engine->advance(3 * u0 / ((1 + 1 / k) * mu * gravity), none);
    const scene::Ball b = engine->balls()[0];
    // The ball settles by its weight at the start, d = 4 um: while it oscillates, the friction is
    // that of the mean force, m g, to the few per cent of the first of 150 oscillations.
    states(fmt::format("speed in the end, k = {:.3f} [m/s]", k), b.velocity.x, u0 / (1 + k),
           5e-4 * u0, "u0/(1 + k)");
    // It rolls on the circle of its centre over the contact, less the overlap: d/R = 8e-4.
    states("  w R over v", radius * b.spin.y / b.velocity.x, 1, 2e-3, "no slip");
    const scene::EnergyBalance a = engine->energy_balance();
    states("  lost across [J]", a.lost_tangential, 0.5 * b.mass() * k / (1 + k) * u0 * u0,
           5e-3 * 0.5 * b.mass() * u0 * u0, "1/2 k/(1 + k) m u0^2");
    stays_below("  residual over lost", std::abs(a.residual()) / a.lost(), 1e-3, "energy balance");
  }
}

TEST(SoftHollowBalls, roll_down_an_incline_at_g_sin_over_one_plus_k) {
  const double slope = 0.2;  // [rad]
  const Vec3 pull{gravity * std::sin(slope), 0, -gravity * std::cos(slope)};
  for (const double k : ratios) {
    const auto engine = on_floor(k, {}, pull, 0.5, contact::Rolling::none);
    Recorder none;
    engine->advance(0.2, none);
    const double from = engine->balls()[0].velocity.x, t = engine->energy_balance().time;
    engine->advance(0.4, none);
    const double a = (engine->balls()[0].velocity.x - from) / (engine->energy_balance().time - t);
    const double expected = gravity * std::sin(slope) / (1 + k);
    states(fmt::format("acceleration, k = {:.3f} [m/s2]", k), a, expected, 2e-3 * expected,
           "g sin(a)/(1 + k), overlap over radius 1e-3");
  }
}

/// Below gross slip the tangential contact is elastic: of a spring with k_t = const it would be
/// e_t = -1 or so; the closed form here is momentum: L = I w + m R v_x about the contact is kept.
TEST(SoftHollowBalls, oblique_impact_keeps_the_angular_momentum_about_the_contact) {
  for (const double k : ratios)
    for (const double slip : {0.2, 2.0}) {
      const contact::Pair pair = pair_of(glass, glass, 0.8, 0.3);
      const Impact found =
          impact({ball_with(k, {}, {slip, 0, -1})}, pair, of_law(HertzMindlin{}), 1.0 / 200);
      const scene::Ball &b = found.before[0], &a = found.after[0];
      const double change = a.mass() * (b.velocity.x - a.velocity.x);
      // The lever is the radius less the overlap, 0.03 R at most.
      states(fmt::format("I w over R times impulse across, k = {:.3f}, slip {}", k, slip),
             a.inertia() * a.spin.y / (radius * change), 1, 0.03, "angular momentum");
      states("  residual over energy",
             found.energy_balance.residual() / (0.5 * b.mass() * squared(b.velocity)), 0, 1e-3,
             "energy balance");
    }
}

/// With gross slip the impulse across is mu times that along.
TEST(SoftHollowBalls, spin_after_gross_slip_is_that_of_coulombs_impulse_over_k) {
  const double mu = 0.1, e = 0.8;
  for (const double k : ratios) {
    const contact::Pair pair = pair_of(glass, glass, e, mu);
    const Impact found =
        impact({ball_with(k, {}, {5, 0, -0.2})}, pair, of_law(HertzMindlin{}), 1.0 / 200);
    const double expected = mu * (1 + e) * 0.2 / (k * radius);
    states(fmt::format("spin, k = {:.3f} [rad/s]", k), found.after[0].spin.y, expected,
           0.01 * expected, "mu (1 + e) v/(k R); lever less by the overlap, 0.7 %");
  }
}

/// The tangential spring of a contact without slip oscillates at w^2 = (1 + 1/k) k_t/m.
TEST(SoftHollowBalls, tangential_oscillation_has_the_slip_factor_of_the_ball) {
  const double pressing = 1000;  // [m/s2]
  for (const double k : ratios) {
    contact::Pair pair = pair_of(glass, glass, 1, INFINITY);
    const scene::Ball ball = ball_with(k, {}, {});
    const contact::EffectivePair t = touching(pair, ball);
    const double overlap = std::pow(ball.mass() * pressing / contact::hertz_stiffness(t), 2.0 / 3);
    scene::Ball resting = ball;
    resting.position = {0, 0, -0.5 + radius - overlap};
    resting.velocity = {1e-4, 0, 0};
    const double lever = radius - overlap;
    const double inverse_mass = 1 / ball.mass() + lever * lever / ball.inertia();
    const double w = std::sqrt(contact::mindlin_stiffness(t) * std::sqrt(overlap) * inverse_mass);
    const double period = 2 * std::numbers::pi / w;
    const auto engine = soft_engine(still_box(1, {0, 0, -pressing}), {resting},
                                    of_law(HertzMindlin{}), pair, period / 200);
    Recorder none;
    // Slip of the contact: passes zero twice per period.
    const auto slip = [&] {
      const scene::Ball b = engine->balls()[0];
      return b.velocity.x - lever * b.spin.y;
    };
    double last = slip(), time = 0, first = 0, end = 0;
    int passes = 0;
    while (passes < 41) {
      time += period / 200;
      engine->advance(time, none);
      const double now = slip();
      if (last * now < 0) {
        const double at = engine->energy_balance().time - period / 200 * now / (now - last);
        if (passes++ == 0) first = at;
        end = at;
      }
      last = now;
    }
    states(fmt::format("period over expected, k = {:.3f}", k), (end - first) / 20 / period, 1, 1e-4,
           "w^2 = k_t (1/m + l^2/I), (dem.37) corrects the step");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::soft_hollow_balls_test

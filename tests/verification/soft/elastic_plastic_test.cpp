// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Elastic-plastic collisions: restitution over speed against Thornton's closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::elastic_plastic_test {
namespace {

using contact::EffectivePair;
using contact::ThorntonNing;

constexpr contact::ElasticConstants steel{208e9, 0.3};
constexpr double p_y = 3e9;  // [Pa]

ThorntonNing law_of(double pressure = p_y) {
  ThorntonNing law;
  law.yield_pressure = pressure;
  return law;
}
scene::Ball ball_of(double speed, double radius = 0.005) {
  return {radius, 7850, {}, {0, 0, -speed}, {}};
}

/// Thornton (1997): restitution over V_y/V, written out here a second time.
double thornton(double ratio) {
  if (ratio >= 1) return 1;
  const double r2 = ratio * ratio;
  return std::sqrt(6 * std::sqrt(3) / 5) * std::sqrt(1 - r2 / 6) *
         std::pow(ratio / (ratio + 2 * std::sqrt(6.0 / 5 - r2 / 5)), 0.25);
}
/// V_y = (pi/(2 E*))^2 (8 pi R*^3/(15 m*))^(1/2) p_y^(5/2) (Thornton 1997).
double yield_speed(const EffectivePair& t, double pressure) {
  return std::pow(0.5 * std::numbers::pi / t.pair.modulus, 2) *
         std::sqrt(8 * std::numbers::pi * std::pow(t.radius, 3) / (15 * t.mass)) *
         std::pow(pressure, 2.5);
}

TEST(ElasticPlastic, yield_speed_is_that_of_thornton) {
  for (const double radius : {1e-4, 0.005, 0.02}) {
    const EffectivePair t = touching(pair_of(steel, steel, 1), ball_of(1, radius));
    const double expected = yield_speed(t, p_y);
    states(fmt::format("V_y at R {} m [m/s]", radius), law_of().yield_speed(t), expected,
           1e-13 * expected, "Thornton 1997");
  }
}

/// Steps of a two-hundredth of the unloading. The first and last step of a collision, and the time
/// at which the overlap is largest, are known to one step; (1/200)^2 with a factor of the curvature
/// of F at yield, 10, is 2.5e-4.
constexpr double share = 1.0 / 200, stepping = 2.5e-4;

TEST(ElasticPlastic, restitution_over_speed_is_thorntons_from_below_yield_to_a_hundred_times) {
  const contact::Pair pair = pair_of(steel, steel, 1);
  for (const bool wall : {true, false})
    for (const double ratio : {0.1, 0.5, 0.99, 1.01, 1.2, 2.0, 5.0, 10.0, 30.0, 100.0}) {
      std::vector<scene::Ball> balls{ball_of(1)};
      if (!wall) balls.push_back(ball_of(0, 0.003));
      const double speed = ratio * yield_speed(touching(pair, balls), p_y);
      balls[0].velocity = wall ? Vec3{0, 0, -speed} : Vec3{speed, 0, 0};
      for (const double phase : {0.1, 0.6}) {
        const Impact found = impact(balls, pair, of_law(law_of()), share, phase);
        states(fmt::format("e at {} V_y, {}", ratio, wall ? "ball on wall" : "two balls"),
               found.restitution, thornton(1 / ratio), stepping, "Thornton 1997");
        states("  residual over energy",
               found.energy_balance.residual() / found.record.energy_normal(), 0, stepping,
               "energy balance");
        states("  lost over energy", found.record.lost_normal / found.record.energy_normal(),
               1 - thornton(1 / ratio) * thornton(1 / ratio), 2 * stepping, "1 - e^2");
      }
    }
}

TEST(ElasticPlastic, restitution_falls_with_the_fourth_root_of_the_speed_in_the_end) {
  const contact::Pair pair = pair_of(steel, steel, 1);
  const double v = yield_speed(touching(pair, ball_of(1)), p_y);
  const auto e = [&](double ratio) {
    return impact({ball_of(ratio * v)}, pair, of_law(law_of()), share).restitution;
  };
  // (1.18.. (V_y/V)^(1/4)) (1 - (V_y/V)/(16 sqrt(6/5)) ...): at 50 and 100, the exponent is off by
  // (1/50 - 1/100)/(16 sqrt(6/5) ln 2) < 1e-3.
  states("exponent of e between 50 and 100 V_y", std::log(e(100) / e(50)) / std::log(2), -0.25,
         2e-3, "e -> 1.185 (V_y/V)^(1/4), Thornton 1997");
}

TEST(ElasticPlastic, restitution_given_is_that_below_yield_and_the_plastic_loss_adds_above) {
  for (const double e : {0.5, 0.9}) {
    const contact::Pair pair = pair_of(steel, steel, e);
    const double v = yield_speed(touching(pair, ball_of(1)), p_y);
    states(fmt::format("e at 0.5 V_y, {} given", e),
           impact({ball_of(0.5 * v)}, pair, of_law(law_of()), share).restitution, e, 1e-3,
           "viscous below yield");
    const double above = impact({ball_of(10 * v)}, pair, of_law(law_of()), share).restitution;
    stays_below(fmt::format("e at 10 V_y, {} given", e), above, std::min(e, thornton(0.1)),
                "both losses");
    stays_below(fmt::format("product of both at 10 V_y, {} given", e), e * thornton(0.1), above,
                "damping leaves less to yield");
  }
}

TEST(ElasticPlastic, yield_pressure_follows_from_the_hardness_of_the_softer_body) {
  contact::Pair pair = pair_of(steel, steel, 1);
  pair.hardness = 5.6e9;
  const EffectivePair t = touching(pair, ball_of(1));
  states("p_y [Pa]", law_of(0).yield_pressure_of(t), 3.2e9, 1, "1.6 Y, Y = H/2.8");
  states("p_y [Pa], given", law_of().yield_pressure_of(t), p_y, 0, "as given");
}

TEST(ElasticPlastic, yield_speed_is_the_same_with_softer_moduli) {
  contact::Pair pair = pair_of(steel, steel, 1);
  pair.hardness = 5.6e9;
  const double hard = law_of(0).yield_speed(touching(pair, ball_of(1)));
  for (const double softening : {0.1, 1e-3}) {
    contact::Pair soft = pair;
    soft.modulus *= softening;
    soft.softening = softening;
    states(fmt::format("V_y with softening {} [m/s]", softening),
           law_of(0).yield_speed(touching(soft, ball_of(1))), hard, 1e-12 * hard,
           "p_y times softening^(4/5)");
  }
}

TEST(ElasticPlastic, unloading_and_reloading_follow_one_curve_and_loading_goes_on_beyond) {
  const EffectivePair t = touching(pair_of(steel, steel, 1), ball_of(1));
  const ThorntonNing law = law_of();
  const auto k = law.coefficients(t, law.damping(1));
  const double d_y = law.yield_overlap(t), most = 20 * d_y;
  double m[contact::law_history_size] = {};
  const auto force = [&](double d) {
    return ThorntonNing::evaluate<double>(k.data(), m, d, 0).force;
  };
  // Loading: F_y + pi p_y R* (d - d_y), from Hertz's F_y.
  const double f_y = 4.0 / 3 * t.pair.modulus * std::sqrt(t.radius) * std::pow(d_y, 1.5);
  for (const double times : {0.5, 1.0, 1.5, 3.0, 10.0, 20.0}) {
    const double d = times * d_y,
                 expected = times <= 1 ? f_y * std::pow(times, 1.5)
                                       : f_y + std::numbers::pi * p_y * t.radius * (d - d_y);
    states(fmt::format("F at {} d_y [N]", times), force(d), expected, 1e-12 * expected,
           "Thornton 1997");
  }
  const double largest = force(most),
               radius = t.radius * std::pow(most, 1.5) * 4.0 / 3 * t.pair.modulus *
                        std::sqrt(t.radius) / largest,
               rest = most - t.radius * most / radius;  // a^2 = R* d_max = R_p (d_max - d_p)
  for (const double part : {0.75, 0.25, 0.5, 1.0}) {
    const double elastic = part * (most - rest),
                 expected = 4.0 / 3 * t.pair.modulus * std::sqrt(radius) * std::pow(elastic, 1.5);
    states(fmt::format("F at {} of the elastic part [N]", part), force(rest + elastic), expected,
           1e-12 * largest, "Hertz of the radius R_p*, Thornton 1997");
  }
  states("F within the plastic overlap [N]", force(0.5 * rest), 0, 0, "the bodies part at d_p");
  const double further = f_y + std::numbers::pi * p_y * t.radius * (1.5 * most - d_y);
  states("F beyond the largest overlap [N]", force(1.5 * most), further, 1e-12 * further,
         "loading goes on");
}

TEST(ElasticPlastic, elastic_energy_is_the_work_that_unloading_gives_back) {
  const EffectivePair t = touching(pair_of(steel, steel, 1), ball_of(1));
  const ThorntonNing law = law_of();
  const auto k = law.coefficients(t, law.damping(1));
  const double most = 7 * law.yield_overlap(t);
  double m[contact::law_history_size] = {};
  ThorntonNing::evaluate<double>(k.data(), m, most, 0);
  constexpr int steps = 20000;
  double work = 0;
  for (int i = 0; i < steps; ++i)
    work += most / steps *
            ThorntonNing::evaluate<double>(k.data(), m, (i + 0.5) * most / steps, 0).force;
  states("stored over work of unloading", law.elastic_energy(k, m, most) / work, 1, 1e-8,
         "integral of F, midpoints");
}

TEST(ElasticPlastic, scales_are_those_of_its_collisions) {
  const contact::Pair pair = pair_of(steel, steel, 1);
  const EffectivePair t = touching(pair, ball_of(1));
  const ThorntonNing law = law_of();
  const double v = law.yield_speed(t);
  for (const double ratio : {0.5, 2.0, 20.0}) {
    const Impact found = impact({ball_of(ratio * v)}, pair, of_law(law), share);
    states(fmt::format("largest overlap at {} V_y over the formula", ratio),
           found.deepest / law.largest_overlap(t, ratio * v), 1, 1e-3, "(epl.5)");
    stays_below(fmt::format("shortest_time at {} V_y over duration", ratio),
                law.shortest_time(t, ratio * v) / found.duration, 1 + share, "law.hpp");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::elastic_plastic_test

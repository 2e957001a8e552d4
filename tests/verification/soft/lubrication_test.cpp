// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Lubrication between bodies that approach, in the soft engine (docs/theory/liquid.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "liquid.hpp"

namespace mahlwerk::tests::lubrication_test {
namespace {

using namespace liquid;

/// Two balls of 10 and 6 mm, or a ball at the floor, that approach at `speed`.
struct Approach {
  scene::Chamber box = still_box(0.1);
  std::vector<scene::Ball> balls;
  contact::EffectivePair pair;
  double gap(const std::vector<scene::Ball>& b) const {
    return b.size() == 1 ? b[0].position.z + 0.05 - b[0].radius
                         : norm(b[1].position - b[0].position) - b[0].radius - b[1].radius;
  }
  double closing(const std::vector<scene::Ball>& b) const {
    return b.size() == 1 ? -b[0].velocity.z : b[0].velocity.x - b[1].velocity.x;
  }
};
Approach approach(bool wall, double speed, double gap) {
  Approach a;
  const scene::Ball ball{0.005, 7850, {}, {}, {}}, small{0.003, 7850, {}, {}, {}};
  if (wall) {
    a.balls = {ball};
    a.balls[0].position = {0, 0, -0.05 + ball.radius + gap};
    a.balls[0].velocity = {0, 0, -speed};
  } else {
    a.balls = {ball, small};
    a.balls[0].velocity = {0.7 * speed, 0, 0};
    a.balls[1].position = {ball.radius + small.radius + gap, 0, 0};
    a.balls[1].velocity = {-0.3 * speed, 0, 0};
  }
  a.pair = touching(dry_pair(), a.balls);
  return a;
}

/// Error [m/s] of the speed at touch: the force of a step takes the speed as constant, but it
/// changes by (k/m) dh/h. Summed over the way: (k/m)^2 dt / (2 h_r), at touch; at a separation h
/// likewise. Half of a step's impulse comes at its middle: another (k/m) (v dt / h)^2 / 8.
double error_of_speed(double k_over_m, double step, double separation, double speed) {
  const double share = speed * step / separation;
  return k_over_m * k_over_m * step / (2 * separation) + k_over_m * share * share / 8;
}

TEST(Lubrication, slows_two_bodies_down_as_reynolds_says) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true})
    for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
      const double v0 = 0.3, step = 1e-7, h0 = 2 * liquid.film;
      const Approach a = approach(wall, v0, h0);
      const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid, few);
      const double k_over_m = liquid.resistance(a.pair.radius) / a.pair.mass;
      Recorder recorder;
      double worst = 0, allowed = 0, lowest = v0;
      for (double t = step; a.gap(engine->balls()) > 0; t += step) {
        engine->advance(t, recorder);
        const auto now = engine->balls();
        const double h = a.gap(now) + liquid.roughness;
        // The first step in the film and the last one before touch cover the rest of the way.
        const double way = 2 * v0 * step;
        if (h >= h0 - way || a.gap(now) <= way) continue;
        const double expected = v0 - k_over_m * math::log(h0 / h);
        const double bound = error_of_speed(k_over_m, step, h, v0) + 1e-12;
        if (std::abs(a.closing(now) - expected) > worst) {
          worst = std::abs(a.closing(now) - expected);
          allowed = bound;
        }
        EXPECT_LE(std::abs(a.closing(now) - expected), bound) << h;
        lowest = a.closing(now);
      }
      const std::string name =
          fmt::format("{}, {}", wall ? "ball and wall" : "two balls", few ? "few" : "many");
      stays_below(name + ": speed off v0 - (k/m*) ln(h0/h) [m/s]", worst, allowed,
                  "(liq.3), error of the steps");
      EXPECT_LT(lowest, 0.9 * v0) << "the liquid hardly acts: the test shows nothing";
    }
}

/// A collision in a film. Returns rebound over approach.
double wet_restitution(const Approach& a, const Liquid& liquid, double step, bool& touched) {
  const double speed = a.closing(a.balls);
  const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid);
  Recorder recorder;
  double t = 0;
  while (t < 0.5) {
    engine->advance(t += 100 * step, recorder);
    if (!recorder.all.empty() && a.gap(engine->balls()) > 2 * liquid.film) break;
  }
  touched = !recorder.all.empty();
  const scene::EnergyBalance e = engine->energy_balance();
  EXPECT_LT(std::abs(e.residual()), 1e-4 * e.initial_energy);
  return -a.closing(engine->balls()) / speed;
}

TEST(Lubrication, gives_the_restitution_of_the_stokes_number) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true})
    for (const double ratio : {1.1, 1.5, 3.0, 10.0, 100.0}) {  // St over its critical value
      const contact::EffectivePair pair = approach(wall, 1, 1e-3).pair;
      const double critical = liquid.critical_speed(pair.radius, pair.mass);
      const double speed = ratio * critical;
      const double step = contact::hertz_time(pair, speed) / 400;
      bool touched = false;
      const double found = wet_restitution(approach(wall, speed, 2.3e-4), liquid, step, touched);
      EXPECT_TRUE(touched);
      // The dry collision itself, at the speed of touch, by the same steps.
      Liquid nothing = liquid;
      nothing.viscosity = 1e-12;
      const double dry =
          wet_restitution(approach(wall, speed - critical, 2.3e-4), nothing, step, touched);
      const double k_over_m = liquid.resistance(pair.radius) / pair.mass;
      const double tolerance =
          error_of_speed(k_over_m, step, liquid.roughness, speed - critical) / speed + 1e-3 / ratio;
      states(fmt::format("{}, St = {} St_c: e", wall ? "wall" : "balls", ratio), found,
             dry * (1 - 1 / ratio), tolerance, "e_dry (1 - St_c/St), Davis et al. 1986 (liq.4)");
    }
}

TEST(Lubrication, stops_bodies_below_the_critical_stokes_number) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true}) {
    Approach a = approach(wall, 1, 2e-4);
    const double k_over_m = liquid.resistance(a.pair.radius) / a.pair.mass;
    const double speed = 0.7 * liquid.critical_speed(a.pair.radius, a.pair.mass);
    a = approach(wall, speed, 2e-4);
    const double step = 0.2 * liquid.roughness / k_over_m;  // (liq.9)
    const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid);
    Recorder recorder;
    engine->advance(0.05, recorder);
    EXPECT_TRUE(recorder.all.empty());
    const double h = 2 * liquid.film * math::exp(-speed / k_over_m);
    // An error of the speed dv shifts the end by h dv / (k/m).
    const double tolerance = h * error_of_speed(k_over_m, step, h, speed) / k_over_m;
    states("separation at the end [m]", a.gap(engine->balls()) + liquid.roughness, h, tolerance,
           "(liq.3) at v = 0");
  }
}

TEST(Lubrication, that_resists_the_rebound_acts_twice) {
  Liquid liquid = oil_film();
  liquid.resists_rebound = true;
  const double ratio = 4;
  const contact::EffectivePair pair = approach(true, 1, 1e-3).pair;
  const double critical = liquid.critical_speed(pair.radius, pair.mass), speed = ratio * critical;
  const double step = contact::hertz_time(pair, speed) / 400;
  bool touched = false;
  const double found = wet_restitution(approach(true, speed, 2.3e-4), liquid, step, touched);
  const double k_over_m = liquid.resistance(pair.radius) / pair.mass;
  states("e, film that resists the rebound", found, dry_restitution * (1 - 1 / ratio) - 1 / ratio,
         2 * error_of_speed(k_over_m, step, liquid.roughness, speed) / speed + 1e-3,
         "(liq.3), approach and rebound");
}

}  // namespace
}  // namespace mahlwerk::tests::lubrication_test

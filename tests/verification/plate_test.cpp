// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A ball on a plate that vibrates: a tall box whose lid the ball never reaches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::plate_test {
namespace {

constexpr double e = 0.5, frequency = 10, period = 1 / frequency, radius = 0.004;  // [1], [Hz], ...
constexpr double omega = 2 * std::numbers::pi * frequency, lid = 10;               // [1/s], [m]

/// Flight by one period T needs a speed g T/2 after each bounce. With the plate at P = A w cos phi,
/// g T/2 - P = e (g T/2 + P), so cos phi = pi (1 - e)/((1 + e) Gamma): period 1 exists above this
/// least Gamma.
const double least_gamma = std::numbers::pi * (1 - e) / (1 + e);
/// A small change grows by a matrix of determinant e^2 and trace 1 + e^2 - (1 + e)^2 Gamma sin phi
/// at each bounce. Period 1 is stable while the trace is above -(1 + e^2).
const double largest_gamma = std::hypot(least_gamma, 2 * (1 + e * e) / ((1 + e) * (1 + e)));

/// Times of the bounces [s of the mill] of a ball that starts at the highest point of the flight of
/// period 1, `off` [m] too high.
std::vector<double> bounces(double gamma, double off, int count) {
  const double amplitude = gamma * gravity / (omega * omega);
  const double phi = std::acos(least_gamma / gamma);
  const double half = 0.5 * period, start = phi / omega + half;
  scene::Ball ball = ball_a();
  ball.position.z =
      2 * amplitude * std::sin(phi) - 0.5 * lid + radius + 0.5 * gravity * half * half + off;
  ball.velocity.z = amplitude * omega * std::cos(phi);  // at rest in the laboratory
  const scene::Chamber plate{
      geometry::Box{1, 1, lid}, shaken(frequency, amplitude), {}, {0, 0, -gravity}};
  event::Rules rules;
  rules.bounce = {e, 1, 0};
  const auto engine = event::one_ball(plate, ball, rules, start);
  Recorder recorder;
  engine->advance(count * period, recorder);
  std::vector<double> times;
  for (const scene::Collision& c : recorder.all) {
    EXPECT_LT(c.where.z, 0) << "the lid is never reached";
    times.push_back(start + c.time);
  }
  return times;
}

TEST(VibratingPlate, a_ball_bounces_once_in_a_period_below_the_first_bifurcation) {
  for (const double gamma :
       {1.05 * least_gamma, 0.5 * (least_gamma + largest_gamma), 0.98 * largest_gamma}) {
    const std::vector<double> times = bounces(gamma, 1e-4, 600);
    ASSERT_GT(times.size(), 500U);
    const double last = times.back(), before = times[times.size() - 2];
    const std::string at = ", Gamma = " + std::to_string(gamma);
    states("flight over a period" + at, (last - before) / period, 1, 1e-9, "period 1");
    states("cos of the phase of the bounce" + at, std::cos(omega * last), least_gamma / gamma, 1e-7,
           "pi (1 - e)/((1 + e) Gamma)");
    EXPECT_GT(std::sin(omega * last), 0) << "the stable one of the two phases";
  }
}

TEST(VibratingPlate, flights_alternate_above_the_first_bifurcation) {
  const std::vector<double> times = bounces(1.02 * largest_gamma, 1e-4, 2000);
  const std::size_t n = times.size();
  ASSERT_GT(n, 1900U);
  const double one = times[n - 1] - times[n - 2], other = times[n - 2] - times[n - 3];
  states("two flights over a period", (one + other) / period, 2, 1e-9, "period 2");
  EXPECT_GT(std::abs(one - other), 0.01 * period) << "they differ";
}

/// A ball that rests on the plate at the start.
std::unique_ptr<scene::Engine> resting(double amplitude, double restitution) {
  scene::Ball ball = ball_a();
  ball.position.z = -0.5 * lid + radius;
  const scene::Chamber plate{
      geometry::Box{1, 1, lid}, shaken(frequency, amplitude), {}, {0, 0, -gravity}};
  event::Rules rules;
  rules.bounce = {restitution, 1, 0};
  return event::one_ball(plate, ball, rules);
}

/// A ball that rests on the plate leaves it where A w^2 sin(w t) = g, and falls back on it. For a
/// fast mill the plate comes and goes within a step that only the motion of the ball would allow.
TEST(VibratingPlate, a_ball_at_rest_is_lifted_where_the_plate_falls_faster) {
  for (const double gamma : {1.01, 1.3, 3.0}) {
    const double amplitude = gamma * gravity / (omega * omega);
    const double lift = std::asin(1 / gamma) / omega;  // [s]
    const auto gap = [&](double t) {                   // [m] of the ball in free flight
      const double s = t - lift;
      return amplitude * (1 / gamma - std::sin(omega * t)) +
             amplitude * omega * std::cos(omega * lift) * s - 0.5 * gravity * s * s;
    };
    double before = lift + 1e-4, after = lift + 1e-4;  // of the touch
    while (gap(after) > 0) before = after, after += 1e-5;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (before + after);
      (gap(middle) > 0 ? before : after) = middle;
    }
    const auto engine = resting(amplitude, e);
    Recorder recorder;
    engine->advance(20.25 * period, recorder);
    const auto first = std::ranges::find_if(
        recorder.all, [&](const scene::Collision& c) { return c.time > lift + 1e-4; });
    ASSERT_NE(first, recorder.all.end());
    const std::string at = ", Gamma = " + std::to_string(gamma);
    states("time of the first touch over a period" + at, first->time / period, before / period,
           1e-5, "parabola and sine; the ball is released to within 1e-6 of a period");
    // After a quarter of a period the plate is at its top; after whole periods it has given
    // nothing.
    const scene::EnergyBalance b = engine->energy_balance();
    stays_below("residual over what the plate gives" + at, std::abs(b.residual() / b.wall_work),
                1e-6, "energy of the plate, bounces and contact");
  }
}

/// The normal force vanishes for a moment only and grows slowly again. The ball falls back at a
/// speed that the search does not resolve: bounces at it took 1e7 steps and ended no earlier.
TEST(VibratingPlate, a_ball_that_is_hardly_lifted_stays_on_the_plate) {
  for (const double restitution : {0.5, 0.9, 0.99}) {
    double steps = 0, residual = 0;
    for (int digits = 3; digits <= 14; ++digits) {
      const double amplitude = (1 + std::pow(10, -digits)) * gravity / (omega * omega);
      const auto engine = resting(amplitude, restitution);
      Recorder recorder;
      ASSERT_NO_THROW(engine->advance(20.25 * period, recorder)) << restitution << ", " << digits;
      const scene::EnergyBalance b = engine->energy_balance();
      steps = std::max(steps, double(b.search_steps));
      residual = std::max(residual, std::abs(b.residual() / b.wall_work));
    }
    const std::string at = ", e = " + std::to_string(restitution);
    stays_below("steps of the search in twenty periods" + at, steps, 1e5,
                "21 lifts of up to 1400, 100 bounces of 20 after each");
    stays_below("residual over what the plate gives" + at, residual, 1e-6,
                "energy of the plate, bounces and contact");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::plate_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/heat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::heat_test {
namespace {

using tests::states;

constexpr double room = 293.15;

/// Five 15 mm balls in a small steel jar: 5 W.
HeatNodes small_mill() {
  return {.balls_capacity = 31, .jar_capacity = 150, .exchange = 0.18, .cooling = 0.13};
}
constexpr Heating five_watts{2.5, 2.5};

/// Fourth-order Runge-Kutta integration of (hea.1, hea.2).
Temperatures followed(const HeatNodes& n, const Heating& heat, Temperatures t, double duration,
                      int steps) {
  const auto rate = [&](const Temperatures& at) {
    const double across = n.exchange * (at.balls - at.jar);
    return Temperatures{(heat.balls - across) / n.balls_capacity,
                        (heat.jar + across - n.cooling * (at.jar - room)) / n.jar_capacity};
  };
  const auto on = [](const Temperatures& at, const Temperatures& by, double dt) {
    return Temperatures{at.balls + dt * by.balls, at.jar + dt * by.jar};
  };
  const double dt = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Temperatures a = rate(t), b = rate(on(t, a, dt / 2)), c = rate(on(t, b, dt / 2)),
                       d = rate(on(t, c, dt));
    t = {t.balls + dt / 6 * (a.balls + 2 * b.balls + 2 * c.balls + d.balls),
         t.jar + dt / 6 * (a.jar + 2 * b.jar + 2 * c.jar + d.jar)};
  }
  return t;
}

double apart(const Temperatures& a, const Temperatures& b) {
  return std::max(std::abs(a.balls - b.balls), std::abs(a.jar - b.jar));
}

/// Heat nodes with rates that are equal, very different, or zero.
struct Sort {
  std::string name;
  HeatNodes nodes;
};
std::vector<Sort> sorts() {
  return {{"a small mill", small_mill()},
          {"lumps alike", {100, 100, 0.2, 0.2}},
          {"no way out", {100, 100, 0.2, 0}},
          {"balls that keep their heat", {31, 150, 0, 0.13}},
          {"nearly none", {31, 150, 1e-12, 1e-13}},
          {"none at all", {31, 150, 0, 0}},
          {"a strong exchange", {31, 150, 50, 0.1}},
          {"hardly any jar", {31, 1e-2, 0.18, 0.13}}};
}

TEST(Heat, agrees_with_runge_and_kutta) {
  for (const auto& [name, nodes] : sorts()) {
    const Temperatures start{room + 40, room + 10};
    const Temperatures wanted = followed(nodes, five_watts, start, 600, 200'000);
    const Temperatures found = temperatures_after(nodes, five_watts, room, start, 600);
    states(name + " [K]", apart(found, wanted), 0, 1e-8,
           "200 000 roundings of 300 K, 2.8e-14 each, and more within a step");
  }
}

TEST(Heat, goes_into_the_lumps_or_to_the_air) {
  const HeatNodes n = small_mill();
  const MillCycles mill{5, 0.5, room, 600, 300, 3};
  const auto points = temperature_history(n, mill);
  double lost = 0, put_in = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {  // Simpson's rule within each step
    const double dt = points[i].time - points[i - 1].time;
    const bool mills = std::fmod(points[i - 1].time + 0.5 * dt, 900) < 600;
    const Heating heat = mills ? mill.heating() : Heating{};
    const Temperatures from{points[i - 1].balls, points[i - 1].jar};
    constexpr int parts = 20;
    for (int k = 0; k <= parts; ++k) {
      const double weight = k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2;
      const double jar = temperatures_after(n, heat, room, from, dt * k / parts).jar;
      lost += weight * dt / parts / 3 * n.cooling * (jar - room);
    }
    put_in += dt * (heat.balls + heat.jar);
  }
  const double stored =
      n.balls_capacity * (points.back().balls - room) + n.jar_capacity * (points.back().jar - room);
  states("heat put in [J]", put_in, 3 * 600 * 5, 1e-9, "5 W, three times ten minutes");
  states("stored and lost, over put in", (stored + lost) / put_in, 1, 1e-9, "energy balance");
}

TEST(Heat, in_the_long_run_the_jar_is_warmer_by_power_over_cooling) {
  const HeatNodes n = small_mill();
  const Temperatures late = temperatures_after(n, five_watts, room, {room, room}, 1e6);
  states("jar above the air [K]", late.jar - room, 5 / 0.13, 1e-10, "P/G_ja");
  states("balls above the jar [K]", late.balls - late.jar, 2.5 / 0.18, 1e-10, "s P/G_bj");
  states("steady() and the long run [K]", apart(steady_temperatures(n, five_watts, room), late), 0,
         1e-10, "the same (hea.5)");
}

TEST(Heat, without_a_way_out_rises_for_ever) {
  HeatNodes n = small_mill();
  n.cooling = 0;
  EXPECT_EQ(steady_temperatures(n, five_watts, room).jar, INFINITY);
  EXPECT_EQ(steady_temperatures(n, {}, room).balls, room);
  const Temperatures late = temperatures_after(n, five_watts, room, {room, room}, 1e5);
  states("heat in the lumps [J]",
         n.balls_capacity * (late.balls - room) + n.jar_capacity * (late.jar - room), 5e5, 1e-6,
         "5 W for 1e5 s");
}

TEST(Heat, of_one_lump_is_an_exponential) {
  const HeatNodes n{.balls_capacity = 1e-6, .jar_capacity = 150, .exchange = 1, .cooling = 0.13};
  for (const double time : {10.0, 1000.0, 5000.0}) {
    const double jar = temperatures_after(n, {0, 5}, room, {room, room}, time).jar;
    states("jar after " + std::to_string(static_cast<int>(time)) + " s [K]", jar - room,
           5 / 0.13 * -std::expm1(-0.13 / 150 * time), 2.6e-7,
           "P/G (1 - exp(-G t/C)); the balls hold 6.7e-9 of the heat");
  }
}

TEST(Heat, does_not_mind_a_phase_cut_in_two) {
  for (const auto& [name, nodes] : sorts()) {
    const Temperatures start{room + 40, room + 10};
    const Temperatures half = temperatures_after(nodes, five_watts, room, start, 217);
    const Temperatures whole = temperatures_after(nodes, five_watts, room, start, 600);
    states(name + ", relative",
           apart(temperatures_after(nodes, five_watts, room, half, 383), whole) / whole.balls, 0,
           1e-12, "the same");
  }
}

TEST(Heat, repeats_itself_after_many_cycles) {
  const HeatNodes n = small_mill();
  const MillCycles mill{5, 0.5, room, 600, 300, 60};
  const auto points = temperature_history(n, mill, 60 * 90);
  const std::size_t cycle = 90;
  ASSERT_EQ(points.size(), 60 * cycle + 1);
  double off = 0, mean = 0;
  for (std::size_t i = points.size() - cycle; i < points.size(); ++i) {
    off = std::max({off, std::abs(points[i].jar - points[i - cycle].jar),
                    std::abs(points[i].balls - points[i - cycle].balls)});
    mean += 0.5 * (points[i].jar + points[i - 1].jar) / static_cast<double>(cycle);
  }
  // 59 cycles of 900 s are 32 time constants of 1.66 ks: the start has decayed to e^-32.
  states("last cycle less the one before [K]", off, 0, 1e-11, "settled");
  states("mean rise of the jar over a cycle [K]", mean - room, 5 / 0.13 * 2 / 3, 1e-9,
         "power on for two thirds of the time; errors of trapezoids cancel over a period");
}

TEST(HeatHistory, holds_the_ends_of_every_phase) {
  const auto points = temperature_history(small_mill(), {5, 0.5, room, 600, 300, 4});
  states("points", static_cast<double>(points.size()), 401, 8, "400 and the start; whole steps");
  for (int cycle = 0; cycle < 4; ++cycle)
    for (const double end : {900.0 * cycle, 900.0 * cycle + 600, 900.0 * (cycle + 1)})
      EXPECT_TRUE(std::ranges::any_of(points, [&](const HeatPoint& p) { return p.time == end; }))
          << end;
  EXPECT_TRUE(std::ranges::is_sorted(points, std::less<>(), &HeatPoint::time));
  EXPECT_EQ(points.front().balls, room);
  const auto hottest = std::ranges::max_element(points, {}, &HeatPoint::jar);
  EXPECT_LE(std::fmod(hottest->time, 900), 620) << "soon after milling ends";
  EXPECT_EQ(temperature_history(small_mill(), {5, 0.5, room, 600, 300, 10'000}).size(), 20'001u);
}

/// A reading by Euler's steps so small that their error is below 1e-5 of the temperature rise.
double followed_reading(const Thermocouple& sensor, const HeatNodes& n, const Heating& heat,
                        const Temperatures& start, double reading, double duration) {
  constexpr int steps = 200'000;
  const double dt = duration / steps;
  for (int i = 0; i < steps; ++i) {  // the surroundings in the middle of the step
    const double around = sensor.around(temperatures_after(n, heat, room, start, (i + 0.5) * dt));
    reading += (around - reading) * (1 - math::exp(-dt / sensor.lag));
  }
  return reading;
}

TEST(ThermocoupleReading, agrees_with_small_steps) {
  const HeatNodes mill = small_mill();
  for (const double lag : {0.5, 30.0, 150.0, 2000.0})
    for (const double share : {0.0, 0.4, 1.0})
      for (const double duration : {3.0, 600.0, 20'000.0}) {
        const Thermocouple sensor{share, lag};
        const Temperatures start{330, 310};
        // Steps of dt err by (dt/lag)^2/24 and (dt/fastest mode)^2/24 of the largest change.
        const double dt = duration / 200'000, fastest = 130;
        const double share_of_step = dt / std::min(lag, fastest);
        states("lag " + std::to_string(lag) + " s [K]",
               reading_after(sensor, mill, five_watts, room, start, 300, duration),
               followed_reading(sensor, mill, five_watts, start, 300, duration),
               1e-9 + 50 * share_of_step * share_of_step, "(sns.8) by small steps");
      }
}

TEST(ThermocoupleReading, does_not_mind_a_phase_cut_in_two) {
  const HeatNodes mill = small_mill();
  const Temperatures start{350, 320}, middle = temperatures_after(mill, {}, room, start, 70);
  for (const double lag : {1e-3, 1.0, 145.0, 1e4, 1e6}) {
    const Thermocouple sensor{0.3, lag};
    const double half = reading_after(sensor, mill, {}, room, start, 340, 70);
    states("lag " + std::to_string(lag) + " s [K]",
           reading_after(sensor, mill, {}, room, middle, half, 1000),
           reading_after(sensor, mill, {}, room, start, 340, 1070), 1e-10, "exact (sns.8)");
  }
}

TEST(ThermocoupleReading, lags_behind_a_ramp_by_its_time_constant) {
  HeatNodes mill = small_mill();
  mill.cooling = 0;  // balls and jar rise at 5 W over 181 J/K for ever
  const double slope = 5 / 181.0, lag = 20, long_after = 1e5;
  const Temperatures end = temperatures_after(mill, five_watts, room, {room, room}, long_after);
  for (const double share : {0.0, 1.0}) {
    const Thermocouple sensor{share, lag};
    states("behind [K]",
           sensor.around(end) -
               reading_after(sensor, mill, five_watts, room, {room, room}, room, long_after),
           slope * lag, 1e-9, "slope times lag");
  }
}

TEST(ThermocoupleReading, has_no_lag_or_an_endless_one) {
  const HeatNodes mill = small_mill();
  const Temperatures start{350, 320}, end = temperatures_after(mill, five_watts, room, start, 100);
  states("without lag [K]", reading_after({1, 0}, mill, five_watts, room, start, 300, 100),
         end.balls, 0, "what is there");
  states("a tiny lag [K]", reading_after({1, 1e-9}, mill, five_watts, room, start, 300, 100),
         end.balls, 1e-9, "slope times lag");
  states("a huge lag [K]", reading_after({1, 1e20}, mill, five_watts, room, start, 300, 100), 300,
         1e-12, "it has not moved");
  states("after no time [K]", reading_after({1, 5}, mill, five_watts, room, start, 300, 0), 300, 0,
         "it has not moved");
}

TEST(ThermocoupleReading, of_the_gas_is_between_balls_and_wall_by_area) {
  const Thermocouple sensor{share_of_balls_in_gas(1, 3), 0};
  states("gas [K]", sensor.around({400, 300}), 325, 1e-12, "(sns.7)");
}

}  // namespace
}  // namespace mahlwerk::powder::heat_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs of mills whose speed is prescribed over time (kin.27).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lammps_cases.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/results/table_of.hpp"

namespace mahlwerk::campaign::speed_over_time_test {
namespace {

using tests::case_of_text;
using tests::states;
using Set = std::vector<cases::Override>;

/// Up, to and fro, and a pause after each.
const std::string planetary = R"([mill]
kind = "planetary"
orbit_radius = "60 mm"
speed = "400 rpm"
ratio = -2
speed_over_time = [["0 s", 0], ["0.1 s", "100 %"], ["0.4 s", 1], ["0.5 s", 0], ["0.6 s", 0],
                   ["0.7 s", -1], ["1 s", "-100 %"], ["1.1 s", 0]]
speed_repeats = true
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
[[balls]]
count = 5
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.5
softening = 1e-3
[run]
engine = "event"
time = "2.2 s"
settle = "0 s"
replicates = 2
sensitivity = "off"
)";

const std::string drum = R"([mill]
kind = "tumbling"
speed = "60 rpm"
speed_over_time = [["0 s", 1], ["0.5 s", 1], ["1 s", 0], ["1.5 s", 0], ["2 s", "-50 %"]]
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "60 mm"
[[balls]]
diameter = "10 mm"
count = 60
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.5
softening = 1e-3
[run]
engine = "soft"
time = "2.5 s"
settle = "0 s"
replicates = 1
sensitivity = "off"
[power_meter]
interval = "0.5 s"
)";

/// A ball lies on the floor of a box that moves by 3 mm sin(2 pi 5 Hz s), below 1 g.
const std::string floor_of_a_box = R"([mill]
kind = "vibration"
frequency = "5 Hz"
amplitude = "3 mm"
speed_over_time = [["0 s", 0], ["0.2 s", 1], ["0.5 s", 1], ["0.7 s", -1], ["1 s", -1], ["1.2 s", 0]]
[jar]
kind = "box"
width = "50 mm"
depth = "50 mm"
height = "50 mm"
youngs_modulus = "70 MPa"
[[balls]]
diameter = "10 mm"
density = "7850 kg/m3"
youngs_modulus = "70 MPa"
positions = [["0 mm", "0 mm", "-20 mm"]]
[contact]
restitution = 0.3
friction = 0.5
[run]
start_speed = "0 m/s"
start_spin = "0 rad/s"
settle = "0 s"
replicates = 1
sensitivity = "off"
)";

TEST(SpeedOverTime, puts_the_floor_and_the_ball_on_it_where_its_clock_is) {
  constexpr double amplitude = 3e-3, w = 2 * std::numbers::pi * 5, g = 9.81;
  const double mass = std::numbers::pi / 6 * 1e-6 * 7850;
  struct Moment {
    const char* time;
    double clock, rate;
  };
  // s(0.2) = 0.1, s(0.5) = 0.4; from 1 to -1 within 0.2 s: s = 0.4 + 0.2 (u - 2 u^3 + u^4).
  constexpr Moment moments[] = {{"0.35 s", 0.25, 1},
                                {"0.55 s", 0.4 + 0.2 * (0.25 - 2 / 64. + 1 / 256.), 0.6875},
                                {"0.85 s", 0.25, -1},
                                {"1.3 s", 0, 0}};
  for (const std::string engine : {"event", "soft"})
    for (const Moment& at : moments) {
      const results::Outcome outcome =
          run(case_of_text(floor_of_a_box, {{"run.engine", engine}, {"run.time", at.time}}));
      const scene::EnergyBalance& e = outcome.replicates.front().energy_balance;
      const double speed = amplitude * w * at.rate * std::cos(w * at.clock);
      // The soft ball sinks by 7 um and swings about that, at the speed of some mm/s when it
      // starts; the hard one may still take bounces of um.
      const std::string name = ", " + engine + ", " + at.time;
      states("kinetic energy [J]" + name, e.kinetic, 0.5 * mass * speed * speed,
             0.01 * 0.5 * mass * amplitude * amplitude * w * w, "floor at the speed A w r cos w s");
      states("height [m]" + name, (e.potential - e.initial_energy) / (mass * g),
             amplitude * std::sin(w * at.clock), 1e-5, "floor at A sin w s");
    }
}

TEST(SpeedOverTime, closes_the_books_through_a_reversal_and_gives_the_torque_at_its_mean_speed) {
  for (const std::string engine : {"event", "soft"}) {
    const results::Outcome outcome = run(case_of_text(planetary, {{"run.engine", engine}}));
    for (const results::Replicate& r : outcome.replicates) {
      const auto value = [&](std::string_view name) { return results::value_of(outcome, r, name); };
      states("residual over the work of the jar, " + engine,
             r.energy_balance.residual() / r.energy_balance.wall_work, 0,
             engine == "event" ? 1e-9 : 1e-3, "balance of the run");
      // In 1.1 s: 0.3 s at full speed and 0.2 s at half of it, in both senses.
      const double speed = 400 * std::numbers::pi / 30 * 2 * (0.3 + 0.1) / 1.1;
      // The soft engine ends at a step, up to 20 us late.
      states("torque times mean speed [W], " + engine, value("shaft_torque") * speed,
             value("drawn_power"), 2e-5 * value("drawn_power"), "(obs.7)");
    }
    for (const Notice& one : outcome.notices) EXPECT_NE(one.code, "not-settled") << one.text;
  }
}

TEST(SpeedOverTime, of_a_drum_gives_each_reading_its_speed_and_no_angle_where_it_reverses) {
  const results::Outcome outcome = run(case_of_text(drum));
  const results::Replicate& r = outcome.replicates.front();
  states("drum_speed [rpm]", results::value_of(outcome, r, "drum_speed"),
         60 * (0.5 + 0.25 + 0.125 + 0.25) / 2.5, 1e-3, "mean of the magnitude");
  const results::Table meter = results::table_of(outcome, "power_meter");
  ASSERT_EQ(meter.rows.size(), 5U);
  const double full = 60 * std::numbers::pi / 30;
  for (const auto& [reading, rate] : {std::pair(0U, 1.0), {1U, 0.5}, {3U, 0.25}, {4U, 0.5}})
    states("torque times speed [W]", meter.rows[reading][3] * full * rate, meter.rows[reading][1],
           1e-3 * std::abs(meter.rows[reading][1]), "(sns.2), readings end up to 20 us late");
  EXPECT_TRUE(std::isnan(meter.rows[2][3])) << "no torque over no speed";
  for (const results::Quantity& q : outcome.summary.quantities) {
    EXPECT_NE(q.name, "toe_angle");
    EXPECT_NE(q.name, "bed_angle");
  }
}

void expect_same(const results::Replicate& a, const results::Replicate& b) {
  EXPECT_EQ(a.energy_balance.wall_work, b.energy_balance.wall_work);
  EXPECT_EQ(a.energy_balance.kinetic, b.energy_balance.kinetic);
  EXPECT_EQ(a.energy_balance.lost_normal, b.energy_balance.lost_normal);
  EXPECT_EQ(a.energy_balance.collisions, b.energy_balance.collisions);
}

TEST(SpeedOverTime, has_the_same_bits_on_two_threads_and_after_a_cut) {
  for (const std::string engine : {"event", "soft"}) {
    const cases::Case c = case_of_text(planetary, {{"run.engine", engine}, {"run.time", "1.3 s"}});
    const results::Outcome one = run(c, on(1)), two = run(c, on(2));
    for (std::size_t k = 0; k < one.replicates.size(); ++k)
      expect_same(one.replicates[k], two.replicates[k]);
    for (const double cut : {0.45, 0.65, 1.15}) {  // stopping, turning back, in the second cycle
      ReplicateRun first(c, 0), second(c, 0);
      while (first.energy_balance().time < cut) first.run_slice();
      ASSERT_FALSE(first.done());
      Archive out;
      first.serialize(out);
      Archive in(out.bytes());
      second.serialize(in);
      in.finish();
      while (!second.done()) second.run_slice();
      expect_same(second.result(), one.replicates[0]);
    }
  }
}

TEST(SpeedOverTime, of_a_stirrer_gives_its_torque_and_power_number_at_its_mean_speed) {
  const cases::Case c = case_of_text(R"([mill]
kind = "still"
speed_over_time = [["0 s", 0], ["0.1 s", 1], ["0.2 s", 1], ["0.3 s", 0]]
[jar]
kind = "attritor"
diameter = "100 mm"
height = "120 mm"
shaft_diameter = "20 mm"
shaft_clearance = "10 mm"
arms = 4
arm_diameter = "8 mm"
arm_span = "80 mm"
arm_clearance = "20 mm"
arm_spacing = "20 mm"
rotor_speed = "300 rpm"
youngs_modulus = "10 MPa"
[[balls]]
count = 40
diameter = "8 mm"
density = "7850 kg/m3"
youngs_modulus = "10 MPa"
[contact]
restitution = 0.5
friction = 0.3
[run]
engine = "soft"
time = "0.3 s"
settle = "0 s"
replicates = 1
sensitivity = "off"
)");
  const results::Outcome outcome = run(c);
  const results::Replicate& r = outcome.replicates.front();
  const auto value = [&](std::string_view name) { return results::value_of(outcome, r, name); };
  const double power = value("drawn_power"), turns = 5 * 2. / 3;  // 300 rpm for 0.2 s of 0.3 s
  EXPECT_GT(power, 0);
  states("torque times mean speed [W]", value("rotor_torque") * 2 * std::numbers::pi * turns, power,
         1e-3 * power, "(obs.16), the run ends at a step");
  states("power number", value("power_number"),
         power / (7850 * 0.6 * turns * turns * turns * std::pow(0.08, 5)),
         3e-3 * value("power_number"), "(obs.17)");
}

TEST(SpeedOverTime, waits_with_automatic_settling_until_the_mill_has_its_last_speed) {
  const cases::Case c =
      case_of_text(drum, {{"run.settle", "auto"},
                          {"balls.count", "10"},
                          {"mill.speed_over_time", "[[\"0 s\", 0], [\"1 s\", 0.5]]"},
                          {"run.time", "0.5 s"}});
  const results::Outcome outcome = run(c);
  // Turns take 2 s, blocks an eighth of one, and there are eight or more of them.
  EXPECT_GE(outcome.replicates.front().at_settled.time, 1 + 2 - 1e-4);
  states("counted time [s]", outcome.replicates.front().time(), 6, 1e-3, "three turns");
  states("drum_speed [rpm]", results::value_of(outcome, outcome.replicates.front(), "drum_speed"),
         30, 1e-9, "half of the full one");
}

TEST(SpeedOverTime, is_refused_where_it_has_no_meaning) {
  const auto code = [](const std::string& text, const Set& set) {
    try {
      const cases::Case c = case_of_text(text, set);
      const std::vector<Fault> found = run_faults(c);
      return found.empty() ? std::string() : found.front().code;
    } catch (const InputError& e) {
      return e.faults().front().code;
    }
  };
  const std::string bad = "bad-speed-over-time";
  EXPECT_EQ(code(planetary, {}), "");
  EXPECT_EQ(code(planetary, {{"run.settle", "auto"}}), bad);
  EXPECT_EQ(code(planetary, {{"run.start", "ramp"}, {"run.settle", "2 s"}}), bad);
  EXPECT_EQ(code(planetary, {{"run.time", "until 2 %"}}), bad);
  EXPECT_EQ(code(planetary, {{"milling.reverse", "true"}, {"milling.time", "1 h"}}), bad);
  EXPECT_EQ(code(drum, {{"drive.inertia", "1 kg m2"}, {"drive.torque", "1 N m"}}),
            "drive-not-possible");
  EXPECT_NE(code(planetary, {{"run.engine", "lammps"}}), "");
  const auto rows = [&](const std::string& text) {
    return code(planetary, {{"mill.speed_over_time", text}});
  };
  EXPECT_EQ(rows("[[\"0 s\", 0]]"), "wrong-type");
  EXPECT_EQ(rows("[[\"0 s\", 0], \"1 s\"]"), "wrong-type");
  EXPECT_EQ(rows("[[\"0 s\", 0], [\"1 s\", \"120 %\"]]"), "out-of-range");
  EXPECT_EQ(rows("[[\"1 s\", 0], [\"2 s\", 0]]"), bad) << "not from the start";
  EXPECT_EQ(rows("[[\"0 s\", 0], [\"1 s\", 1], [\"1 s\", 0]]"), bad) << "a jump";
  EXPECT_EQ(rows("[[\"0 s\", 0], [\"1 s\", 1]]"), bad) << "a repetition jumps";
  EXPECT_EQ(rows("[[\"0 s\", 0], [\"1 s\", -1], [\"2 s\", 0]]"), bad) << "never forwards";
}

}  // namespace
}  // namespace mahlwerk::campaign::speed_over_time_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sensors of whole runs (docs/theory/sensors.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/parts/accelerometer/impact_record.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"
#include "unit/results/table_of.hpp"

namespace mahlwerk::parts::sensors_test {
namespace {

using results::Outcome;
using results::Table;
using tests::states;

Outcome outcome_of(const std::string& text, int threads = 1) {
  campaign::RunOptions options;
  options.threads = threads;
  return campaign::run(cases::read_text(text, "case.toml", cases::sample::catalogue()), options);
}

double value(const Outcome& outcome, std::string_view name) {
  return named(outcome.summary.quantities, name).value;
}

std::vector<double> column(const Table& table, std::string_view name) {
  std::vector<double> values;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].name == name)
      for (const auto& row : table.rows) values.push_back(row[i]);
  return values;
}

/// A steel ball that falls 51 mm onto the floor of a jar at rest and rebounds once.
std::string drop(const std::string& engine) {
  return R"([mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "120 mm"
[[balls]]
diameter = "10 mm"
density = "7850 kg/m3"
positions = [["0 mm", "0 mm", "-4 mm"]]
velocities = [["0 m/s", "0 m/s", "0 m/s"]]
spins = [["0 rad/s", "0 rad/s", "0 rad/s"]]
[contact]
restitution = 0.5
[run]
time = "0.15 s"
engine = ")" +
         engine + R"("
[accelerometer]
mass = "0.4 kg"
bandwidth = "500 Hz"
duration = "0.15 s"
)";
}

TEST(Accelerometer, of_a_dropped_ball_shows_the_peak_of_its_impulse_in_both_engines) {
  const double mass = 7850 * std::numbers::pi / 6 * 1e-6, speed = std::sqrt(2 * 9.81 * 0.051);
  const double omega = 2 * std::numbers::pi * 500, sigma = omega / std::numbers::sqrt2;
  const double peak = mass * 1.5 * speed / 0.4 * omega * math::exp(-std::numbers::pi / 4);
  const double step = 1 / (4 * 5e3), contact = 50e-6;  // of the record; of the ball, at most
  // Sampling misses the peak by half a step, an interval and a contact smooth it.
  const double tolerance =
      sigma * sigma * (step * step / 4 + (step * step + contact * contact) / 12);
  for (const char* engine : {"event", "soft"}) {
    const Outcome outcome = outcome_of(drop(engine));
    states(fmt::format("peak in the {} engine [m/s2]", engine), value(outcome, "acceleration_peak"),
           peak, tolerance * peak, "J/M omega exp(-pi/4), J = m (1 + e) v (sns.6)");
    const std::vector<double> a = column(table_of(outcome, "accelerometer"), "of_impacts");
    EXPECT_LT(*std::ranges::min_element(a), -0.9 * peak);  // the ball pushes the jar down
    for (const double still : column(table_of(outcome, "accelerometer"), "of_motion"))
      EXPECT_EQ(still, 0);
  }
}

/// Balls in a vibration mill, with all sensors.
std::string mill(const std::string& engine, const std::string& sensors) {
  return R"([mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "8 mm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "40 mm"
youngs_modulus = "1 GPa"
[[balls]]
count = 5
diameter = "10 mm"
density = "7850 kg/m3"
youngs_modulus = "1 GPa"
[contact]
restitution = 0.6
[run]
time = "0.4 s"
settle = "0.05 s"
replicates = 2
engine = ")" +
         engine + "\"\n" + sensors;
}

const std::string all_sensors =
    "[heat]\n[power_meter]\ninterval = \"7 ms\"\n[microphone]\n[accelerometer]\n[thermocouple]\n";

TEST(Accelerometer, shows_the_motion_of_the_mill_along_its_axis) {
  const double omega = 40 * std::numbers::pi, expected = 8e-3 * omega * omega;
  const std::vector<double> along =
      column(table_of(outcome_of(mill("event", "[accelerometer]\nbandwidth = \"2 kHz\"\n")),
                      "accelerometer"),
             "of_motion");
  const double ratio = 20.0 / 2000;
  // The jar's acceleration is at its largest somewhere between two samples.
  const double angle = 0.5 * omega / 20e3;
  states("largest acceleration [m/s2]", *std::ranges::max_element(along),
         expected / std::sqrt(1 + ratio * ratio * ratio * ratio), expected * angle * angle,
         "A omega^2");
  const auto across = outcome_of(mill("event", "[accelerometer]\naxis = \"x\"\n"));
  for (const double a : column(table_of(across, "accelerometer"), "of_motion")) EXPECT_EQ(a, 0);
}

TEST(Accelerometer, counts_the_impulses_of_all_impacts) {
  for (const std::string engine : {"event", "soft"}) {
    std::string text =
        mill(engine, "[accelerometer]\nduration = \"5 s\"\nbandwidth = \"500 Hz\"\n");
    text.replace(text.find("0.4 s"), 5, "5 s");
    const Outcome outcome = outcome_of(text);
    for (const results::Replicate& r : outcome.replicates) {
      double sum = 0;
      for (const double impulse : r.recorders.find<accelerometer::ImpactRecord>()->impulses())
        sum += impulse;
      // The momentum that the wall gives to the charge balances gravity in the mean over time; the
      // balls' change of momentum is at most that of their largest speed.
      const double mass = 5 * 7850 * std::numbers::pi / 6 * 1e-6;
      const double speed = 2 * 8e-3 * 40 * std::numbers::pi * 2;
      states(engine + ": impulse on the jar [N s]", sum, -mass * 9.81 * 5, 2 * mass * speed,
             "weight times time, up to the change of momentum");
    }
  }
}

TEST(PowerMeter, reads_all_the_work_of_the_jar) {
  for (const std::string engine : {"event", "soft"}) {
    const Outcome outcome = outcome_of(mill(
        engine, "[power_meter]\ninterval = \"10 ms\"\nidle_power = \"30 W\"\nefficiency = 0.5\n"));
    const Table table = table_of(outcome, "power_meter");
    const std::vector<double> drawn = column(table, "drawn_power"),
                              motor = column(table, "motor_power");
    ASSERT_EQ(drawn.size(), 40U);
    EXPECT_NEAR(table.rows.back()[0], 0.4, 1e-4);
    double work = 0, last = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      work += drawn[i] * (table.rows[i][0] - last);
      last = table.rows[i][0];
      EXPECT_DOUBLE_EQ(motor[i], 30 + 2 * drawn[i]);  // (sns.1)
    }
    const results::Replicate& r = outcome.replicates.front();
    const double whole = r.energy_balance.wall_work - r.at_settled.wall_work;
    states(engine + ": work of the readings [J]", work, whole, 1e-10 * std::abs(whole),
           "that of the run");
    states("mean power of the motor [W]", value(outcome, "motor_power"),
           30 + 2 * value(outcome, "drawn_power"), 1e-9, "(sns.1)");
    EXPECT_GT(value(outcome, "motor_power_scatter"), 0);
  }
}

TEST(PowerMeter, reads_the_torque_of_all_jars_on_the_shaft) {
  const std::string text = R"([mill]
kind = "planetary"
orbit_radius = "70 mm"
ratio = "1:-2"
speed = "300 rpm"
jars_carried = 2
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
[[balls]]
count = 4
diameter = "10 mm"
density = "7850 kg/m3"
[run]
engine = "event"
time = "0.3 s"
settle = "0 s"
[power_meter]
)";
  const Table table = table_of(outcome_of(text), "power_meter");
  const std::vector<double> torque = column(table, "torque"), drawn = column(table, "drawn_power");
  ASSERT_EQ(torque.size(), 200U);
  for (std::size_t i = 0; i < torque.size(); ++i)
    EXPECT_DOUBLE_EQ(torque[i], 2 * drawn[i] / (10 * std::numbers::pi));  // (sns.2)
}

TEST(PowerMeter, at_a_drum_at_rest_has_no_torque) {
  const Outcome outcome = outcome_of(R"([mill]
kind = "tumbling"
speed = "0 rpm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
[[balls]]
count = 2
diameter = "10 mm"
density = "7850 kg/m3"
[run]
engine = "event"
time = "0.1 s"
[power_meter]
)");
  EXPECT_EQ(value(outcome, "drum_speed"), 0);
  EXPECT_EQ(table_of(outcome, "power_meter").columns.size(), 3U);
}

TEST(Microphone, without_definition_time_hears_every_hit_on_the_jar) {
  for (const std::string engine : {"event", "soft"}) {
    const Outcome jar = outcome_of(mill(engine, "[microphone]\ndefinition_time = \"0 s\"\n"));
    EXPECT_DOUBLE_EQ(value(jar, "heard_hit_rate"), value(jar, "collision_rate_with_jar"));
    const Outcome all =
        outcome_of(mill(engine, "[microphone]\ndefinition_time = \"0 s\"\nhears = \"all\"\n"));
    EXPECT_DOUBLE_EQ(value(all, "heard_hit_rate"), value(all, "collision_rate"));
    EXPECT_DOUBLE_EQ(value(all, "heard_hit_energy_mean"), value(all, "energy_normal_mean"));
    const Outcome ring = outcome_of(mill(engine, "[microphone]\ndefinition_time = \"5 ms\"\n"));
    EXPECT_LT(value(ring, "heard_hit_rate"), value(jar, "heard_hit_rate"));
    EXPECT_GT(value(ring, "heard_hit_energy_mean"), value(jar, "heard_hit_energy_mean"));
    const std::vector<double> above = column(table_of(ring, "microphone"), "rate_above"),
                              rate = column(table_of(ring, "microphone"), "rate");
    states("hits above the lowest bin [1/s]", above.front(), value(ring, "heard_hit_rate"), 1e-9,
           "all of them");
    EXPECT_DOUBLE_EQ(above.back(), rate.back());
  }
}

TEST(Thermocouple, reads_between_the_ambient_and_what_it_touches) {
  const Outcome outcome =
      outcome_of(mill("event", "[heat]\nmilling = \"2 min\"\n[thermocouple]\nlag = \"20 s\"\n"));
  const Table table = table_of(outcome, "thermocouple");
  for (const auto& row : table.rows) EXPECT_LE(row[2], row[1] + 1e-9);
  states("reading at the end [degC]", value(outcome, "thermocouple_reading"), table.rows.back()[2],
         0.05, "that of the mean power");
  EXPECT_LT(value(outcome, "thermocouple_reading"), value(outcome, "temperature_jar"));
}

TEST(Thermocouple, does_not_depend_on_what_was_long_before) {
  const auto reading = [](const std::string& cycles) {
    return value(outcome_of(mill("event", "[heat]\nmilling = \"20 min\"\n" + cycles +
                                              "[thermocouple]\nplace = \"balls\"\nlag = \"60 "
                                              "s\"\n")),
                 "thermocouple_reading");
  };
  states("after days of pauses [degC]", reading("pause = \"24 h\"\ncycles = 20\n"), reading(""),
         1e-6, "the jar is cold again after a day");
}

TEST(Sensors, show_the_same_bits_on_any_number_of_threads) {
  for (const std::string engine : {"event", "soft"}) {
    const Outcome one = outcome_of(mill(engine, all_sensors)),
                  two = outcome_of(mill(engine, all_sensors), 2);
    EXPECT_EQ(table_of(one, "power_meter").rows, table_of(two, "power_meter").rows);
    EXPECT_EQ(table_of(one, "microphone").rows, table_of(two, "microphone").rows);
    EXPECT_EQ(table_of(one, "accelerometer").rows, table_of(two, "accelerometer").rows);
    EXPECT_EQ(table_of(one, "thermocouple").rows, table_of(two, "thermocouple").rows);
  }
}

TEST(Sensors, change_no_other_number_of_a_run) {
  for (const std::string engine : {"event", "soft"}) {
    const Outcome with = outcome_of(mill(engine, all_sensors)),
                  without = outcome_of(mill(engine, ""));
    for (const results::Quantity& q : without.summary.quantities)
      EXPECT_EQ(q.value, value(with, q.name)) << engine << " " << q.name;
  }
}

bool has(const Outcome& outcome, std::string_view code) {
  return std::ranges::find(outcome.notices, code, &Notice::code) != outcome.notices.end();
}

TEST(Microphone, warns_where_impacts_merge) {
  const Outcome clear = outcome_of(mill("event", "[microphone]\nthreshold = \"1 mJ\"\n"));
  EXPECT_FALSE(has(clear, "merged-hits"));
  EXPECT_TRUE(
      has(outcome_of(mill("event", "[microphone]\ndefinition_time = \"0.1 s\"\n")), "merged-hits"));
}

TEST(Accelerometer, warns_of_softened_contacts) {
  std::string text = mill("soft", "[accelerometer]\n");
  text.replace(text.find("restitution"), 0, "softening = 0.1\n");
  EXPECT_TRUE(has(outcome_of(text), "softened-impacts"));
  EXPECT_FALSE(has(outcome_of(mill("soft", "[accelerometer]\n")), "softened-impacts"));
}

}  // namespace
}  // namespace mahlwerk::parts::sensors_test

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs of mills that a motor turns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lammps_cases.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/mill_power.hpp"
#include "mahlwerk/parts/drive/drive_record.hpp"
#include "statement.hpp"
#include "unit/results/table_of.hpp"

namespace mahlwerk::campaign::drive_test {
namespace {

using parts::drive::DriveRecord;
using parts::drive::DriveSample;
using tests::case_of_text;
using tests::states;

const std::string drum = R"([mill]
kind = "tumbling"
speed = "120 rpm"
[drive]
inertia = "1e-4 kg m2"
torque = "0.03 N m"
[jar]
kind = "lifter-cylinder"
diameter = "60 mm"
height = "40 mm"
lifters = 4
lifter_height = "5 mm"
lifter_width = "5 mm"
[[balls]]
diameter = "8 mm"
count = 40
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3
[run]
engine = "soft"
time = "0.3 s"
settle = "0.05 s"
replicates = 2
)";

const std::vector<DriveSample>& samples(const results::Replicate& r) {
  return r.recorders.find<DriveRecord>()->samples();
}

TEST(DrivenRun, each_replicate_turns_its_own_mill) {
  const results::Outcome outcome = run(case_of_text(drum));
  ASSERT_EQ(outcome.replicates.size(), 2U);
  const auto &one = samples(outcome.replicates[0]), &other = samples(outcome.replicates[1]);
  EXPECT_EQ(one.size(), 201U);
  EXPECT_NE(one.back().speed, other.back().speed) << "other starts of the balls, other torques";
  for (const results::Replicate& r : outcome.replicates) {
    const DriveSample& end = samples(r).back();
    states("books of the drive [J]", end.motor_work - r.energy_balance.drive_kinetic,
           r.energy_balance.wall_work, 5e-3 * end.motor_work, "(kin.26)");
  }
}

TEST(DrivenRun, replays_show_the_jar_where_the_motor_has_turned_it) {
  const cases::Case c = case_of_text(drum);
  const results::Outcome outcome = run(c);
  const results::Replicate& r = outcome.replicates.front();
  const auto& drive = samples(r);
  ASSERT_GT(r.replay.times().size(), 5U);
  const double full = 120 * std::numbers::pi / 30;
  for (std::size_t i = 0; i < r.replay.times().size(); ++i) {
    const double t = r.replay.times()[i] - r.at_settled.time;
    const auto after = std::ranges::lower_bound(drive, t, {}, &DriveSample::time);
    if (after == drive.begin() || after == drive.end()) continue;
    const auto before = after - 1;
    const double share = (t - before->time) / (after->time - before->time);
    const double angle = before->angle + share * (after->angle - before->angle);
    // Linear between samples 1.5 ms apart: off by h^2/8 of 0.03 N m/1e-4 kg m2, and by the balls'.
    states("angle of the jar [rad]", full * r.replay.mill_times()[i], angle, 0.25 * 3 * 0.0015,
           "integral of the speed");
  }
}

/// 180 rpm is 1.04 of the critical speed of the shell; the motor brings the drum to less than 0.9
/// of it.
TEST(DrivenRun, quantities_are_of_the_mean_speed_of_each_replicate) {
  std::string fast = drum + "[power_meter]\ninterval = \"0.1 s\"\n";
  fast.replace(fast.find("120 rpm"), 7, "180 rpm");
  fast.replace(fast.find("0.03 N m"), 8, "0.06 N m");
  const results::Outcome outcome = run(case_of_text(fast));
  ASSERT_EQ(outcome.replicates.size(), 2U);
  const double full = 180 * std::numbers::pi / 30, critical = std::sqrt(2 * 9.81 / 0.06);
  for (const results::Replicate& r : outcome.replicates) {
    const auto value = [&](std::string_view name) { return results::value_of(outcome, r, name); };
    const scene::EnergyBalance &begin = r.at_settled, &end = r.energy_balance;
    const double speed = (end.mill_angle - begin.mill_angle) / (end.time - begin.time);
    EXPECT_LT(speed, 0.9 * full);
    states("drum_speed [rad/s]", value("drum_speed") * std::numbers::pi / 30, speed, 1e-12 * full,
           "angle over time");
    states("torque times speed [W]", value("shaft_torque") * speed, value("drawn_power"), 1e-15,
           "(obs.7)");
    states("Froude number", value("froude_number"), speed * speed * (0.03 - 0.004) / 9.81, 1e-12,
           "speed^2 r/g");
    states("slip at the wall [m/s]", value("wall_slip_ratio") * speed * 0.03,
           r.charge.wall_slip / r.charge.mass_at_wall, 1e-12, "mean slip");
    states("speed seen from the jar [m/s]", value("jar_lag") * speed * 0.03,
           value("ball_speed_seen_from_jar"), 1e-12, "jar_lag times the wall's speed");
    auto mill = cases::mill_numbers(outcome.mill_case).value();
    mill.speed = speed / critical;
    const double mass = 40 * std::numbers::pi / 6 * 0.008 * 0.008 * 0.008 * 7850;
    states("power by Bond [W]", value("bond_power"), cases::bond_power(mill, mass), 1e-12,
           "(mil.1) at the mean speed");
    states("toe by Morrell [deg]", value("morrell_toe_angle"),
           cases::morrell_charge(mill).toe * 180 / std::numbers::pi - 270, 1e-9, "(mil.3)");
  }
  for (const Notice& one : outcome.notices) EXPECT_NE(one.code, "formula-out-of-range");
}

/// The motor's mill turns faster from reading to reading.
TEST(DrivenRun, the_power_meter_reads_the_torque_at_the_speed_of_each_reading) {
  const results::Outcome outcome =
      run(case_of_text(drum + "[power_meter]\ninterval = \"75 ms\"\n"));
  const results::Table meter = results::table_of(outcome, "power_meter");
  ASSERT_EQ(meter.rows.size(), 4U);
  const auto& own = samples(outcome.replicates.front());
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t to = (i + 1) * (own.size() - 1) / 4, from = i * (own.size() - 1) / 4;
    const double speed = (own[to].angle - own[from].angle) / (own[to].time - own[from].time);
    // Readings and samples are up to a step of 20 us apart, of 75 ms.
    states("torque times speed [W]", meter.rows[i][3] * speed, meter.rows[i][1],
           5e-4 * std::abs(meter.rows[i][1]), "(sns.2)");
  }
}

const std::string paddle = R"([mill]
kind = "still"
[drive]
inertia = "2e-5 kg m2"
torque = "6e-3 N m"
[jar]
kind = "cylinder"
diameter = "60 mm"
height = "50 mm"
[[parts]]
name = "paddle"
kind = "blade"
length = "36 mm"
height = "10 mm"
thickness = "4 mm"
position = ["0 mm", "0 mm", "-10 mm"]
motion = "turning"
speed = "-300 rpm"
[[parts]]
name = "baffle"
kind = "blade"
length = "4 mm"
height = "40 mm"
thickness = "4 mm"
position = ["27 mm", "0 mm", "0 mm"]
[[balls]]
diameter = "6 mm"
count = 100
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3
[run]
engine = "soft"
time = "0.3 s"
settle = "0.1 s"
replicates = 2
)";

TEST(DrivenRun, of_a_stirrer_closes_its_books_and_shows_it_where_the_motor_has_turned_it) {
  const results::Outcome outcome = run(case_of_text(paddle));
  const double full = 300 * std::numbers::pi / 30;
  for (const results::Replicate& r : outcome.replicates) {
    const auto value = [&](std::string_view name) { return results::value_of(outcome, r, name); };
    const DriveSample& end = samples(r).back();
    states("books of the drive [J]", end.motor_work - r.energy_balance.drive_kinetic,
           r.energy_balance.wall_work, 5e-3 * end.motor_work, "(kin.26)");
    states("power of the parts [W]", value("parts_power"), value("drawn_power"),
           1e-9 * value("drawn_power"), "the vessel is at rest");
    const double mean =
        (end.angle - samples(r).front().angle) / (end.time - samples(r).front().time);
    states("driven_speed [rad/s]", value("driven_speed") * std::numbers::pi / 30, mean,
           1e-12 * full, "angle over time");
    EXPECT_LT(mean, 0.95 * full) << "its speed falls under load";
    EXPECT_LT(value("parts_torque"), 0) << "it turns the other way";
  }
  const results::Replicate& r = outcome.replicates.front();
  const auto& drive = samples(r);
  for (std::size_t i = 0; i < r.replay.times().size(); ++i) {
    const double t = r.replay.times()[i] - r.at_settled.time;
    const auto after = std::ranges::lower_bound(drive, t, {}, &DriveSample::time);
    if (after == drive.begin() || after == drive.end()) continue;
    const auto before = after - 1;
    const double share = (t - before->time) / (after->time - before->time);
    // Linear between samples 1.5 ms apart. A hit of 0.9 g at 0.5 m/s and 18 mm changes the speed by
    // 0.6 rad/s, several together by 3 rad/s: off by a quarter of that times 1.5 ms.
    states("angle of the paddle [rad]", full * r.replay.mill_times()[i],
           before->angle + share * (after->angle - before->angle), 0.25 * 3 * 0.0015,
           "integral of the speed");
  }
}

TEST(DrivenRun, is_refused_where_no_motor_can_turn_the_mill) {
  const auto says = [](std::string text, std::string_view from, std::string_view to,
                       std::string_view part) {
    text.replace(text.find(from), from.size(), to);
    std::string all;
    try {
      const cases::Case c = case_of_text(text);
      for (const Fault& f : run_faults(c)) all += f.what + "|" + f.code + "\n";
    } catch (const InputError& e) {
      for (const Fault& f : e.faults()) all += f.what + "|" + f.code + "\n";
    }
    EXPECT_NE(all.find(part), std::string::npos) << all;
  };
  says(drum, "kind = \"tumbling\"\nspeed = \"120 rpm\"",
       "kind = \"vibration\"\namplitude = \"5 mm\"\nfrequency = \"20 Hz\"", "drive-not-possible");
  std::string smooth = drum;
  const std::string_view bars = "lifters = 4\nlifter_height = \"5 mm\"\nlifter_width = \"5 mm\"\n";
  smooth.replace(smooth.find(bars), bars.size(), "");
  smooth.replace(smooth.find("lifter-cylinder"), 15, "cylinder");
  says(smooth, "engine = \"soft\"", "engine = \"event\"", "[drive]");
  says(drum, "[drive]\n", "[drive]\nstart_speed = \"500 rpm\"\n", "drive.start_speed");
  says(drum, "speed = \"120 rpm\"", "speed = \"120 rpm\"\njars_carried = 2", "several jars");
  says(drum, "settle = \"0.05 s\"", "start = \"ramp\"\nramp_time = \"0.1 s\"",
       "drive-not-possible");
  says(drum, "inertia = \"1e-4 kg m2\"", "inertia = \"0 kg m2\"", "inertia");
  says(paddle, "motion = \"turning\"\nspeed = \"-300 rpm\"\n", "", "needs a drum");
  constexpr std::string_view place = "position = [\"27 mm\", \"0 mm\", \"0 mm\"]";
  const std::string at(place);
  says(paddle, place, at + "\nmotion = \"turning\"\nspeed = \"20 rpm\"", "needs a drum");
  says(paddle, place, at + "\nmotion = \"oscillating\"\namplitude = \"1 mm\"\nfrequency = \"5 Hz\"",
       "not with the shaft");
  says(paddle, "torque = \"6e-3 N m\"", "torque = \"0 N m\"\nstart_speed = \"500 rpm\"",
       "drive.start_speed");
}

}  // namespace
}  // namespace mahlwerk::campaign::drive_test

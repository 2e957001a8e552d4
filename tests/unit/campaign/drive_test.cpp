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
#include "mahlwerk/parts/drive/drive_record.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "statement.hpp"

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
    states("angle of the jar [rad]", full * r.replay.mill_times()[i], angle,
           3 * 0.0015 * 0.0015 / 8 * 300, "integral of the speed");
  }
}

TEST(DrivenRun, names_the_numbers_that_are_of_the_speed_without_load) {
  const auto told = [](const std::string& text) {
    const results::Outcome outcome = run(case_of_text(text));
    return std::ranges::any_of(results::warnings(outcome),
                               [](const Notice& one) { return one.code == "driven-speed"; });
  };
  constexpr std::string_view inertia = "inertia = \"1e-4 kg m2\"";
  std::string heavy{drum};
  heavy.replace(heavy.find(inertia), inertia.size(),
                "inertia = \"1e4 kg m2\"\nstart_speed = \"120 rpm\"");
  EXPECT_TRUE(told(std::string(drum)));
  EXPECT_FALSE(told(heavy));
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
}

}  // namespace
}  // namespace mahlwerk::campaign::drive_test

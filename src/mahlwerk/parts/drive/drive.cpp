// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A mill whose speed a motor and the charge decide; the section [drive]
// (docs/theory/kinematics.md).
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/parts/drive/drive_record.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::drive {
namespace {

using cases::Case;
using kinematics::Motor;
using results::Outcome;
using results::Replicate;
using results::Table;

constexpr double rpm = std::numbers::pi / 30;  // [rad/s]

void describe(cases::KeyVisitor& v, Motor& motor, const Case& c) {
  v.number({"inertia",
            "kg m2",
            {.least = 0, .most = 1e12, .without_least = true},
            "moment of inertia of jar, or stirrer, and drive about their axis, without balls"},
           motor.inertia);
  v.word({"motor",
          {"linear", "induction"},
          "linear",
          "usual of hydraulic and direct-current drives",
          "how the torque depends on the speed",
          {"falls from standstill to zero at the speed without load",
           "of an induction motor by Kloss: zero at the speed without load, largest at "
           "breakdown_slip"}},
         motor.kind);
  v.number({"torque",
            "N m",
            {.least = 0, .most = 1e12},
            "torque of the motor on the mill: linear at standstill, induction the largest; 0: it "
            "turns freely"},
           motor.torque);
  if (motor.kind == Motor::Kind::induction || v.visits_all())
    v.number({"breakdown_slip",
              "",
              {.least = 0.01, .most = 1},
              "slip of an induction motor at its largest torque",
              Motor().breakdown_slip,
              "usual: 0.1 to 0.3"},
             motor.breakdown_slip);
  else
    v.refuse({"breakdown_slip"}, "of a linear motor", "remove it, or write motor = \"induction\"");
  cases::NumberSpec start("start_speed", "rad/s", any_number, "speed at which a run begins");
  const double full = std::abs(cases::speed_without_load(c));
  if (v.reader() == nullptr)
    start = start.with_default_text("0; the speed without load where no motor turns it");
  else if (motor.torque == 0 && full > 0)
    start = start.with_default(full, "that of the mill: no motor turns it");
  else
    start = start.with_default(0, "the motor starts the mill");
  v.number(start, motor.start_speed);
}

/// What the motor would not turn together with the mill.
std::string moves_otherwise(const Case& c, const cases::MachinePart& part) {
  const kinematics::PartMotion& m = part.body.motion;
  if (!m.moves()) return "";
  if (cases::drum_motion(c) != nullptr)
    return part.body.in_laboratory ? "" : "moves relative to a jar that a motor turns";
  const bool attritor = geometry::as<geometry::Attritor>(*c.jar.shape) != nullptr;
  return attritor || !m.turns() ? "moves, and not with the shaft that a motor turns" : "";
}

/// What keeps a motor from turning the mill.
void check(const Case& c, std::vector<Fault>& found) {
  const std::string at = cases::location_of(c, "drive.inertia");
  const auto fault = [&](std::string what, std::string remedy) {
    found.push_back({at, std::move(what), std::move(remedy), "drive-not-possible"});
  };
  const double full = std::abs(cases::speed_without_load(c));
  if (full == 0)
    return fault(
        "[drive] needs a drum that turns about its own axis, lying, or in a jar at rest a stirrer: "
        "that of an attritor, or turning [[parts]] on one shaft",
        "write mill.kind = \"tumbling\" and a mill.speed, with mill.jar_axis as such mills "
        "have it; or mill.kind = \"still\", and give all turning parts one axis, pivot, speed and "
        "frame");
  if (std::abs(c.drive->start_speed) > kinematics::Drive::largest_rate * full)
    fault(fmt::format("drive.start_speed is more than {} times the speed without load",
                      kinematics::Drive::largest_rate),
          "give a higher speed to the mill or its stirrer, also without a motor");
  if (c.mill.jars_carried > 1)
    fault("the motor would turn several jars, and one is simulated",
          "write jars_carried = 1, and the motor's torque and inertia for one jar");
  if (c.run.start == cases::StartLayout::ramp)
    fault("run.start = \"ramp\" prescribes the speed of a mill that has a motor",
          "remove run.start, or [drive]");
  if (!c.mill.speed_over_time.empty())
    fault("mill.speed_over_time prescribes the speed of a mill that has a motor",
          "remove speed_over_time, or [drive]");
  if (cases::drum_motion(c) != nullptr && geometry::as<geometry::Attritor>(*c.jar.shape) != nullptr)
    fault("[drive] does not turn a jar with a stirrer", "remove [drive]");
  if (c.liquid) fault("[drive] does not take account of a liquid", "remove [liquid], or [drive]");
  for (const cases::MachinePart& part : c.machine_parts)
    if (const std::string how = moves_otherwise(c, part); !how.empty())
      fault(fmt::format("part \"{}\" {}", part.name, how),
            cases::drum_motion(c) != nullptr
                ? "write frame = \"laboratory\" or motion = \"fixed\", or remove [drive]"
                : "write motion = \"fixed\", or remove [drive]");
}

const std::vector<DriveSample>& samples_of(const Replicate& r) {
  return r.recorders.find<DriveRecord>()->samples();
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  constexpr double samples = 200;
  return std::make_unique<DriveRecord>(cases::counted_time(c) / samples);
}

/// Difference of a member between the first and the last sample, per time.
double per_time(const Replicate& r, double DriveSample::*member) {
  const auto& all = samples_of(r);
  if (all.size() < 2) return results::undefined;
  return (all.back().*member - all.front().*member) / (all.back().time - all.front().time);
}

/// [N m] Of the motor, at a speed of the mill.
double torque_at(const Case& c, double speed) {
  return c.drive->torque_at(speed / std::abs(cases::speed_without_load(c)));
}

double mean_torque(const Case& c, const Replicate& r) {
  double sum = 0;
  for (const DriveSample& one : samples_of(r)) sum += torque_at(c, one.speed);
  return results::share(sum, static_cast<double>(samples_of(r).size()));
}

double last_speed(const Replicate& r) {
  const auto& all = samples_of(r);
  return all.empty() ? results::undefined : all.back().speed;
}

results::Measures quantities() {
  return results::where(
      [](const Case& c) { return c.drive.has_value(); }, "with `[drive]`",
      {{"driven_speed",
        "rpm",
        "mean speed of the drum or stirrer that a motor turns",
        [](const Case&, const Replicate& r) { return per_time(r, &DriveSample::angle) / rpm; },
        {.range = results::any_value, .equation = "kin.24", .heading = "Drive"}},
       {"driven_speed_end",
        "rpm",
        "its speed at the end",
        [](const Case&, const Replicate& r) { return last_speed(r) / rpm; },
        {.range = results::any_value, .equation = "kin.24"}},
       {"drive_torque",
        "N m",
        "mean torque of the motor on the mill, in its sense",
        mean_torque,
        {.range = results::any_value, .equation = "kin.25"}},
       {"drive_power",
        "W",
        "mean power of the motor: what the charge takes, and what speeds up jar and drive",
        [](const Case&, const Replicate& r) { return per_time(r, &DriveSample::motor_work); },
        {.range = results::any_value, .equation = "kin.26"}}});
}

/// Means over the replicates at each time.
Table series(const Outcome& outcome) {
  Table table{{{"time", "s", "time since counting began"},
               {"speed", "rpm", "of the mill"},
               {"angle", "rad", "by which it has turned since the start of the run"},
               {"motor_torque", "N m", "on the mill"},
               {"motor_work", "J", "since the start of the run"},
               {"wall_work", "J", "of the jar on the balls, likewise"}},
              {}};
  const Case& c = outcome.mill_case;
  const auto chosen = results::averaged_replicates(outcome);
  const std::size_t least =
      results::fewest_over(chosen, [](const Replicate& r) { return samples_of(r).size(); });
  for (std::size_t i = 0; i < least; ++i) {
    const auto mean = [&](const auto& of) {
      return results::mean_over(chosen, [&](const Replicate& r) { return of(samples_of(r)[i]); });
    };
    table.rows.push_back({mean([](const DriveSample& s) { return s.time; }),
                          mean([](const DriveSample& s) { return s.speed / rpm; }),
                          mean([](const DriveSample& s) { return s.angle; }),
                          mean([&](const DriveSample& s) { return torque_at(c, s.speed); }),
                          mean([](const DriveSample& s) { return s.motor_work; }),
                          mean([](const DriveSample& s) { return s.wall_work; })});
  }
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"drive", "speed of the mill and torque of its motor over time", series(outcome)}};
}

std::string panel(const Outcome& outcome) {
  const Table table = series(outcome);
  return report::figure({.title = "Drive",
                         .x = report::Axis{.label = "time (s)", .least = 0},
                         .y = report::Axis{.label = "speed (rpm)", .least = 0},
                         .series = {{"mill",
                                     report::column(table, "time"),
                                     report::column(table, "speed"),
                                     {},
                                     report::Mark::line}},
                         .shape = 0.42},
                        "The speed that motor and charge give the mill. drive.csv has the numbers, "
                        "and the torque of the motor.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{.name = "drive",
                                .sections = {cases::section_in_case<&Case::drive, describe>(
                                    {"drive", "",
                                     "a motor that turns a drum or a stirrer, whose speed falls "
                                     "under load; or free turning"})},
                                .check = check,
                                .recorder = recorder,
                                .quantities = quantities,
                                .tables = tables,
                                .heading = "Drive",
                                .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::drive

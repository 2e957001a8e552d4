// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/power_meter/power_meter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/observe/recorder.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::parts::power_meter {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

void describe(cases::KeyVisitor& v, PowerMeter& meter, const Case& c) {
  cases::NumberSpec interval("interval", "s", positive, "time between two readings");
  if (v.reader() == nullptr)
    interval = interval.with_default_text("a 200th of run.time; 0.1 s with \"until\"");
  else if (c.run.until)
    interval = interval.with_default(0.1, "usual of meters");
  else
    interval = interval.with_default(c.run.time / 200, "a 200th of run.time");
  v.number(interval, meter.interval);
  v.number({"idle_power",
            "W",
            {.least = 0, .most = 1e9},
            "power of the motor that turns the mill without balls",
            PowerMeter().idle_power,
            "only the charge takes power"},
           meter.idle_power);
  v.number({"efficiency",
            "",
            {.least = 0.01, .most = 1},
            "power that reaches the charge over what the motor takes for it",
            PowerMeter().efficiency,
            "a drive without losses; measured: 0.7-0.95"},
           meter.efficiency);
}

const PowerMeter& meter_of(const Case& c) {
  return *c.parts.find<PowerMeter>();
}

void check(const Case& c, std::vector<Fault>& found) {
  constexpr double most_readings = 1e5;
  const PowerMeter& meter = meter_of(c);
  const double count = c.run.time / meter.interval;
  if (count < 1 - 1e-9)
    found.push_back({cases::location_of(c, "power_meter.interval"),
                     fmt::format("an interval of {} is longer than the run ({}): the meter would "
                                 "make no reading",
                                 show_rounded(meter.interval, "s"), show_rounded(c.run.time, "s")),
                     "give a shorter interval, or a longer run.time", "too-few-readings"});
  if (!(meter.interval > 0) || !(count > most_readings)) return;
  found.push_back({cases::location_of(c, "power_meter.interval"),
                   fmt::format("a reading every {} makes {:.2g} readings, more than {:.0g}",
                               show_rounded(meter.interval, "s"), count, most_readings),
                   fmt::format("write interval = \"{}\" or more",
                               show_rounded(1.05 * c.run.time / most_readings, "s")),
                   "too-many-readings"});
}

/// State of a run at a reading.
struct WorkReading {
  double time = 0;   ///< [s] since the start of the run
  double work = 0;   ///< [J] of the jar on the balls until then
  double angle = 0;  ///< [rad] that a motor has turned the mill until then
};

/// Reads the work of the jar at the intervals of the meter.
class Readings final : public observe::Recorder {
 public:
  Readings(double interval, double end) : interval_(interval), end_(end) {}
  std::unique_ptr<Recorder> copy() const override { return std::make_unique<Readings>(*this); }
  void begin(double time) override { begin_ = time; }
  /// The last reading is at the end of the run, whatever the rounding of the interval.
  double next() const override {
    constexpr double rounding = 1e-6;
    const double at = interval_ * static_cast<double>(count_ + 1);
    return begin_ + (std::abs(at - end_) < rounding * interval_ ? end_ : at);
  }
  void take(const scene::EnergyBalance& now) override {
    readings_.push_back({now.time, now.wall_work, now.mill_angle});
    while (next() <= now.time) ++count_;
  }
  void serialize(Archive& archive) override { archive(readings_)(count_); }
  /// Without the one at the begin of counting.
  const std::vector<WorkReading>& readings() const { return readings_; }

 private:
  double interval_, end_, begin_ = std::numeric_limits<double>::infinity();  // [s]
  std::vector<WorkReading> readings_;
  std::int64_t count_ = 0;
};

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  return std::make_unique<Readings>(meter_of(c).interval, c.run.time);
}

/// [W] Power that the motor takes if the balls of each jar draw `drawn` (sns.1).
double motor_power(const Case& c, double drawn) {
  const PowerMeter& meter = meter_of(c);
  return meter.idle_power + static_cast<double>(c.mill.jars_carried) * drawn / meter.efficiency;
}

/// A mean over the time between two readings.
struct PowerReading {
  double time, drawn;  ///< [s] of its end since counting began; [W] by one jar
  double rate;         ///< [1] speed of the mill over that of the case
};

std::vector<PowerReading> readings(const Case& c, const Replicate& r) {
  std::vector<PowerReading> all;
  const auto state = [](const WorkReading& at) {
    return scene::EnergyBalance{.time = at.time, .mill_angle = at.angle};
  };
  WorkReading last{r.at_settled.time, r.at_settled.wall_work, r.at_settled.mill_angle};
  for (const WorkReading& now : r.recorders.find<Readings>()->readings()) {
    all.push_back({now.time - r.at_settled.time, (now.work - last.work) / (now.time - last.time),
                   results::mill_rate(c, state(last), state(now))});
    last = now;
  }
  return all;
}

/// [W] Standard deviation of the motor's power over the readings.
double scatter_of_readings(const Case& c, const Replicate& r) {
  const std::vector<PowerReading> all = readings(c, r);
  if (all.size() < 2) return results::undefined;
  double mean = 0, squares = 0;
  for (const PowerReading& one : all)
    mean += motor_power(c, one.drawn) / static_cast<double>(all.size());
  for (const PowerReading& one : all) {
    const double off = motor_power(c, one.drawn) - mean;
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(all.size() - 1));
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<PowerMeter>() != nullptr; };
  return results::where(present, "with `[power_meter]`",
                        {{"motor_power",
                          "W",
                          "power of the motor: idle, and by the balls of all jars",
                          [](const Case& c, const Replicate& r) {
                            return motor_power(
                                c, results::per_time(r, &scene::EnergyBalance::wall_work));
                          },
                          {.equation = "sns.1", .heading = "Power meter", .key = 12}},
                         {"motor_power_scatter",
                          "W",
                          "standard deviation of the readings of the motor's power",
                          scatter_of_readings,
                          {.label = "scatter of the motor power"}}});
}

/// A row for each reading of one run, as a meter sees one run.
Table power_readings(const Outcome& outcome) {
  Table table{
      {{"time", "s", "end of the reading, since counting began"},
       {"drawn_power", "W", "work of the jar on the balls per time, since the last reading"},
       {"motor_power", "W", "power of the motor: idle, and by the balls of all jars"}},
      {}};
  const Case& c = outcome.mill_case;
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const std::optional<double> speed = cases::shaft_speed(c);
  if (speed)
    table.columns.push_back({"torque", "N m", "torque of the balls of all jars on the shaft"});
  constexpr double stands = 1e-6;  // [1] a reading ends a step after the mill has stopped
  for (const PowerReading& one : readings(c, *chosen.front())) {
    table.rows.push_back({one.time, one.drawn, motor_power(c, one.drawn)});
    if (speed)  // (sns.2)
      table.rows.back().push_back(std::abs(one.rate) > stands
                                      ? static_cast<double>(c.mill.jars_carried) * one.drawn /
                                            (*speed * one.rate)
                                      : results::undefined);
  }
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"power_meter", "readings of the motor's power", power_readings(outcome)}};
}

/// A column of the readings over time.
report::Plot readings_plot(const Outcome& outcome, std::string title, std::string_view name,
                           std::string_view words, std::string_view unit_name) {
  const Table table = power_readings(outcome);
  const report::Multiple unit =
      report::multiple(report::largest(report::column(table, name)), unit_name);
  return {.title = std::move(title),
          .x = report::Axis{.label = "time (s)", .least = 0},
          .y = report::Axis{.label = fmt::format("{} ({})", words, unit.unit)},
          .series = {{"",
                      report::column(table, "time"),
                      report::column(table, name, unit.factor),
                      {},
                      report::Mark::line}},
          .shape = 0.36};
}

std::string panel(const Outcome& outcome) {
  std::string text =
      report::figure(readings_plot(outcome, "Power of the motor", "motor_power", "power", "W"),
                     "Readings in one run. power_meter.csv has the numbers.");
  if (cases::shaft_speed(outcome.mill_case))
    text += report::figure(
        readings_plot(outcome, "Torque of the balls on the shaft", "torque", "torque", "N m"),
        "Drawn power over the speed of the shaft.");
  return text;
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "power_meter",
      .sections = {cases::section_of<PowerMeter, describe>(
          {"power_meter", "", "readings of the motor's power and torque; may be empty"})},
      .check = check,
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .heading = "Sensors",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::power_meter

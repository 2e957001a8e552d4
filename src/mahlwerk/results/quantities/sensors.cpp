// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/heat.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::LogHistogram;

constexpr double kelvin_at_zero_celsius = 273.15;

const Replicate* first_averaged(const Outcome& outcome) {
  const auto chosen = averaged_replicates(outcome);
  return chosen.empty() ? nullptr : chosen.front();
}

// Power meter

/// [W] Power that the motor takes if the balls of each jar draw `drawn` (sns.1).
double motor_power(const Case& c, double drawn) {
  const cases::PowerMeter& meter = *c.sensors.power_meter;
  return meter.idle_power + static_cast<double>(c.mill.jars_carried) * drawn / meter.efficiency;
}

/// A mean over the time between two readings.
struct PowerReading {
  double time, drawn;  ///< [s] of its end since counting began; [W] by one jar
};

std::vector<PowerReading> readings(const Replicate& r) {
  std::vector<PowerReading> all;
  WorkReading last{r.at_settled.time, r.at_settled.wall_work};
  for (const WorkReading& now : r.sensors.power_meter) {
    all.push_back({now.time - r.at_settled.time, (now.work - last.work) / (now.time - last.time)});
    last = now;
  }
  return all;
}

/// [W] Standard deviation of the motor's power over the readings.
double scatter_of_readings(const Case& c, const Replicate& r) {
  const std::vector<PowerReading> all = readings(r);
  if (all.size() < 2) return undefined;
  double mean = 0, squares = 0;
  for (const PowerReading& one : all)
    mean += motor_power(c, one.drawn) / static_cast<double>(all.size());
  for (const PowerReading& one : all) {
    const double off = motor_power(c, one.drawn) - mean;
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(all.size() - 1));
}

Measures power_meter_measures() {
  const auto present = [](const Case& c) { return c.sensors.power_meter.has_value(); };
  return where(present, "with `[power_meter]`",
               {{"motor_power",
                 "W",
                 "power of the motor: idle, and by the balls of all jars",
                 [](const Case& c, const Replicate& r) {
                   return motor_power(c, per_time(r, &scene::EnergyBalance::wall_work));
                 },
                 {.equation = "sns.1", .heading = "Power meter", .key = 12}},
                {"motor_power_scatter", "W",
                 "standard deviation of the readings of the motor's power", scatter_of_readings}});
}

// Microphone

Measures microphone_measures() {
  const auto present = [](const Case& c) { return c.sensors.microphone.has_value(); };
  return where(present, "with `[microphone]`",
               {{"heard_hit_rate",
                 "1/s",
                 "hits per second that the microphone hears",
                 [](const Case&, const Replicate& r) {
                   const LogHistogram heard = r.sensors.microphone->heard();
                   return share(static_cast<double>(heard.total()), r.time());
                 },
                 {.equation = "sns.3", .heading = "Microphone", .key = 13}},
                {"heard_hit_energy_mean", "J", "mean normal energy of the hits that it hears",
                 [](const Case&, const Replicate& r) {
                   const LogHistogram heard = r.sensors.microphone->heard();
                   return share(heard.sum(), static_cast<double>(heard.total()));
                 }}});
}

// Accelerometer

/// [kg] The mass that impacts accelerate.
double moved_mass(const Case& c) {
  const auto& given = c.sensors.accelerometer->mass;
  return given ? *given : cases::jar_mass(c, wall_area(*c.jar.shape));
}

/// [m/s2] What the sensor shows at the end of each interval of its record, without gravity: by the
/// motion of the jar's centre and by impacts (sns.5).
struct AccelerationSignal {
  std::vector<double> of_motion, of_impacts;
};

AccelerationSignal signal_of(const Case& c, const Replicate& r) {
  const observe::ImpactRecord& record = *r.sensors.accelerometer;
  const scene::Chamber mill = cases::chamber(c);
  const double mass = moved_mass(c), bandwidth = c.sensors.accelerometer->bandwidth;
  std::vector<double> motion, impacts;
  for (std::size_t i = 0; i < record.impulses().size(); ++i) {
    const double t = record.begin() + record.step() * (static_cast<double>(i) + 0.5);
    if (t - record.begin() > r.time()) break;  // of a run that was stopped
    const Vec3 axis = kinematics::rotation(*mill.motion, t) * (mill.mount * record.axis());
    motion.push_back(dot(kinematics::frame_motion(*mill.motion, t).acceleration, axis));
    impacts.push_back(record.impulses()[i] / (record.step() * mass));
  }
  const double start = motion.empty() ? 0 : motion.front();
  return {observe::low_pass(motion, record.step(), bandwidth, start),
          observe::low_pass(impacts, record.step(), bandwidth, 0)};
}

double root_mean_square(const std::vector<double>& values) {
  double squares = 0;
  for (const double a : values) squares += a * a;
  return std::sqrt(share(squares, static_cast<double>(values.size())));
}

std::vector<double> sum_of(const AccelerationSignal& s) {
  std::vector<double> sum = s.of_motion;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += s.of_impacts[i];
  return sum;
}

Measures accelerometer_measures() {
  const auto present = [](const Case& c) { return c.sensors.accelerometer.has_value(); };
  return where(
      present, "with `[accelerometer]`",
      {{"acceleration_rms",
        "m/s2",
        "root mean square of the accelerometer's signal",
        [](const Case& c, const Replicate& r) { return root_mean_square(sum_of(signal_of(c, r))); },
        {.equation = "sns.6", .heading = "Accelerometer"}},
       {"acceleration_rms_of_impacts", "m/s2", "part of it by the impacts of balls alone",
        [](const Case& c, const Replicate& r) {
          return root_mean_square(signal_of(c, r).of_impacts);
        }},
       {"acceleration_peak", "m/s2", "largest absolute value of the signal",
        [](const Case& c, const Replicate& r) {
          double largest = undefined;
          for (const double a : sum_of(signal_of(c, r))) largest = std::fmax(largest, std::abs(a));
          return largest;
        }}});
}

// Thermocouple

powder::Thermocouple thermocouple(const Case& c) {
  using Place = cases::Thermocouple::Place;
  const cases::Thermocouple& sensor = *c.sensors.thermocouple;
  const double gas =
      powder::share_of_balls_in_gas(cases::balls_surface(c), wall_area(*c.jar.shape));
  return {sensor.place == Place::wall ? 0 : sensor.place == Place::balls ? 1 : gas, sensor.lag};
}

/// Temperatures around the thermocouple and its readings.
struct ThermocoupleRecord {
  std::vector<double> times;             ///< [s]
  std::vector<double> around, readings;  ///< [K]
  std::size_t last_milling = 0;          ///< index of the end of the last milling
};

ThermocoupleRecord thermocouple_record(const Case& c, double power) {
  const powder::HeatNodes nodes = cases::heat_nodes(c, wall_area(*c.jar.shape));
  const powder::MillCycles cycles = cases::mill_cycles(c, power);
  const powder::Thermocouple sensor = thermocouple(c);
  ThermocoupleRecord record;
  powder::HeatPoint last;
  for (const powder::HeatPoint& p : powder::temperature_history(nodes, cycles)) {
    record.readings.push_back(
        record.times.empty()
            ? p.jar
            : powder::reading_after(sensor, nodes, p.milling ? cycles.heating() : powder::Heating{},
                                    cycles.ambient, {last.balls, last.jar}, record.readings.back(),
                                    p.time - last.time));
    if (p.milling) record.last_milling = record.times.size();
    record.times.push_back(p.time);
    record.around.push_back(sensor.around({p.balls, p.jar}));
    last = p;
  }
  return record;
}

Measures thermocouple_measures() {
  const auto present = [](const Case& c) { return c.sensors.thermocouple.has_value(); };
  return where(present, "with `[thermocouple]`",
               {{"thermocouple_reading",
                 "degC",
                 "reading of the thermocouple at the end of the last milling",
                 [](const Case& c, const Replicate& r) {
                   const ThermocoupleRecord record = thermocouple_record(c, dissipated_power(r));
                   return record.readings[record.last_milling] - kelvin_at_zero_celsius;
                 },
                 {.range = any_value, .equation = "sns.8", .heading = "Thermocouple"}}});
}

}  // namespace

Measures sensor_measures() {
  Measures all;
  for (Measures (*sensor)() :
       {power_meter_measures, microphone_measures, accelerometer_measures, thermocouple_measures})
    std::ranges::move(sensor(), std::back_inserter(all));
  return all;
}

Table power_readings(const Outcome& outcome) {
  Table table{
      {{"time", "s", "end of the reading, since counting began"},
       {"drawn_power", "W", "work of the jar on the balls per time, since the last reading"},
       {"motor_power", "W", "power of the motor: idle, and by the balls of all jars"}},
      {}};
  const Case& c = outcome.mill_case;
  const Replicate* shown = first_averaged(outcome);
  if (!c.sensors.power_meter || shown == nullptr) return table;
  const std::optional<double> speed = cases::shaft_speed(c);
  if (speed)
    table.columns.push_back({"torque", "N m", "torque of the balls of all jars on the shaft"});
  for (const PowerReading& one : readings(*shown)) {
    table.rows.push_back({one.time, one.drawn, motor_power(c, one.drawn)});
    if (speed)  // (sns.2)
      table.rows.back().push_back(static_cast<double>(c.mill.jars_carried) * one.drawn / *speed);
  }
  return table;
}

Table heard_hits(const Outcome& outcome) {
  Table table{{{"energy_low", "J", "lower edge of the bin of normal energy"},
               {"energy_high", "J", "its upper edge"},
               {"rate", "1/s", "hits per second that are heard"},
               {"rate_above", "1/s", "those with at least the energy of the lower edge"}},
              {}};
  const auto chosen = averaged_replicates(outcome);
  if (!outcome.mill_case.sensors.microphone || chosen.empty()) return table;
  LogHistogram all;
  double time = 0;
  for (const Replicate* r : chosen) {
    all.merge(r->sensors.microphone->heard());
    time += r->time();
  }
  const auto [first, end] = all.occupied_range();
  double above = static_cast<double>(all.total());
  for (int bin = first; bin < end; ++bin) {
    const auto count = static_cast<double>(all.count(bin));
    table.rows.push_back(
        {LogHistogram::lower(bin), LogHistogram::lower(bin + 1), count / time, above / time});
    above -= count;
  }
  return table;
}

Table acceleration(const Outcome& outcome) {
  Table table{{{"time", "s", "time of the sample, since counting began"},
               {"acceleration", "m/s2", "signal of the accelerometer, without gravity"},
               {"of_motion", "m/s2", "part of it by the motion of the mill"},
               {"of_impacts", "m/s2", "part of it by impacts of balls on the jar"}},
              {}};
  const Case& c = outcome.mill_case;
  const Replicate* shown = first_averaged(outcome);
  if (!c.sensors.accelerometer || shown == nullptr) return table;
  const double step = shown->sensors.accelerometer->step();
  const auto every =
      static_cast<std::size_t>(std::lround(1 / (c.sensors.accelerometer->sample_rate * step)));
  const AccelerationSignal s = signal_of(c, *shown);
  for (std::size_t i = every; i <= s.of_motion.size(); i += every) {
    const double motion = s.of_motion[i - 1], impacts = s.of_impacts[i - 1];
    table.rows.push_back({static_cast<double>(i) * step, motion + impacts, motion, impacts});
  }
  return table;
}

Table thermocouple_readings(const Outcome& outcome) {
  Table table{{{"time", "s", "time since the mill was first switched on"},
               {"surroundings", "degC", "temperature where the thermocouple is"},
               {"reading", "degC", "what it shows"}},
              {}};
  const auto chosen = averaged_replicates(outcome);
  if (!outcome.mill_case.sensors.thermocouple || chosen.empty()) return table;
  const ThermocoupleRecord record = thermocouple_record(
      outcome.mill_case, mean_over(chosen, [](const Replicate& r) { return dissipated_power(r); }));
  for (std::size_t i = 0; i < record.times.size(); ++i)
    table.rows.push_back({record.times[i], record.around[i] - kelvin_at_zero_celsius,
                          record.readings[i] - kelvin_at_zero_celsius});
  return table;
}

namespace {

/// Impacts follow each other faster than the microphone can tell them apart (sns.3).
void merged_hits(const Outcome& outcome, Notices& list) {
  const auto chosen = averaged_replicates(outcome);
  const auto& microphone = outcome.mill_case.sensors.microphone;
  if (!microphone || chosen.empty()) return;
  const double rate = mean_over(chosen, [](const Replicate& r) {
    return static_cast<double>(r.sensors.microphone->impacts()) / r.time();
  });
  if (!(rate * microphone->definition_time > 1)) return;
  list.push_back(warning(
      "merged-hits",
      fmt::format("{:.0f} impacts per second are loud enough for the microphone, more than one in "
                  "its definition time of {}: it hears most of them as one, and its rate of hits "
                  "says little. A higher microphone.threshold tells the strong ones apart.",
                  rate, show_rounded(microphone->definition_time, "s"))));
}

void softened_impacts(const Outcome& outcome, Notices& list) {
  const Case& c = outcome.mill_case;
  if (!c.sensors.accelerometer || !cases::in_time_steps(outcome.engine)) return;
  if (!(c.contact.softening < 1)) return;
  list.push_back(warning(
      "softened-impacts",
      fmt::format("contact.softening = {} makes contacts longer than real ones: the peaks of the "
                  "accelerometer are too small where a contact lasts longer than 1/bandwidth.",
                  show(c.contact.softening, ""))));
}

/// The record cannot be as long as the case asks for.
void short_record(const Outcome& outcome, Notices& list) {
  const auto& sensor = outcome.mill_case.sensors.accelerometer;
  if (!sensor || sensor->duration <= outcome.mill_case.run.time) return;
  list.push_back(note("short-record",
                      fmt::format("The record of the accelerometer ends with the run, after {} "
                                  "instead of {}.",
                                  show_rounded(outcome.mill_case.run.time, "s"),
                                  show_rounded(sensor->duration, "s"))));
}

}  // namespace

Notices sensor_warnings(const Outcome& outcome) {
  Notices list;
  short_record(outcome, list);
  merged_hits(outcome, list);
  softened_impacts(outcome, list);
  return list;
}

}  // namespace mahlwerk::results

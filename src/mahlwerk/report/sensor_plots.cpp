// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/sensor_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/readable.hpp"
#include "mahlwerk/results/quantities/sensors.hpp"

namespace mahlwerk::report {

using results::Table;

namespace {

/// A column of the readings over time.
Plot readings_plot(const results::Outcome& outcome, std::string title, std::string_view name,
                   std::string_view words, std::string_view unit_name) {
  const Table table = results::power_readings(outcome);
  const Multiple unit = multiple(largest(column(table, name)), unit_name);
  return {.title = std::move(title),
          .x = {.label = "time (s)", .least = 0},
          .y = {.label = fmt::format("{} ({})", words, unit.unit)},
          .series = {{"", column(table, "time"), column(table, name, unit.factor), {}, Mark::line}},
          .height = 260};
}

}  // namespace

Plot power_meter_plot(const results::Outcome& outcome) {
  return readings_plot(outcome, "Power of the motor", "motor_power", "power", "W");
}

Plot torque_plot(const results::Outcome& outcome) {
  return readings_plot(outcome, "Torque of the balls on the shaft", "torque", "torque", "N m");
}

Plot microphone_plot(const results::Outcome& outcome) {
  const Table table = results::heard_hits(outcome);
  const std::vector<double> energy = column(table, "energy_low"),
                            rate = column(table, "rate_above");
  const Multiple unit = multiple(largest(energy), "J");
  Plot plot{
      .title = "Hits that the microphone hears",
      .x = {.label = fmt::format("normal energy of a hit ({})", unit.unit), .logarithmic = true},
      .y = {.label = "hits per second with at least this energy", .logarithmic = true},
      .series = {{"", column(table, "energy_low", unit.factor), rate, {}, Mark::line}},
      .height = 300};
  constexpr double decades = 1e7;  // the weakest bounces of a settling ball are not drawn
  if (!energy.empty() && energy.front() < energy.back() / decades)
    plot.x.least = energy.back() / unit.factor / decades;
  return plot;
}

Plot accelerometer_plot(const results::Outcome& outcome) {
  constexpr std::size_t shown = 4000;  // samples, in which single impacts are still seen
  Table table = results::acceleration(outcome);
  table.rows.resize(std::min(table.rows.size(), shown));
  constexpr double milli = 1e-3;
  const std::vector<double> time = column(table, "time", milli);
  return {.title = "Acceleration of the jar",
          .x = {.label = "time (ms)", .least = 0},
          .y = {.label = "acceleration (m/s²)"},
          .series = {{"signal", time, column(table, "acceleration"), {}, Mark::line},
                     {"motion of the mill", time, column(table, "of_motion"), {}, Mark::line}},
          .height = 300};
}

Plot thermocouple_plot(const results::Outcome& outcome) {
  const Table table = results::thermocouple_readings(outcome);
  constexpr double minute = 60;
  const std::vector<double> time = column(table, "time", minute);
  return {.title = "Thermocouple",
          .x = {.label = "time (min)", .least = 0},
          .y = {.label = "temperature (°C)"},
          .series = {{"reading", time, column(table, "reading"), {}, Mark::line},
                     {"where it is", time, column(table, "surroundings"), {}, Mark::line}},
          .height = 280};
}

}  // namespace mahlwerk::report

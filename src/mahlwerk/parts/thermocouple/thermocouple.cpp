// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/thermocouple/thermocouple.hpp"

#include <string>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/heat.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/heat_share.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::parts::thermocouple {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

constexpr double zero_celsius = 273.15;  // [K]

void describe(cases::KeyVisitor& v, Thermocouple& sensor, const Case&) {
  v.word({"place",
          {"wall", "gas", "balls"},
          "wall",
          "a bore in the jar",
          "where the thermocouple is",
          {"in the jar's wall", "in the gas inside the jar", "at the balls"}},
         sensor.place);
  v.number({"lag",
            "s",
            {.least = 0, .most = 1e6},
            "time constant of the reading after a step",
            Thermocouple().lag,
            "a sheath of some millimetres in a bore; uncalibrated, 1-60 s"},
           sensor.lag);
}

void check(const Case& c, std::vector<Fault>& found) {
  if (c.heat) return;
  found.push_back({cases::location_of(c, "thermocouple.lag"),
                   "a thermocouple needs the temperatures of [heat]",
                   "add [heat], which may be empty, or remove [thermocouple]", "no-temperature"});
}

powder::Thermocouple thermocouple(const Case& c) {
  using Place = Thermocouple::Place;
  const Thermocouple& sensor = *c.parts.find<Thermocouple>();
  const double gas =
      powder::share_of_balls_in_gas(cases::balls_surface(c), results::wall_area(*c.jar.shape));
  return {sensor.place == Place::wall ? 0 : sensor.place == Place::balls ? 1 : gas, sensor.lag};
}

/// Temperatures around the thermocouple and its readings.
struct ThermocoupleRecord {
  std::vector<double> times;             ///< [s]
  std::vector<double> around, readings;  ///< [K]
  std::size_t last_milling = 0;          ///< index of the end of the last milling
};

/// `power` [W] is dissipated during milling, the share `in_balls` of it in the balls.
ThermocoupleRecord thermocouple_record(const Case& c, double power, double in_balls) {
  const powder::HeatNodes nodes = cases::heat_nodes(c, results::wall_area(*c.jar.shape));
  const powder::MillCycles cycles = cases::mill_cycles(c, power, in_balls);
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

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<Thermocouple>() != nullptr; };
  return results::where(
      present, "with `[thermocouple]`",
      {{"thermocouple_reading",
        "degC",
        "reading of the thermocouple at the end of the last milling",
        [](const Case& c, const Replicate& r) {
          const ThermocoupleRecord record = thermocouple_record(c, results::dissipated_power(r),
                                                                results::heat_share_in_balls(c, r));
          return record.readings[record.last_milling] - zero_celsius;
        },
        {.range = results::any_value, .equation = "sns.8", .heading = "Thermocouple"}}});
}

/// Readings over milling and pauses.
Table readings(const Outcome& outcome) {
  Table table{{{"time", "s", "time since the mill was first switched on"},
               {"surroundings", "degC", "temperature where the thermocouple is"},
               {"reading", "degC", "what it shows"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const Case& c = outcome.mill_case;
  const ThermocoupleRecord record = thermocouple_record(
      c,
      results::mean_over(chosen, [](const Replicate& r) { return results::dissipated_power(r); }),
      results::mean_over(chosen,
                         [&](const Replicate& r) { return results::heat_share_in_balls(c, r); }));
  for (std::size_t i = 0; i < record.times.size(); ++i)
    table.rows.push_back(
        {record.times[i], record.around[i] - zero_celsius, record.readings[i] - zero_celsius});
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"thermocouple", "readings of the thermocouple", readings(outcome)}};
}

report::Plot plot_of(const Outcome& outcome) {
  const Table table = readings(outcome);
  constexpr double minute = 60;
  const std::vector<double> time = report::column(table, "time", minute);
  return {
      .title = "Thermocouple",
      .x = report::Axis{.label = "time (min)", .least = 0},
      .y = report::Axis{.label = "temperature (°C)"},
      .series =
          {{"reading", time, report::column(table, "reading"), {}, report::Mark::line},
           {"where it is", time, report::column(table, "surroundings"), {}, report::Mark::line}},
      .shape = 0.39};
}

std::string panel(const Outcome& outcome) {
  return report::figure(plot_of(outcome),
                        "What the thermocouple shows, and the temperature where it is.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "thermocouple",
      .sections = {cases::section_of<Thermocouple, describe>(
          {"thermocouple", "", "temperature with the lag of a sensor; may be empty"})},
      .check = check,
      .quantities = quantities,
      .tables = tables,
      .heading = "Sensors",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::thermocouple

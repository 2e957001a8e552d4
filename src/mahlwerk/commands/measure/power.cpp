// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure power: idle and loaded power of a mill from the log of a power meter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/measure/measure.hpp"
#include "mahlwerk/commands/measure/measured.hpp"
#include "mahlwerk/commands/measure/sound_words.hpp"
#include "mahlwerk/measure/power_levels.hpp"
#include "mahlwerk/measure/propagation.hpp"
#include "mahlwerk/measure/readings.hpp"

namespace mahlwerk::commands {
namespace {

struct PowerArguments {
  std::string file, columns;
  std::string idle, load;  ///< "10 s to 60 s"; idle also a file
  std::string accuracy, efficiency;
  int jars = 0;
  MeasureOutput output;
};

constexpr std::string_view power_columns = "time (s), power (W)";

struct PowerLog {
  std::vector<double> time, power;  ///< [s], [W]; without times `time` is empty
};

PowerLog read_log(const std::string& file, const std::string& columns) {
  const measure::Readings table =
      measure::read_readings(measure::file_contents(file), file, columns);
  const measure::ReadingColumn* power =
      table.find({"power", "p", "active power", "leistung", "wirkleistung"});
  if (power == nullptr) measure::missing_column(table, "power", power_columns);
  PowerLog log{{}, measure::in_unit(table, *power, "W", 10)};
  if (const measure::ReadingColumn* time = table.find({"time", "t", "zeit", "timestamp"})) {
    log.time = measure::in_unit(table, *time, "s");
    const double begin = log.time.front();
    for (double& t : log.time) t -= begin;
  }
  return log;
}

/// "10 s to 60 s" as times; none if the words are no such window.
std::optional<std::pair<double, double>> window_in(const std::string& words,
                                                   std::string_view option) {
  const std::size_t at = words.find(" to ");
  if (at == std::string::npos) return std::nullopt;
  const double from = option_quantity(words.substr(0, at), "s", option, 0),
               to = option_quantity(words.substr(at + 4), "s", option, 0);
  return std::pair(from, to);
}

/// The readings of a window of time.
std::vector<double> readings_in(const PowerLog& log, std::pair<double, double> window,
                                std::string_view option) {
  if (log.time.empty())
    throw InputError(Fault{std::string(option), "the log has no times",
                           "name its column: --columns \"time (s), power (W)\"", "bad-readings"});
  std::vector<double> made;
  for (std::size_t i = 0; i < log.power.size(); ++i)
    if (log.time[i] >= window.first && log.time[i] <= window.second) made.push_back(log.power[i]);
  return made;
}

/// Readings of both states: by windows, from two files, or by the two levels of a log.
measure::TwoLevels levels_of_log(const PowerArguments& given) {
  const PowerLog log = read_log(given.file, given.columns);
  measure::TwoLevels made;
  const auto load = given.load.empty() ? std::nullopt : window_in(given.load, "--load");
  if (!given.load.empty() && !load)
    throw InputError(Fault{"--load " + given.load, "this is no part of the log",
                           "write for instance --load \"80 s to 200 s\", in s since its begin",
                           "bad-command-line"});
  if (given.idle.empty()) {
    if (load)
      throw InputError(Fault{"--load", "the idle mill is missing",
                             "give --idle FILE or --idle \"10 s to 60 s\", too",
                             "bad-command-line"});
    return measure::two_levels(log.power);
  }
  made.load = load ? readings_in(log, *load, "--load") : log.power;
  if (const auto idle = window_in(given.idle, "--idle")) {
    made.idle = readings_in(log, *idle, "--idle");
    if (!load)
      throw InputError(Fault{"--idle " + given.idle, "the part of the loaded mill is missing",
                             "give --load \"80 s to 200 s\", too", "bad-command-line"});
  } else {
    if (!std::filesystem::exists(given.idle))
      throw InputError(Fault{"--idle " + given.idle, "this is neither a file nor a part of the log",
                             "write for instance --idle \"10 s to 60 s\"", "no-such-file"});
    made.idle = at_file(given.idle, [&] { return read_log(given.idle, given.columns).power; });
  }
  return made;
}

/// The level with the error of the meter.
observe::Estimate with_accuracy(const measure::PowerLevel& level, double accuracy) {
  const double meter = accuracy * level.power.mean;
  return {level.power.mean, std::sqrt(level.power.ci95 * level.power.ci95 + meter * meter)};
}

void remark_drift(const measure::PowerLevel& level, std::string_view state,
                  measure::Findings& found) {
  if (level.drift != 0)
    found.remarks.push_back(fmt::format(
        "The {} power drifts by {} from begin to end: let the mill run warm before you record.",
        state, show_rounded(level.drift, "W", 2)));
}

measure::Findings power_findings(const PowerArguments& given, const measure::TwoLevels& readings) {
  const double accuracy =
      given.accuracy.empty() ? 0 : option_quantity(given.accuracy, "", "--accuracy", 0, 0.5);
  const measure::PowerLevel idle = measure::power_level(readings.idle),
                            load = measure::power_level(readings.load);
  if (!(load.power.mean > idle.power.mean))
    throw InputError(
        Fault{"",
              fmt::format("the loaded mill takes {}, no more than the idle one, {}",
                          show_rounded(load.power.mean, "W"), show_rounded(idle.power.mean, "W")),
              "exchange both logs, or check the readings", "bad-readings"});
  // The meter's own error is mostly a factor, common to both.
  const double net = load.power.mean - idle.power.mean;
  const double error =
      std::sqrt(load.power.ci95 * load.power.ci95 + idle.power.ci95 * idle.power.ci95 +
                accuracy * accuracy * net * net);
  measure::Findings found{
      {{"power_meter.idle_power", "idle power", "W", with_accuracy(idle, accuracy)},
       {"", "power under load", "W", with_accuracy(load, accuracy)},
       {"", "net power: of all charges, over efficiency", "W", {net, error}}},
      {},
      {}};
  if (!given.efficiency.empty()) {
    const observe::Estimate eta = quantity_with_error(given.efficiency, "", "--efficiency");
    if (eta.mean > 1)
      throw InputError(Fault{"--efficiency " + given.efficiency, "it is above 1",
                             "write for instance --efficiency \"0.8 +- 0.1\"", "out-of-range"});
    found.list.push_back({"power_meter.efficiency", "efficiency, as given", "", eta});
    found.list.push_back({"", "power that a charge draws", "W",
                          measure::propagated({{net, error}, eta}, [&](const auto& in) {
                            return std::vector{in[0] * in[1] / std::max(1, given.jars)};
                          }).results[0]});
  }
  if (given.accuracy.empty())
    found.remarks.emplace_back(
        "The intervals hold scatter alone. Give the error of the meter: --accuracy \"1 %\".");
  if (error > 0.3 * net)
    found.remarks.emplace_back(
        "The net power is a small difference of two large ones: more balls or a higher speed show "
        "it better.");
  if (std::min(idle.readings, load.readings) < 50)
    found.remarks.emplace_back(
        "Fewer than 50 readings of a state: where they follow each other slowly, the interval is "
        "too "
        "narrow.");
  remark_drift(idle, "idle", found);
  remark_drift(load, "loaded", found);
  return found;
}

int measure_power(const PowerArguments& given) {
  const measure::TwoLevels readings = at_file(given.file, [&] { return levels_of_log(given); });
  Measured measured{.title = fmt::format("Power log {}: {} readings idle, {} under load",
                                         given.file, readings.idle.size(), readings.load.size()),
                    .source = fmt::format("power log {}, 95 % interval",
                                          std::filesystem::path(given.file).filename().string()),
                    .found = at_file(given.file, [&] { return power_findings(given, readings); })};
  const observe::Estimate& load = measured.found.list[1].value;
  measured.row = {{"motor_power (W)", fmt::format("{:.6g}", load.mean)},
                  {"motor_power_error (W)", fmt::format("{:.4g}", load.ci95 / 1.96)}};
  measured.more =
      "A case compares its motor_power with this one: give [power_meter] idle_power, and let\n"
      "mahlwerk fit find contact.restitution, power_meter.efficiency or both from several speeds "
      "(--data).\n";
  return report_measured(given.output, measured);
}

Options power_options(PowerArguments& given) {
  return {{.name = "FILE",
           .target = &given.file,
           .about = "a log (CSV: power, and time where parts are given)",
           .required = true},
          {.name = "--idle",
           .target = &given.idle,
           .about = "the mill with empty jars: another log, or a part of this one, \"10 s to 60 "
                    "s\" (default: the lower of two levels)"},
          {.name = "--load",
           .target = &given.load,
           .about = "part of the log with the filled jars: \"80 s to 200 s\""},
          {.name = "--columns",
           .target = &given.columns,
           .about = "headings in place of those of the log: \"time (s), power (W)\""},
          {.name = "--accuracy", .target = &given.accuracy, .about = "error of the meter: \"1 %\""},
          {.name = "--efficiency",
           .target = &given.efficiency,
           .about = "of the drive, if you know it: \"0.8 +- 0.1\""},
          {.name = "--jars",
           .target = &given.jars,
           .about = "number of filled jars (default 1)",
           .range = {1, 100}}};
}

}  // namespace

Command measure_power_command() {
  const auto given = std::make_shared<PowerArguments>();
  return {"power", "idle and loaded power of a mill from the log of a power meter",
          joined({power_options(*given), data_options(given->output), case_options(given->output)}),
          [given] { return measure_power(*given); }};
}

}  // namespace mahlwerk::commands

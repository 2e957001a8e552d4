// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Temperatures of balls and jar over milling and pauses: the section [heat], whose cycles the whole
// run knows (docs/theory/wear-heat.md).
#include <optional>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/heat_share.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::parts::heat {
namespace {

using cases::Case;
using cases::Heat;
using results::Outcome;
using results::Replicate;
using results::Table;

constexpr double zero_celsius = 273.15;  // [K]

/// [s] Milling in one of the cycles that [heat] gives, if another section states the whole
/// time.
std::optional<double> milling_of_a_cycle(cases::SectionReader& in) {
  if (!in.findings().milling_time) return std::nullopt;
  const cases::Node* cycles = in.find("cycles");
  const double count = cycles == nullptr ? 1 : cases::whole_number(*cycles).value_or(1);
  return *in.findings().milling_time / count;
}

/// With `pause` or `cycles`, the milling time is required, here or in another section, and with
/// `pause` also `cycles`. By default the mill runs for an hour without a pause.
void describe(cases::KeyVisitor& v, Heat& heat, const Case&) {
  cases::NumberSpec milling("milling", "s", positive, "milling time of each cycle", Heat().milling,
                            "an hour without a pause");
  cases::IntegerSpec cycles{.key = "cycles",
                            .least = 1,
                            .most = 10'000,
                            .about = "number of cycles of milling and pause",
                            .standard = 1,
                            .source = "without a pause there is one"};
  const bool pauses = v.gives("pause");
  if (pauses) cycles.standard.reset();
  if (v.gives("cycles") || pauses) milling.standard.reset();
  if (cases::SectionReader* in = v.reader())
    if (const auto time = milling_of_a_cycle(*in))
      milling = milling.with_default(*time, "milling time of the case over its cycles");
  v.number(milling, heat.milling);
  v.number({"pause", "s", not_negative, "pause after each milling", Heat().pause, "none"},
           heat.pause);
  v.integer(cycles, heat.cycles);
  v.number({"ambient", "K", positive, "temperature of the air, and of everything at the start",
            Heat().ambient, "room temperature"},
           heat.ambient);
  v.number(
      {"cooling", "W/m2/K", positive, "heat from the jar's wall to the air, by area and kelvin",
       Heat().cooling, "natural to mild forced convection of air, textbooks: 5-50; uncalibrated"},
      heat.cooling);
  v.number({"ball_exchange", "W/m2/K", positive,
            "heat from the balls to the jar, by area of the balls and kelvin", Heat().ball_exchange,
            "gas between balls in motion and the wall, 10-200 (hea.6); uncalibrated"},
           heat.ball_exchange);
  v.optional_number(
      cases::NumberSpec("share_in_balls", "", {.least = 0, .most = 1},
                        "share of the lost power that heats the balls, the rest the jar")
          .with_default_text(
              "by the collisions: all that those between balls lose, half of the rest"),
      heat.share_in_balls);
  if (cases::SectionReader* in = v.reader(); in != nullptr && !in->findings().milling_time) {
    in->findings().milling_time = heat.milling * static_cast<double>(heat.cycles);
    in->findings().milling_time_of = "heat";
  }
}

/// Temperatures at the end of the last milling period, for the replicate's dissipated power.
powder::HeatPoint at_the_end(const Case& c, const Replicate& r) {
  const powder::HeatNodes nodes = cases::heat_nodes(c, results::wall_area(*c.jar.shape));
  const powder::MillCycles mill =
      cases::mill_cycles(c, results::dissipated_power(r), results::heat_share_in_balls(c, r));
  const double end = (mill.milling + mill.pause) * static_cast<double>(mill.cycles) - mill.pause;
  powder::HeatPoint last;
  for (const powder::HeatPoint& p : powder::temperature_history(nodes, mill))
    if (p.time <= end * (1 + 1e-12)) last = p;
  return last;
}

results::Measures quantities() {
  const auto warms = [](const Case& c) { return c.heat.has_value(); };
  return results::where(
      warms, "with `[heat]`",
      {
          {"temperature_balls",
           "degC",
           "temperature of the balls at the end of the last milling",
           [](const Case& c, const Replicate& r) { return at_the_end(c, r).balls - zero_celsius; },
           {.range = results::any_value,
            .label = "temperature of the balls",
            .heading = "Temperatures",
            .key = 8}},
          {"temperature_jar",
           "degC",
           "temperature of the jar at the end of the last milling",
           [](const Case& c, const Replicate& r) { return at_the_end(c, r).jar - zero_celsius; },
           {.range = results::any_value, .label = "temperature of the jar"}},
          {"heat_share_in_balls",
           "1",
           "share of the dissipated power that heats the balls first; the rest heats the jar",
           results::heat_share_in_balls,
           {.range = results::share_of_whole,
            .label = "share of heat in the balls",
            .equation = "hea.12"}},
          {"flash_rise_mean",
           "K",
           "mean flash temperature rise at the contact of a collision, weighted by the energy "
           "lost; an "
           "upper estimate, as the heat that powder takes is neglected",
           [](const Case&, const Replicate& r) {
             double rise = 0, lost = 0;
             for (int pair = 0; pair < r.tally.by_pair.pairs(); ++pair) {
               rise += r.tally.by_pair[pair].flash;
               lost += r.tally.by_pair[pair].spectra.energy_lost.sum();
             }
             return results::share(rise, lost);
           },
           {.label = "mean flash temperature rise"}},
      });
}

Table temperatures(const Outcome& outcome) {
  Table table{{{"time", "s", "time since the mill was first switched on"},
               {"balls", "degC", "temperature of the balls"},
               {"jar", "degC", "temperature of the jar"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const Case& c = outcome.mill_case;
  const double power = results::mean_over(
                   chosen, [](const Replicate&r) { return results::dissipated_power(r); }),
               in_balls = results::mean_over(
                   chosen, [&](const Replicate&r) { return results::heat_share_in_balls(c, r); });
  const powder::HeatNodes nodes = cases::heat_nodes(c, results::wall_area(*c.jar.shape));
  for (const powder::HeatPoint& p :
       powder::temperature_history(nodes, cases::mill_cycles(c, power, in_balls)))
    table.rows.push_back({p.time, p.balls - zero_celsius, p.jar - zero_celsius});
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"temperature", "temperatures of balls and jar over milling and pauses",
           temperatures(outcome)}};
}

report::Plot temperature_plot(const Outcome& outcome) {
  const Table table = temperatures(outcome);
  constexpr double minute = 60;
  return {.title = "Temperature over milling and pauses",
          .x = report::Axis{.label = "time (min)", .least = 0},
          .y = report::Axis{.label = "temperature (°C)"},
          .series = {{"balls",
                      report::column(table, "time", minute),
                      report::column(table, "balls"),
                      {},
                      report::Mark::line},
                     {"jar",
                      report::column(table, "time", minute),
                      report::column(table, "jar"),
                      {},
                      report::Mark::line}},
          .shape = 0.39};
}

std::string panel(const Outcome& outcome) {
  return report::figure(temperature_plot(outcome),
                        "Balls and jar as two lumped heat capacities, heated by the dissipated "
                        "power, cooled by the air.");
}

bool needs(const Case&, std::string_view key) {
  return key.ends_with("conductivity") || key.ends_with("heat_capacity") || key == "jar.wall" ||
         key == "jar.density";
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{.name = "heat",
                                .sections = {cases::section_in_case<&Case::heat, describe>(
                                    {"heat", "", "temperatures of balls and jar; may be empty"})},
                                .needs = needs,
                                .quantities = quantities,
                                .tables = tables,
                                .heading = "Temperatures",
                                .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::heat

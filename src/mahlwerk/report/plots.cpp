// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/tables.hpp"

namespace mahlwerk::report {

using results::Table;

Plot spectrum_plot(const results::Outcome& outcome) {
  // The bounces of a settling ball span any number of decades: only the top seven are drawn.
  constexpr double decades = 1e7, depth = 1e5;
  const Table table = results::spectrum(outcome);
  std::vector<double> edges = column(table, "energy_low");
  if (!table.rows.empty()) edges.push_back(table.rows.back()[1]);
  const Multiple unit = multiple(largest(edges), "J");
  for (double& e : edges) e /= unit.factor;
  const auto normal = column(table, "rate_normal");
  const auto point = column(table, "rate_contact_point");
  Plot plot{"Spectrum of impact energies",
            Axis{fmt::format("energy of one collision ({})", unit.unit), true},
            Axis{"collisions per second and bin", true},
            {{"normal motion", edges, normal, {}, Mark::steps},
             {"contact point (normal and slip)", edges, point, {}, Mark::steps}}};
  const double most = largest(edges), often = std::max(largest(normal), largest(point));
  if (edges.size() > 2 && edges[1] < most / decades) plot.x.least = most / decades;
  if (often > 0) {
    double rare = often;
    for (const auto* values : {&normal, &point})
      for (const double v : *values)
        if (v > 0) rare = std::min(rare, v);
    plot.y.least = std::max(0.7 * rare, often / depth);
  }
  return plot;
}

Plot energy_weighted_plot(const results::Outcome& outcome) {
  constexpr double decades = 1e5;
  const Table table = results::spectrum(outcome);
  std::vector<double> edges = column(table, "energy_low");
  if (!table.rows.empty()) edges.push_back(table.rows.back()[1]);
  const Multiple energy = multiple(largest(edges), "J");
  for (double& e : edges) e /= energy.factor;
  const Multiple power = multiple(largest(column(table, "power_normal")), "W");
  Plot plot{"Power by impact energy",
            Axis{fmt::format("energy of one collision ({})", energy.unit), true},
            Axis{fmt::format("power per bin ({})", power.unit)},
            {{"normal motion", edges, column(table, "power_normal", power.factor), {}, Mark::steps},
             {"dissipated", edges, column(table, "power_lost", power.factor), {}, Mark::steps}},
            0.42};
  if (edges.size() > 2 && edges[1] < edges.back() / decades) plot.x.least = edges.back() / decades;
  return plot;
}

Plot angle_plot(const results::Outcome& outcome) {
  const Table table = results::angles(outcome);
  std::vector<double> edges = column(table, "angle_low");
  edges.push_back(90);
  return {.title = "Impact angle of collisions above the threshold",
          .x = Axis{.label = "angle (°), 0 head-on, 90 grazing", .least = 0, .most = 90},
          .y = Axis{.label = "collisions per second and degree"},
          .series = {{"", edges, column(table, "rate_above_threshold"), {}, Mark::steps}},
          .shape = 0.36};
}

Plot rate_plot(const results::Outcome& outcome) {
  const Table table = results::time_series(outcome);
  const std::string threshold = threshold_text(outcome.mill_case.observe.threshold);
  return {.title = "Collisions with a normal speed of at least " + threshold,
          .x = Axis{.label = "time (s)", .least = 0},
          .y = Axis{.label = "collisions per second"},
          .series = {{"",
                      column(table, "time"),
                      column(table, "collision_rate_above_threshold"),
                      {},
                      Mark::line}},
          .shape = 0.36};
}

Plot power_plot(const results::Outcome& outcome) {
  const Table table = results::time_series(outcome);
  const auto dissipated = column(table, "dissipated_power");
  const Multiple unit = multiple(largest(dissipated), "W");
  const auto time = column(table, "time");
  return {.title = "Power",
          .x = Axis{.label = "time (s)", .least = 0},
          .y = Axis{.label = fmt::format("power ({})", unit.unit)},
          .series =
              {{"dissipated", time, column(table, "dissipated_power", unit.factor), {}, Mark::line},
               {"power input by the jar",
                time,
                column(table, "drawn_power", unit.factor),
                {},
                Mark::line}},
          .shape = 0.39};
}

}  // namespace mahlwerk::report

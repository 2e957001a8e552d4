// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/grinding/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"

namespace mahlwerk::parts::grinding {
namespace {

using report::Axis;
using report::column;
using report::largest;
using report::Mark;
using report::Multiple;
using report::multiple;
using report::Plot;
using report::time_unit;
using results::Outcome;
using results::Table;

constexpr std::size_t palette = 7,
                      grey = palette - 1;  // number of colours; higher indices are dashed
constexpr double micrometre = 1e-6;

/// The rows of capture.csv of one kind of pair.
struct Kind {
  std::string name;
  double power = 0;
  Table rows;
};

/// The kinds with the most power, as many as a plot has colours.
std::vector<Kind> kinds(const Table& table) {
  std::map<std::pair<double, double>, Kind> found;
  const auto energy = column(table, "energy"), rate = column(table, "rate");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    Kind& kind = found[{row[0], row[1]}];
    if (kind.name.empty()) {
      kind.name = table.columns[0].words[static_cast<std::size_t>(row[0])] + " with " +
                  table.columns[1].words[static_cast<std::size_t>(row[1])];
      kind.rows.columns = table.columns;
    }
    kind.power += rate[i] * energy[i];
    kind.rows.rows.push_back(row);
  }
  std::vector<Kind> list;
  for (auto& entry : found) list.push_back(std::move(entry.second));
  std::ranges::stable_sort(list, std::ranges::greater{}, &Kind::power);
  constexpr std::size_t most = 7;
  if (list.size() > most) list.resize(most);
  return list;
}

/// A column of capture.csv over the energy of the collision, for each kind of pair.
Plot by_energy(const results::Outcome& outcome, std::string_view name, double factor) {
  constexpr double decades = 1e6;  // weaker bounces capture next to nothing
  const Table table = results::capture(outcome);
  const double most = largest(column(table, "energy"));
  const Multiple unit = multiple(most, "J");
  Plot plot{.title = "",
            .x = Axis{.label = fmt::format("energy of one collision ({})", unit.unit),
                      .logarithmic = true},
            .y = Axis{.label = "", .logarithmic = true},
            .series = {},
            .shape = 0.42};
  for (Kind& kind : kinds(table)) {
    std::erase_if(kind.rows.rows,
                  [&](const auto& row) { return row[2] < most / decades; });  // the energy
    plot.series.push_back({kind.name,
                           column(kind.rows, "energy", unit.factor),
                           column(kind.rows, name, factor),
                           {},
                           Mark::line});
  }
  if (plot.series.size() == 1) plot.series[0].name.clear();
  return plot;
}

/// Axes for quantities over the time of milling. The time axis begins shortly before the first
/// change.
Plot over_log_time(const results::Outcome& outcome) {
  const Table table = results::grinding(outcome);
  const auto times = column(table, "time");
  std::vector<double> finest = column(table, "d10");
  if (finest.empty()) finest = column(table, "sample_d10");
  const Multiple unit = time_unit(largest(times));
  Plot plot{.title = "",
            .x = Axis{.label = fmt::format("time of milling ({})", unit.unit), .logarithmic = true},
            .y = Axis{.label = "", .logarithmic = true},
            .series = {}};
  constexpr double still = 0.98, before = 0.5;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (finest[i] < still * finest[0] || i + 1 == times.size()) {
      plot.x.least = before * times[i] / unit.factor;
      break;
    }
  return plot;
}

/// Prefixes of column names: "sample_" for the sample of grains beside a population balance.
constexpr std::array<std::string_view, 2> method_prefixes{"", "sample_"};

/// Index of a colour, of its dashed version for the sample.
std::size_t drawn(std::size_t colour, std::string_view method) {
  return colour + (method.empty() ? 0 : palette);
}

/// The rows of size_distribution.csv of one time.
struct Moment {
  std::string name;
  Table rows;
};

std::vector<Moment> moments(const Table& table) {
  std::vector<Moment> list;
  const std::vector<double> times = column(table, "time");
  const Multiple unit = time_unit(largest(times));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i == 0 || times[i] != times[i - 1])
      list.push_back(
          {times[i] > 0 ? fmt::format("{:.3g} {}", times[i] / unit.factor, unit.unit) : "feed",
           {table.columns, {}}});
    list.back().rows.rows.push_back(table.rows[i]);
  }
  return list;
}

/// Limits the size axis to the range that contains all but a thousandth of the mass.
void limit_axis_to_data(const Table& table, Axis& axis) {
  constexpr double little = 1e-3;
  const auto passing = column(table, "passing"), upper = column(table, "size_high", micrometre),
             lower = column(table, "size_low", micrometre);
  double least = INFINITY, most = 0;
  for (std::size_t i = 0; i < passing.size(); ++i) {
    if (passing[i] > little) least = std::min(least, lower[i]);
    if (passing[i] < 1 - little) most = std::max(most, upper[i]);
  }
  constexpr double room = 1.3;
  if (least < room * room * most) axis.least = least, axis.most = room * most;
}

}  // namespace

Plot capture_plot(const results::Outcome& outcome) {
  Plot plot = by_energy(outcome, "grains", 1);
  plot.title = "Grains captured by a collision";
  plot.y.label = "grains";
  return plot;
}

Plot captured_energy_plot(const results::Outcome& outcome) {
  constexpr double per_gram = 1000;
  Plot plot = by_energy(outcome, "specific_energy", per_gram);
  plot.title = "Energy of captured grains per mass";
  plot.y.label = "J/g";
  return plot;
}

Plot captured_grains_plot(const results::Outcome& outcome) {
  const Table table = results::captured_grains(outcome);
  constexpr double per_octave = 4;
  std::map<int, std::array<double, 2>> bins;  // by their upper edge, in quarters of an octave
  double rates = 0, powers = 0;
  for (const auto& row : table.rows) {
    bins[static_cast<int>(std::lround(per_octave * std::log2(row[1])))] = {row[2], row[3]};
    rates += row[2];
    powers += row[3];
  }
  std::vector<double> edges, often, hard;
  constexpr double percent = 100;
  if (!bins.empty()) {
    edges.push_back(std::exp2((bins.begin()->first - 1) / per_octave));
    for (int bin = bins.begin()->first; bin <= bins.rbegin()->first; ++bin) {
      edges.push_back(std::exp2(bin / per_octave));
      often.push_back(percent * bins[bin][0] / rates);
      hard.push_back(percent * bins[bin][1] / powers);
    }
  }
  return {.title = "Collisions by number of captured grains",
          .x = Axis{.label = "captured grains", .logarithmic = true},
          .y = Axis{.label = "share in a bin (%)"},
          .series = {{"of their energy", edges, hard, {}, Mark::steps},
                     {"of the collisions", edges, often, {}, Mark::steps}},
          .shape = 0.39};
}

Plot sizes_plot(const results::Outcome& outcome) {
  Plot plot = over_log_time(outcome);
  plot.title = "Sizes over time of milling";
  plot.y.label = "size (µm)";
  const Table table = results::grinding(outcome);
  const std::vector<double> times =
      column(table, "time", time_unit(largest(column(table, "time"))).factor);
  for (const std::string_view method : method_prefixes) {
    std::size_t colour = 0;
    for (const std::string_view name : {"d90", "d50", "d10"}) {
      const auto sizes = column(table, fmt::format("{}{}", method, name), micrometre);
      const bool sample = !method.empty();
      if (!sizes.empty())
        plot.series.push_back(
            {sample ? report::label(name) + " of the sample" : report::label(name),
             times,
             sizes,
             {},
             Mark::line,
             drawn(colour, method)});
      ++colour;
    }
  }
  return plot;
}

Plot passing_plot(const results::Outcome& outcome) {
  const Table table = results::size_distribution(outcome);
  Plot plot{.title = "Share of the mass finer than a size",
            .x = Axis{.label = "size (µm)", .logarithmic = true},
            .y = Axis{.label = "finer (%)", .least = 0, .most = 100},
            .series = {}};
  limit_axis_to_data(table, plot.x);
  for (const std::string_view method : method_prefixes) {
    std::size_t colour = grey;
    for (const Moment& moment : moments(table)) {
      std::vector<double> sizes = column(moment.rows, "size_high", micrometre),
                          finer = column(moment.rows, fmt::format("{}passing", method), 0.01);
      if (!finer.empty()) {
        // Mass is uniform in the logarithm of size within a class: straight lines are exact.
        sizes.insert(sizes.begin(), column(moment.rows, "size_low", micrometre).front());
        finer.insert(finer.begin(), 0);
        plot.series.push_back({method.empty() ? moment.name : "",
                               sizes,
                               finer,
                               {},
                               Mark::line,
                               drawn(colour, method)});
      }
      colour = (colour + 1) % palette;
    }
  }
  return plot;
}

Plot density_plot(const results::Outcome& outcome) {
  const Table table = results::size_distribution(outcome);
  Plot plot{.title = "Share of the mass by size",
            .x = Axis{.label = "size (µm)", .logarithmic = true},
            .y = Axis{.label = "share per unit of ln(size)", .least = 0},
            .series = {}};
  limit_axis_to_data(table, plot.x);
  double feed = 0, milled = 0;
  for (const std::string_view method : method_prefixes) {
    std::size_t colour = grey;
    for (const Moment& moment : moments(table)) {
      const std::vector<double> low = column(moment.rows, "size_low", micrometre),
                                high = column(moment.rows, "size_high", micrometre),
                                density = column(moment.rows, fmt::format("{}density", method));
      std::vector<double> middle;
      for (std::size_t i = 0; i < low.size(); ++i) middle.push_back(std::sqrt(low[i] * high[i]));
      if (!density.empty())
        plot.series.push_back({method.empty() ? moment.name : "",
                               middle,
                               density,
                               {},
                               Mark::line,
                               drawn(colour, method)});
      double& most = colour == grey ? feed : milled;
      most = std::max(most, largest(density));
      colour = (colour + 1) % palette;
    }
  }
  // The narrow peak of a feed of one size would flatten all other curves.
  constexpr double needle = 2, air = 1.1;
  if (milled > 0 && feed > needle * milled) plot.y.most = air * milled;
  return plot;
}

Plot surface_plot(const results::Outcome& outcome) {
  Plot plot = over_log_time(outcome);
  plot.title = "Specific surface over time of milling";
  plot.y.label = "m²/kg";
  plot.shape = 0.39;
  const Table table = results::grinding(outcome);
  const double longest = largest(column(table, "time"));
  for (const std::string_view method : method_prefixes)
    if (const auto surface = column(table, fmt::format("{}specific_surface", method));
        !surface.empty())
      plot.series.push_back({method.empty() ? "of the balance" : "of the sample",
                             column(table, "time", time_unit(longest).factor),
                             surface,
                             {},
                             Mark::line,
                             drawn(0, method)});
  if (plot.series.size() == 1) plot.series[0].name.clear();
  return plot;
}

}  // namespace mahlwerk::parts::grinding

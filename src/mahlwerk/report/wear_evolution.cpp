// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/wear_evolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::report {
namespace {

using campaign::WearLife;
using campaign::WearNumber;
using campaign::WearStage;

constexpr double hour = 3600;  // [s]

std::string hours(double time) {
  if (!std::isfinite(time)) return "-";
  constexpr double many = 1000 * hour;
  return time < many ? fmt::format("{:.4g} h", time / hour) : fmt::format("{:.0f} h", time / hour);
}

std::string number(const WearNumber& n, std::string_view unit) {
  return readable(n.value, n.ci95, unit).text();
}

std::string life_sentence(const WearEvolution& all, const WearLife& life) {
  const std::string lost = fmt::format("{:.0f} % of its height", 100 * all.wear.worn_out);
  if (!std::isfinite(life.time))
    return fmt::format("{}: its height does not fall, so its life is unknown", life.profile);
  return fmt::format("{}: {} lost after {}{}", life.profile, lost, hours(life.time),
                     life.extrapolated ? ", extrapolated at the last rate" : "");
}

/// The heads and cells of the table of stages.
std::vector<std::string> heads(const WearEvolution& all) {
  std::vector<std::string> made{"time", "power", "wear of balls", "of the jar", "of parts"};
  for (const std::string& name : all.profiles) made.push_back("height of " + name);
  if (!all.sets.empty()) made.emplace_back("balls");
  return made;
}
std::vector<std::string> cells(const WearStage& s) {
  std::vector<std::string> made{hours(s.state.time), number(s.dissipated_power, "W"),
                                number(s.wear_rate_balls, "kg/s"), number(s.wear_rate_jar, "kg/s"),
                                number(s.wear_rate_parts, "kg/s")};
  for (const double h : s.heights) made.push_back(readable(h, std::nan(""), "m").text());
  double balls = 0;
  for (const powder::BallCharge& charge : s.state.charges)
    for (const powder::Cohort& c : charge) balls += c.number;
  if (!s.state.charges.empty()) made.push_back(fmt::format("{:.0f}", balls));
  return made;
}

std::string stage_rows(const WearEvolution& all) {
  std::string text = "<thead><tr>";
  for (const std::string& head : heads(all))
    text += fmt::format("<th class=\"n\">{}</th>", escaped(head));
  text += "</tr></thead>\n<tbody>\n";
  for (const WearStage& s : all.stages) {
    text += "<tr>";
    for (const std::string& cell : cells(s))
      text += fmt::format("<td class=\"n\">{}</td>", escaped(cell));
    text += "</tr>\n";
  }
  return text + "</tbody>\n";
}

/// Stages that stand for all: the first, the one in the middle of the time, and the last.
std::vector<std::size_t> shown_stages(const WearEvolution& all, std::size_t most) {
  std::vector<std::size_t> shown;
  const std::size_t n = all.stages.size();
  for (std::size_t i = 0; i < most && n > 0; ++i) {
    const std::size_t one = most > 1 ? i * (n - 1) / (most - 1) : 0;
    if (shown.empty() || shown.back() != one) shown.push_back(one);
  }
  return shown;
}

Plot profile_plot(const WearEvolution& all, std::size_t k) {
  double largest = 0;
  for (const geometry::PlanePoint& p : all.stages.front().state.sections[k])
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const Multiple unit = multiple(largest, "m");
  Plot plot{.title = "Section of " + all.profiles[k],
            .x = Axis{fmt::format("x ({})", unit.unit)},
            .y = Axis{fmt::format("y ({})", unit.unit)},
            .series = {}};
  constexpr std::size_t most = 6;
  for (const std::size_t i : shown_stages(all, most)) {
    Series series{.name = hours(all.stages[i].state.time)};
    geometry::Section section = all.stages[i].state.sections[k];
    section.push_back(section.front());
    for (const geometry::PlanePoint& p : section) {
      series.x.push_back(p.x / unit.factor);
      series.y.push_back(p.y / unit.factor);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// A number of each stage over the time.
template <class Of>
Plot over_time(const WearEvolution& all, const std::string& title, std::string_view unit, Of of) {
  double largest = 0;
  for (const WearStage& s : all.stages)
    if (const WearNumber n = of(s); std::isfinite(n.value))
      largest = std::max(largest, std::abs(n.value));
  const Multiple up = multiple(largest, unit);
  Series series{.name = "", .mark = Mark::points};
  for (const WearStage& s : all.stages) {
    const WearNumber n = of(s);
    if (!std::isfinite(n.value)) continue;
    series.x.push_back(s.state.time / hour);
    series.y.push_back(n.value / up.factor);
    series.error.push_back(std::isfinite(n.ci95) ? n.ci95 / up.factor : 0);
  }
  return {.title = title,
          .x = Axis{.label = "time of operation (h)", .least = 0},
          .y = Axis{.label = fmt::format("{} ({})", title, up.unit), .least = 0},
          .series = {series},
          .shape = 0.42};
}

Plot spectra_plot(const WearEvolution& all) {
  double largest = 0;
  for (const WearStage& s : all.stages)
    if (!s.spectrum_energies.empty()) largest = std::max(largest, s.spectrum_energies.back());
  const Multiple unit = multiple(largest, "J");
  Plot plot{.title = "Impact energies",
            .x = Axis{fmt::format("normal energy of one collision ({})", unit.unit), true},
            .y = Axis{"collisions per second and bin", true},
            .series = {}};
  constexpr double decades = 1e6;
  if (largest > 0) plot.x.least = largest / decades / unit.factor;
  for (const std::size_t i : shown_stages(all, 3)) {
    Series series{.name = hours(all.stages[i].state.time), .mark = Mark::steps};
    for (const double e : all.stages[i].spectrum_energies) series.x.push_back(e / unit.factor);
    series.y = all.stages[i].spectrum_rates;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// The mass below each size, at the start, half way and at the end, and in the steady state of
/// linear wear.
Plot sizes_plot(const WearEvolution& all, std::size_t set) {
  const double fresh = all.fresh_sizes[set];
  const Multiple unit = multiple(fresh, "m");
  Plot plot{.title = "Ball sizes of " + all.sets[set],
            .x = Axis{.label = fmt::format("diameter ({})", unit.unit), .least = 0},
            .y = Axis{.label = "share of the mass not above it", .least = 0, .most = 1},
            .series = {},
            .shape = 0.42};
  for (const std::size_t i : shown_stages(all, 3)) {
    const powder::BallCharge& charge = all.stages[i].state.charges[set];
    Series series{.name = hours(all.stages[i].state.time), .mark = Mark::points};
    const double whole = powder::volume_of(charge);
    double left = whole;
    for (const powder::Cohort& c : charge) {
      series.x.push_back(c.diameter / unit.factor);
      series.y.push_back(left / whole);
      left -= c.volume();
    }
    plot.series.push_back(std::move(series));
  }
  if (!all.wear.make_up) return plot;
  Series steady{.name = "steady state of linear wear (wea.15)", .mark = Mark::line};
  constexpr int points = 60;
  for (int i = 0; i <= points; ++i) {
    const double d = all.wear.scrap_size + (fresh - all.wear.scrap_size) * i / points;
    steady.x.push_back(d / unit.factor);
    steady.y.push_back(powder::steady_mass_below(d, all.wear.scrap_size, fresh, 0));
  }
  plot.series.push_back(std::move(steady));
  return plot;
}

results::Json lives_json(const WearEvolution& all) {
  results::Json lives = results::Json::array();
  for (const WearLife& life : all.lives)
    lives.push_back(results::Json::object(
        {{"profile", life.profile}, {"time_s", life.time}, {"extrapolated", life.extrapolated}}));
  return lives;
}

}  // namespace

std::string wear_evolution_text(const WearEvolution& all) {
  std::vector<std::vector<std::string>> rows{heads(all)};
  for (const WearStage& s : all.stages) rows.push_back(cells(s));
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += std::string(widths[i] - width(row[i]) + (i > 0 ? 2 : 0), ' ') + row[i];
    text += "\n";
  }
  text += "\n";
  for (const WearLife& life : all.lives) text += life_sentence(all, life) + "\n";
  return text;
}

std::string wear_evolution_json(const WearEvolution& all, std::string_view version) {
  return results::Json::object({{"study", "wear-evolution"},
                                {"mahlwerk", version},
                                {"title", all.title},
                                {"evolve_s", *all.wear.evolve},
                                {"stages", all.stages.size()},
                                {"complete", all.complete},
                                {"stop_reason", all.stop_reason},
                                {"worn_out", all.wear.worn_out},
                                {"lives", lives_json(all)},
                                {"notices", results::notices_json(all.notices)}})
             .text(2) +
         "\n";
}

std::vector<Plot> wear_evolution_plots(const WearEvolution& all) {
  std::vector<Plot> plots;
  for (std::size_t k = 0; k < all.profiles.size(); ++k) plots.push_back(profile_plot(all, k));
  for (std::size_t k = 0; k < all.profiles.size(); ++k)
    plots.push_back(over_time(all, "height of " + all.profiles[k], "m", [k](const WearStage& s) {
      return WearNumber{s.heights[k], std::nan("")};
    }));
  plots.push_back(over_time(all, "dissipated power", "W",
                            [](const WearStage& s) { return s.dissipated_power; }));
  plots.push_back(over_time(all, "wear rate of the balls", "kg/s",
                            [](const WearStage& s) { return s.wear_rate_balls; }));
  plots.push_back(spectra_plot(all));
  for (std::size_t s = 0; s < all.sets.size(); ++s) plots.push_back(sizes_plot(all, s));
  return plots;
}

std::string wear_evolution_page(const WearEvolution& all, std::string_view version) {
  std::string body =
      fmt::format("<p class=\"lead\">{} stages over {} of operation{}.</p>\n", all.stages.size(),
                  escaped(hours(all.stages.empty() ? 0 : all.stages.back().state.time)),
                  all.complete ? "" : ", not complete");
  for (const WearLife& life : all.lives)
    body += fmt::format("<p>{}.</p>\n", escaped(life_sentence(all, life)));
  for (const Notice& one : all.notices) body += note_box(one.text, one.warns());
  for (const Plot& plot : wear_evolution_plots(all)) body += figure(plot, "");
  body += fmt::format("<h2>Stages</h2>\n<div class=\"wide\"><table>\n{}</table></div>\n",
                      stage_rows(all));
  body +=
      "<p><small>Time of operation follows from the wear coefficient of the case, which is rarely "
      "known better than to a factor of ten: calibrate it by one weighing or one measured "
      "profile.</small></p>\n";
  return page(all.title.empty() ? "Wear over time" : all.title, body,
              fmt::format("Mahlwerk {}. The numbers are in wear_evolution.csv, wear_profile.csv, "
                          "wear_ball_sizes.csv and wear_spectra.csv; each stage has a folder.",
                          escaped(version)));
}

}  // namespace mahlwerk::report

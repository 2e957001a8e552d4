// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page of a fit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/fit.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/parameters.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

std::string number_rows(const Fit& fit) {
  std::string rows;
  for (const FittedParameter& p : fit.result.parameters)
    rows += fmt::format(
        "<tr><th scope=\"row\"><code>{}</code><small>{}</small></th><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{} to {}</td></tr>\n",
        escaped(p.name), escaped(p.about), value_cell_text(p), escaped(p.interval_text()),
        std::isfinite(p.simulation_ci95)
            ? "± " + escaped(show_rounded(p.simulation_ci95, p.unit, 2))
            : "-",
        escaped(p.text.least), escaped(p.text.most));
  return rows;
}

struct DrawnQuantity {
  std::string what;
  bool over_size = false, over_time = false;
};

std::vector<DrawnQuantity> drawn_quantities(const Fit& fit) {
  std::vector<DrawnQuantity> all;
  for (const PredictedMeasurement& p : fit.points) {
    if (std::ranges::find(all, p.name(), &DrawnQuantity::what) != all.end()) continue;
    DrawnQuantity d{p.name(), p.name() == "passing", false};
    for (const PredictedMeasurement& other : fit.points)
      d.over_time = d.over_time || (other.name() == p.name() && other.time != p.time);
    all.push_back(d);
  }
  return all;
}

Multiple multiple_of(const Fit& fit, const std::string& what, bool of_size) {
  double most = 0;
  std::string unit;
  for (const PredictedMeasurement& p : fit.points)
    if (p.name() == what) {
      most = std::fmax(most, of_size ? p.size : std::fmax(p.value, p.predicted.value));
      unit = of_size ? "m" : p.unit();
    }
  return multiple(most, unit);
}

/// Unit of the time axis: s, min or h, by the longest time.
Multiple of_times(const Fit& fit) {
  double most = 0;
  for (const PredictedMeasurement& p : fit.points) most = std::fmax(most, p.time);
  if (most > 4 * 3600) return {3600, "h"};
  return most > 300 ? Multiple{60, "min"} : Multiple{1, "s"};
}

std::string axis_of(const std::string& what, const Multiple& m) {
  return m.unit.empty() ? what : fmt::format("{} ({})", what, m.unit);
}

/// Measured values as dots, model curves as lines; a colour for each condition, and for each time
/// of size distributions.
Plot curves(const Fit& fit, const DrawnQuantity& d) {
  const Multiple across = d.over_size ? multiple_of(fit, d.what, true) : of_times(fit);
  const Multiple up = multiple_of(fit, d.what, false);
  std::map<std::pair<std::size_t, double>, std::size_t> colours;
  Plot plot{.title = fmt::format("{}: measured and fitted", d.what),
            .x = Axis{axis_of(d.over_size ? "size" : "time of milling", across), d.over_size},
            .y = Axis{axis_of(d.what, up)},
            .series = {}};
  const auto colour = [&](std::size_t condition, double time) {
    return colours.try_emplace({condition, d.over_size ? time : 0}, colours.size()).first->second;
  };
  for (const FitCurve& c : fit.curves) {
    if (c.what != d.what) continue;
    Series line{.name = fit.condition_name(c.condition), .colour = colour(c.condition, c.time)};
    if (d.over_size) line.name += ", " + show_rounded(c.time, "s", 3);
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      line.x.push_back(c.x[i] / across.factor);
      line.y.push_back(c.y[i] / up.factor);
    }
    plot.series.push_back(std::move(line));
  }
  for (const PredictedMeasurement& p : fit.points)
    if (p.name() == d.what)
      plot.series.push_back({.name = "",
                             .x = {(d.over_size ? p.size : p.time) / across.factor},
                             .y = {p.value / up.factor},
                             .error = {1.96 * p.error / up.factor},
                             .mark = Mark::dots,
                             .colour = colour(p.condition, p.time)});
  return plot;
}

/// Measured and fitted values over the number of the condition, for data at a single time.
Plot beside(const Fit& fit, const DrawnQuantity& d) {
  const Multiple up = multiple_of(fit, d.what, false);
  Series measured{.name = "measured", .mark = Mark::dots}, fitted{.name = "fitted"};
  fitted.mark = Mark::points;
  for (const PredictedMeasurement& p : fit.points) {
    if (p.name() != d.what) continue;
    const auto x = static_cast<double>(p.condition + 1);
    measured.x.push_back(x);
    measured.y.push_back(p.value / up.factor);
    measured.error.push_back(1.96 * p.error / up.factor);
    fitted.x.push_back(x);
    fitted.y.push_back(p.predicted.value / up.factor);
  }
  return {.title = fmt::format("{}: measured and fitted", d.what),
          .x = Axis{"number of the condition"},
          .y = Axis{axis_of(d.what, up)},
          .series = {fitted, measured}};
}

Plot residuals(const Fit& fit) {
  Plot plot{.title = "Residuals",
            .x = Axis{"line of the table of measurements"},
            .y = Axis{fit.errors_known ? "residual (measurement errors)" : "residual"},
            .series = {},
            .shape = 0.39};
  for (const DrawnQuantity& d : drawn_quantities(fit)) {
    Series series{.name = d.what, .mark = Mark::dots};
    for (const PredictedMeasurement& p : fit.points)
      if (p.name() == d.what) {
        series.x.push_back(p.line);
        series.y.push_back(p.residual);
      }
    plot.series.push_back(std::move(series));
  }
  Series zero{.name = "", .colour = 6};
  for (const PredictedMeasurement& p : fit.points) {
    zero.x.push_back(p.line);
    zero.y.push_back(0);
  }
  plot.series.push_back(std::move(zero));
  return plot;
}

std::string point_rows(const Fit& fit) {
  std::string rows;
  for (const PredictedMeasurement& p : fit.points) {
    const auto text = [&](double value) {
      return escaped(readable(value, NAN, p.unit().empty() ? "1" : p.unit()).text());
    };
    rows += fmt::format(
        "<tr><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td><td>{}{}</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2g}</td></tr>\n",
        p.line, escaped(fit.condition_name(p.condition)), escaped(show_rounded(p.time, "s")),
        escaped(p.name()), p.size > 0 ? " " + escaped(show_rounded(p.size, "m")) : "",
        text(p.value), text(p.predicted.value), p.residual);
  }
  return rows;
}

std::string condition_list(const Fit& fit) {
  if (fit.conditions.size() < 2) return "";
  std::string items;
  for (std::size_t i = 0; i < fit.conditions.size(); ++i)
    items += fmt::format("<li>{}</li>\n", escaped(fit.condition_name(i)));
  return fmt::format("<h2>Conditions</h2>\n<ol>\n{}</ol>\n", items);
}

std::string figures(const Fit& fit) {
  std::string text;
  for (const DrawnQuantity& d : drawn_quantities(fit)) {
    const bool over = d.over_size || d.over_time || fit.conditions.size() < 2;
    text += figure(over ? curves(fit, d) : beside(fit, d),
                   fit.errors_known ? "Bars are 95 % of the measurement errors."
                                    : "Dots are measured values; no errors are given.");
  }
  return text + figure(residuals(fit),
                       "Residuals of a model that fits scatter about zero without a trend.");
}

}  // namespace

std::string fit_page(const Fit& fit, std::string_view version) {
  std::string body = fmt::format(
      "<p class=\"lead\">{} parameter{} of {}, fitted to {} measured values of {}.</p>\n",
      fit.result.parameters.size(), fit.result.parameters.size() == 1 ? "" : "s",
      escaped(fit.case_file), fit.points.size(), escaped(fit.data_file));
  body += remark_boxes(fit.result);
  body += notice_boxes(fit.notices, fit.conditions.size(), "condition");
  body += fmt::format(
      "<h2>Fitted parameters</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th "
      "class=\"n\">value</th><th class=\"n\">95 % interval</th><th class=\"n\">due to the "
      "mill</th><th class=\"n\">search "
      "range</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      number_rows(fit));
  body += note_box(escaped(how_to_read(fit)), false);
  body += figures(fit);
  if (fit.result.parameters.size() > 1)
    body += correlation_table(fit.result, "parameters", 3) +
            "<p><small>Near 1 or -1 the data hardly distinguish the two parameters.</small></p>\n";
  body += condition_list(fit);
  body += fmt::format(
      "<h2>Measured and fitted</h2>\n<div class=\"wide\"><table>\n<thead><tr><th "
      "class=\"n\">line</th><th>condition</th><th class=\"n\">time</th><th></th><th "
      "class=\"n\">measured</th><th class=\"n\">fitted</th><th "
      "class=\"n\">residual</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      point_rows(fit));
  return page(
      fit.title.empty() ? "A fit" : fit.title, body,
      fmt::format(
          "Mahlwerk {}. The numbers are in fit.json and fit.csv, the fitted case in fitted.toml.",
          escaped(version)));
}

}  // namespace mahlwerk::report

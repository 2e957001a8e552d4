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
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

std::string number_rows(const FitReport& fit) {
  std::string rows;
  for (const FitParameter& n : fit.parameters)
    rows += fmt::format(
        "<tr><th scope=\"row\"><code>{}</code><small>{}</small></th><td class=\"n\">{}</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{} to {}</td></tr>\n",
        escaped(n.key), escaped(n.about),
        n.determined ? escaped(n.value_text()) : "<s>" + escaped(n.value_text()) + "</s>",
        escaped(n.interval_text()),
        std::isfinite(n.simulation_ci95)
            ? "± " + escaped(show_rounded(n.simulation_ci95, n.unit, 2))
            : "-",
        escaped(show_rounded(n.least, n.unit)), escaped(show_rounded(n.most, n.unit)));
  return rows;
}

std::string remarks(const FitReport& fit) {
  std::string text;
  for (const FitParameter& n : fit.parameters) {
    std::string words;
    for (const std::string& remark : n.remarks)
      words += (words.empty() ? " " : "; ") + escaped(remark);
    if (!words.empty()) words += ".";
    if (!n.determined)
      text += note_box(
          fmt::format("<b>The data do not determine <code>{}</code>:</b>{}", escaped(n.key), words),
          true);
    else if (!words.empty())
      text += note_box(fmt::format("<code>{}</code>:{}", escaped(n.key), words), false);
  }
  for (const std::string& remark : fit.remarks) text += note_box(escaped(remark) + ".", true);
  return text;
}

/// A measured quantity that gets its own plot, and what it varies with.
struct DrawnQuantity {
  std::string what;
  bool over_size = false, over_time = false;
};

std::vector<DrawnQuantity> drawn_quantities(const FitReport& fit) {
  std::vector<DrawnQuantity> all;
  for (const FitPoint& p : fit.points) {
    if (std::ranges::find(all, p.what, &DrawnQuantity::what) != all.end()) continue;
    DrawnQuantity d{p.what, p.what == "passing", false};
    for (const FitPoint& other : fit.points)
      d.over_time = d.over_time || (other.what == p.what && other.time != p.time);
    all.push_back(d);
  }
  return all;
}

std::string name_of(const FitReport& fit, std::size_t condition) {
  const std::string& name = fit.conditions[condition];
  return name.empty() ? "the case" : name;
}

/// The multiple of the unit that suits the largest value of a quantity, or of its sizes.
Multiple multiple_of(const FitReport& fit, const std::string& what, bool of_size) {
  double most = 0;
  std::string unit;
  for (const FitPoint& p : fit.points)
    if (p.what == what) {
      most = std::fmax(most, of_size ? p.size : std::fmax(p.measured, p.fitted));
      unit = of_size ? "m" : p.unit;
    }
  return multiple(most, unit);
}

/// Unit of the time axis: s, min or h, by the longest time.
Multiple of_times(const FitReport& fit) {
  double most = 0;
  for (const FitPoint& p : fit.points) most = std::fmax(most, p.time);
  if (most > 4 * 3600) return {3600, "h"};
  return most > 300 ? Multiple{60, "min"} : Multiple{1, "s"};
}

std::string axis_of(const std::string& what, const Multiple& m) {
  return m.unit.empty() ? what : fmt::format("{} ({})", what, m.unit);
}

/// Measured values as dots, model curves as lines; a colour for each condition, and for each time
/// of size distributions.
Plot curves(const FitReport& fit, const DrawnQuantity& d) {
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
    Series line{.name = name_of(fit, c.condition), .colour = colour(c.condition, c.time)};
    if (d.over_size) line.name += ", " + show_rounded(c.time, "s", 3);
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      line.x.push_back(c.x[i] / across.factor);
      line.y.push_back(c.y[i] / up.factor);
    }
    plot.series.push_back(std::move(line));
  }
  for (const FitPoint& p : fit.points)
    if (p.what == d.what)
      plot.series.push_back({.name = "",
                             .x = {(d.over_size ? p.size : p.time) / across.factor},
                             .y = {p.measured / up.factor},
                             .error = {1.96 * p.error / up.factor},
                             .mark = Mark::dots,
                             .colour = colour(p.condition, p.time)});
  return plot;
}

/// Measured and fitted values over the number of the condition, for data at a single time.
Plot beside(const FitReport& fit, const DrawnQuantity& d) {
  const Multiple up = multiple_of(fit, d.what, false);
  Series measured{.name = "measured", .mark = Mark::dots}, fitted{.name = "fitted"};
  fitted.mark = Mark::points;
  for (const FitPoint& p : fit.points) {
    if (p.what != d.what) continue;
    const auto x = static_cast<double>(p.condition + 1);
    measured.x.push_back(x);
    measured.y.push_back(p.measured / up.factor);
    measured.error.push_back(1.96 * p.error / up.factor);
    fitted.x.push_back(x);
    fitted.y.push_back(p.fitted / up.factor);
  }
  return {.title = fmt::format("{}: measured and fitted", d.what),
          .x = Axis{"number of the condition"},
          .y = Axis{axis_of(d.what, up)},
          .series = {fitted, measured}};
}

Plot residuals(const FitReport& fit) {
  Plot plot{.title = "Residuals",
            .x = Axis{"line of the table of measurements"},
            .y = Axis{fit.errors_known ? "residual (measurement errors)" : "residual"},
            .series = {},
            .height = 280};
  for (const DrawnQuantity& d : drawn_quantities(fit)) {
    Series series{.name = d.what, .mark = Mark::dots};
    for (const FitPoint& p : fit.points)
      if (p.what == d.what) {
        series.x.push_back(p.line);
        series.y.push_back(p.residual);
      }
    plot.series.push_back(std::move(series));
  }
  Series zero{.name = "", .colour = 6};
  for (const FitPoint& p : fit.points) {
    zero.x.push_back(p.line);
    zero.y.push_back(0);
  }
  plot.series.push_back(std::move(zero));
  return plot;
}

std::string point_rows(const FitReport& fit) {
  std::string rows;
  for (const FitPoint& p : fit.points) {
    const auto text = [&](double value) {
      return escaped(readable(value, NAN, p.unit.empty() ? "1" : p.unit).text());
    };
    rows += fmt::format(
        "<tr><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td><td>{}{}</td><td "
        "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2g}</td></tr>\n",
        p.line, escaped(name_of(fit, p.condition)), escaped(show_rounded(p.time, "s")),
        escaped(p.what), p.size > 0 ? " " + escaped(show_rounded(p.size, "m")) : "",
        text(p.measured), text(p.fitted), p.residual);
  }
  return rows;
}

std::string correlation(const FitReport& fit) {
  if (fit.parameters.size() < 2) return "";
  std::string head, rows;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const std::string key = escaped(fit.parameters[i].key);
    head += fmt::format("<th class=\"n\"><code>{}</code></th>", key);
    rows += fmt::format("<tr><th scope=\"row\"><code>{}</code></th>", key);
    for (const double c : fit.correlation[i]) rows += fmt::format("<td class=\"n\">{:.3f}</td>", c);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h2>Correlation of the parameters</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th>{}"
      "</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n<p><small>Near 1 or -1 the data hardly "
      "distinguish the two parameters.</small></p>\n",
      head, rows);
}

std::string condition_list(const FitReport& fit) {
  if (fit.conditions.size() < 2) return "";
  std::string items;
  for (std::size_t i = 0; i < fit.conditions.size(); ++i)
    items += fmt::format("<li>{}</li>\n", escaped(name_of(fit, i)));
  return fmt::format("<h2>Conditions</h2>\n<ol>\n{}</ol>\n", items);
}

std::string figures(const FitReport& fit) {
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

std::string fit_page(const FitReport& fit, std::string_view version) {
  std::string body = fmt::format(
      "<p class=\"lead\">{} parameter{} of {}, fitted to {} measured values of {}.</p>\n",
      fit.parameters.size(), fit.parameters.size() == 1 ? "" : "s", escaped(fit.case_file),
      fit.points.size(), escaped(fit.data_file));
  body += remarks(fit);
  body += notice_boxes(fit.notices, fit.conditions.size(), "condition");
  body += fmt::format(
      "<h2>Fitted parameters</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th "
      "class=\"n\">value</th><th class=\"n\">95 % interval</th><th class=\"n\">due to the "
      "mill</th><th class=\"n\">search "
      "range</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      number_rows(fit));
  body += note_box(escaped(how_to_read(fit)), false);
  body += figures(fit);
  body += correlation(fit) + condition_list(fit);
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

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "mahlwerk/report/campaign_sheet.hpp"
#include "mahlwerk/report/page.hpp"

namespace mahlwerk::report {
namespace {

namespace fs = std::filesystem;

std::string point_table(const Sheet& sheet) {
  const Campaign& c = sheet.campaign;
  std::string head, body;
  for (const Swept& s : c.swept) head += fmt::format("<th>{}</th>", escaped(s.key));
  for (const std::size_t i : sheet.shown)
    head += fmt::format("<th class=\"n\">{}</th>", escaped(label(c.columns[i].name)));
  for (const Point& p : c.points) {
    body += "<tr>";
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      const std::string text = escaped(p.values[i]);
      const bool link = i == 0 && !p.folder.empty();
      body +=
          link ? fmt::format("<td><a href=\"{}\">{}</a></td>",
                             escaped((fs::path(p.folder) / "report.html").generic_string()), text)
               : fmt::format("<td>{}</td>", text);
    }
    for (const std::size_t i : sheet.shown)
      body += fmt::format(
          "<td class=\"n\">{}</td>",
          escaped(readable(value_at(p, i), half_width_at(p, i), c.columns[i].unit).text()));
    body += "</tr>\n";
  }
  return fmt::format(
      "<h2>Points</h2>\n<div "
      "class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>"
      "\n</table></div>\n<p><small>± is the 95 % confidence half-width over independent replicates "
      "(Student's t).</small></p>\n",
      head, body);
}

/// The points of one line of a plot, along the axis, and what the other keys say there.
struct Line {
  std::string others;
  std::vector<std::size_t> points;
};
std::vector<Line> lines(const Sheet& sheet, std::size_t axis) {
  std::vector<Line> found;
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const std::string others = sheet.others(i, {axis});
    auto line = std::ranges::find(found, others, &Line::others);
    if (line == found.end()) line = found.insert(found.end(), {others, {}});
    line->points.push_back(i);
  }
  for (Line& line : found)
    std::ranges::stable_sort(line.points, {},
                             [&](std::size_t i) { return sheet.keys[axis].of[i]; });
  return found;
}

Plot plot_of(const Sheet& sheet, std::size_t axis, std::size_t column) {
  const Multiple& m = sheet.multiples[column];
  const std::string name = label(sheet.campaign.columns[column].name);
  Plot plot;
  plot.title = name;
  plot.x.label = axis_label(sheet.campaign.swept[axis]);
  plot.y.label = m.unit == "1" ? name : m.unit == "1/s" ? "per second" : m.unit;
  plot.height = 320;
  for (const auto& [others, points] : lines(sheet, axis)) {
    Series series{.name = others, .x = {}, .y = {}, .error = {}, .mark = Mark::points};
    for (const std::size_t i : points) {
      const Point& p = sheet.campaign.points[i];
      series.x.push_back(sheet.keys[axis].numbers[sheet.keys[axis].of[i]]);
      series.y.push_back(value_at(p, column) / m.factor);
      series.error.push_back(half_width_at(p, column) / m.factor);
    }
    plot.x.logarithmic = plot.x.logarithmic || over_decades(series.x);
    plot.y.logarithmic = plot.y.logarithmic || over_decades(series.y);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::string campaign_page(const Campaign& c, std::string_view version) {
  const Sheet sheet(c);
  std::string keys;
  for (const Swept& s : c.swept) keys += (keys.empty() ? "" : ", ") + s.key;
  std::string body = fmt::format("<p class=\"lead\">{} points; what varies: {}.</p>\n",
                                 c.points.size(), escaped(keys));
  body += point_table(sheet);
  if (const std::size_t axis = sheet.axis(); axis < c.swept.size())
    for (const std::size_t column : sheet.shown) body += figure(plot_of(sheet, axis, column), "");
  return page(c.title, body,
              fmt::format("Mahlwerk {}. All quantities of all points are in campaign.csv.",
                          escaped(version)));
}

std::map<std::string, std::string> campaign_figures(const Campaign& c) {
  const Sheet sheet(c);
  std::map<std::string, std::string> figures;
  if (const std::size_t axis = sheet.axis(); axis < c.swept.size())
    for (const std::size_t column : sheet.shown)
      figures["figures/" + c.columns[column].name + ".svg"] = svg(plot_of(sheet, axis, column));
  return figures;
}

}  // namespace mahlwerk::report

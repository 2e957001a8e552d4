// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/readable.hpp"
#include "mahlwerk/results/csv.hpp"

namespace mahlwerk::report {
namespace {

namespace fs = std::filesystem;
using results::Quantity;

/// What a campaign's page shows where its points have it, the powder first;
/// campaign.csv has everything.
constexpr std::array<std::string_view, 9> chosen{"d90",
                                                 "d50",
                                                 "conversion",
                                                 "captured_mass_rate",
                                                 "captured_grains_mean",
                                                 "collision_rate_above_threshold",
                                                 "energy_normal_mean_above_threshold",
                                                 "energy_contact_point_mean_above_threshold",
                                                 "dissipated_power"};

/// "400 rpm" is 400 and "rpm"; a word is NaN and all of it.
struct Split {
  double number = NAN;
  std::string_view rest;
};
Split split(std::string_view text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc{}) return {NAN, text};
  std::string_view rest = text.substr(static_cast<std::size_t>(read.ptr - text.data()));
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return {number, rest};
}

/// A key whose values are all numbers of one unit can be an axis and a column of numbers.
bool is_number(const Campaign& c, std::size_t key) {
  return std::all_of(c.points.begin(), c.points.end(), [&](const Point& p) {
    const Split s = split(p.values[key]);
    return std::isfinite(s.number) && s.rest == c.swept[key].unit;
  });
}

std::string csv_value(const Campaign& c, const Point& p, std::size_t key) {
  return is_number(c, key) ? results::csv_cell(split(p.values[key]).number)
                           : results::csv_cell(p.values[key]);
}

/// "%" is no name for a column.
std::string column_of(const Swept& s) {
  return results::column_name(s.key, s.unit == "%" ? "percent" : s.unit);
}

const Quantity* named(const Point& p, std::string_view name) {
  const auto found = std::find_if(p.quantities.begin(), p.quantities.end(),
                                  [&](const Quantity& q) { return q.name == name; });
  return found == p.quantities.end() ? nullptr : &*found;
}

std::vector<std::string_view> shown(const Campaign& c) {
  std::vector<std::string_view> names;
  for (const std::string_view name : chosen)
    if (std::ranges::any_of(c.points, [&](const Point& p) { return named(p, name) != nullptr; }))
      names.push_back(name);
  return names;
}

std::string point_table(const Campaign& c) {
  std::string head, body;
  for (const Swept& s : c.swept) head += fmt::format("<th>{}</th>", escaped(s.key));
  const std::vector<std::string_view> names = shown(c);
  for (const std::string_view name : names)
    head += fmt::format("<th class=\"n\">{}</th>", escaped(label(name)));
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
    for (const std::string_view name : names) {
      const Quantity* q = named(p, name);
      body +=
          fmt::format("<td class=\"n\">{}</td>", q != nullptr ? escaped(readable(*q).text()) : "");
    }
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
  std::vector<const Point*> points;
};
std::vector<Line> lines(const Campaign& c, std::size_t axis) {
  std::vector<Line> found;
  for (const Point& p : c.points) {
    std::string others;
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      if (i != axis) others += (others.empty() ? "" : ", ") + p.values[i];
    }
    const auto same = [&](const Line& line) { return line.others == others; };
    auto line = std::find_if(found.begin(), found.end(), same);
    if (line == found.end()) line = found.insert(found.end(), {others, {}});
    line->points.push_back(&p);
  }
  for (Line& line : found)
    std::stable_sort(line.points.begin(), line.points.end(), [&](const Point* a, const Point* b) {
      return split(a->values[axis]).number < split(b->values[axis]).number;
    });
  return found;
}

/// Numbers over two decades and more are told apart on a logarithmic axis alone.
bool over_decades(const std::vector<double>& values) {
  constexpr double far = 100;
  const auto [least, most] = std::ranges::minmax_element(values);
  return least != values.end() && *least > 0 && *most >= far * *least;
}

Plot plot_of(const Campaign& c, std::size_t axis, std::string_view name) {
  double most = 0;
  std::string unit;
  for (const Point& p : c.points) {
    const Quantity* q = named(p, name);
    if (q == nullptr || !std::isfinite(q->value)) continue;
    most = std::max(most, std::abs(q->value));
    unit = q->unit;
  }
  const Multiple m = multiple(most, unit);
  const Swept& s = c.swept[axis];
  Plot plot;
  plot.title = label(name);
  plot.x.label = s.unit.empty() ? s.key : fmt::format("{} ({})", s.key, s.unit);
  plot.y.label = m.unit == "1" ? label(name) : m.unit;
  if (m.unit == "1/s") plot.y.label = "per second";
  plot.height = 320;
  for (const auto& [others, points] : lines(c, axis)) {
    Series series{.name = others, .x = {}, .y = {}, .error = {}, .mark = Mark::points};
    for (const Point* p : points) {
      const Quantity* q = named(*p, name);
      if (q == nullptr) continue;
      series.x.push_back(split(p->values[axis]).number);
      series.y.push_back(q->value / m.factor);
      series.error.push_back(q->ci95 / m.factor);
    }
    plot.x.logarithmic = plot.x.logarithmic || over_decades(series.x);
    plot.y.logarithmic = plot.y.logarithmic || over_decades(series.y);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// The key with most values among those that can be an axis, or their number if there is none.
std::size_t axis_of(const Campaign& c) {
  std::size_t best = c.swept.size(), most = 0;
  for (std::size_t i = 0; i < c.swept.size(); ++i) {
    std::set<std::string> values;
    for (const Point& p : c.points) values.insert(p.values[i]);
    if (!is_number(c, i) || values.size() <= most) continue;
    best = i;
    most = values.size();
  }
  return best;
}

}  // namespace

std::vector<Swept> swept(const std::vector<std::string>& keys, const std::vector<Point>& points) {
  std::vector<Swept> list;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string_view unit = points.empty() ? "" : split(points.front().values[i]).rest;
    const bool shared = std::all_of(points.begin(), points.end(), [&](const Point& p) {
      const Split s = split(p.values[i]);
      return std::isfinite(s.number) && s.rest == unit;
    });
    list.push_back({keys[i], shared ? std::string(unit) : ""});
  }
  return list;
}

std::string campaign_page(const Campaign& c, std::string_view version) {
  std::string keys;
  for (const Swept& s : c.swept) keys += (keys.empty() ? "" : ", ") + s.key;
  std::string body = fmt::format("<p class=\"lead\">{} points; what varies: {}.</p>\n",
                                 c.points.size(), escaped(keys));
  body += point_table(c);
  if (const std::size_t axis = axis_of(c); axis < c.swept.size())
    for (const std::string_view name : shown(c)) body += figure(plot_of(c, axis, name), "");
  return page(c.title, body,
              fmt::format("Mahlwerk {}. All quantities of all points are in campaign.csv.",
                          escaped(version)));
}

std::string campaign_csv(const Campaign& c) {
  std::vector<std::string> heads{"point"};
  const std::vector<Quantity> none;
  const std::vector<Quantity>& quantities = c.points.empty() ? none : c.points.front().quantities;
  for (const Swept& s : c.swept) heads.push_back(results::csv_cell(column_of(s)));
  for (const Quantity& q : quantities) {
    heads.push_back(results::column_name(q.name, q.unit));
    heads.push_back(results::column_name(q.name + "_ci95", q.unit));
  }
  std::string text = results::csv_line(heads);
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const Point& p = c.points[i];
    std::vector<std::string> cells{std::to_string(i + 1)};
    for (std::size_t k = 0; k < c.swept.size(); ++k) cells.push_back(csv_value(c, p, k));
    for (const Quantity& q : quantities) {
      const Quantity* own = named(p, q.name);
      cells.push_back(results::csv_cell(own != nullptr ? own->value : NAN));
      cells.push_back(results::csv_cell(own != nullptr ? own->ci95 : NAN));
    }
    text += results::csv_line(cells);
  }
  return text;
}

std::map<std::string, std::string> campaign_figures(const Campaign& c) {
  std::map<std::string, std::string> figures;
  if (const std::size_t axis = axis_of(c); axis < c.swept.size())
    for (const std::string_view name : shown(c))
      figures["figures/" + std::string(name) + ".svg"] = svg(plot_of(c, axis, name));
  return figures;
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "mahlwerk/report/plot/axis_labels.hpp"
#include "mahlwerk/report/plot/picture_json.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::size_t max_lines = 12;    // that a reader can distinguish
constexpr std::size_t max_marks = 2000;  // on a plot's lines
constexpr std::size_t max_specks = 6000, max_total_specks = 250000;

Plot empty_plot(const Sheet& sheet, std::size_t key, std::size_t column) {
  const Multiple& m = sheet.multiples[column];
  const std::string name = label(sheet.campaign.columns[column].name);
  Plot plot;
  plot.title = name;
  plot.x.label = axis_label(sheet.campaign.keys[key]);
  plot.y.label = quantity_axis(sheet.campaign.columns[column].name, m);
  const results::Range range = results::range_of(sheet.campaign.columns[column].name);
  plot.y.range_least = range.least / m.factor;
  plot.y.range_most = range.most / m.factor;
  plot.shape = 0.625;
  return plot;
}

void settle_axes(Plot& plot) {
  for (const Series& s : plot.series) {
    plot.x.logarithmic = plot.x.logarithmic || over_decades(s.x);
    plot.y.logarithmic = plot.y.logarithmic || over_decades(s.y);
  }
}

/// Indices of at most `most` points, evenly spaced, including the first and the last.
std::vector<std::size_t> thinned(std::size_t points, std::size_t most) {
  std::vector<std::size_t> list;
  const std::size_t kept = std::min(points, most);
  for (std::size_t i = 0; i < kept; ++i)
    list.push_back(kept < 2 ? 0 : i * (points - 1) / (kept - 1));
  return list;
}

std::string drawn_of(std::size_t drawn, std::size_t points) {
  return drawn < points ? fmt::format("<p>{} of {} points are drawn.</p>", drawn, points) : "";
}

/// Thins a series to at most `most` points. Returns their number.
std::size_t thin(Series& series, std::size_t most) {
  const std::vector<std::size_t> kept = thinned(series.x.size(), most);
  for (std::vector<double>* values : {&series.x, &series.y, &series.error}) {
    for (std::size_t i = 0; i < kept.size(); ++i) (*values)[i] = (*values)[kept[i]];
    values->resize(kept.size());
  }
  return kept.size();
}

Picture line_plot(const Sheet& sheet, const Layout& layout, std::size_t column) {
  Plot plot = empty_plot(sheet, layout.axis, column);
  for (const Line& line : lines_of(sheet, layout.axis)) {
    Series series = series_of(sheet, line.points, layout.axis, column);
    series.name = line.others;
    series.mark = Mark::points;
    series.band = true;
    plot.series.push_back(std::move(series));
  }
  settle_axes(plot);
  FittedLines fitted = laws_of_lines(sheet, layout.axis, column, plot.series);
  std::size_t drawn = 0;
  for (Series& series : plot.series) drawn += thin(series, max_marks / plot.series.size());
  for (Series& curve : fitted.curves) plot.series.push_back(std::move(curve));
  return {picture_json(plot), drawn_of(drawn, sheet.campaign.points.size()) + fitted.table};
}

/// Limits the axis to the range of the levels: it does not start at zero.
void close_in(Axis& axis, const Levels& levels) {
  const double least = levels.numbers.front(), most = levels.numbers.back();
  const double air = axis.logarithmic ? std::pow(most / least, 0.03) : 0.03 * (most - least);
  axis.least = axis.logarithmic ? least / air : least - air;
  axis.most = axis.logarithmic ? most * air : most + air;
}

/// The points of a star design in which only `key` varies, in its order.
std::vector<std::size_t> ray(const Sheet& sheet, std::size_t key) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i)
    if (std::ranges::all_of(sheet.free, [&](std::size_t k) {
          return k == key || sheet.keys[k].of[i] == sheet.keys[k].of[0];
        }))
      list.push_back(i);
  std::ranges::stable_sort(list, {}, [&](std::size_t i) { return sheet.keys[key].of[i]; });
  return list;
}

Picture ray_plot(const Sheet& sheet, std::size_t key, std::size_t column) {
  Plot plot = empty_plot(sheet, key, column);
  plot.series.push_back(series_of(sheet, ray(sheet, key), key, column));
  plot.series[0].mark = Mark::points;
  plot.series[0].band = true;
  settle_axes(plot);
  close_in(plot.x, sheet.keys[key]);
  return {picture_json(plot)};
}

/// Index of a key with few words, by which dots are coloured; the number of keys if there is none.
std::size_t kinds_of(const Sheet& sheet) {
  constexpr std::size_t few = 7;
  for (const std::size_t key : sheet.free)
    if (!sheet.keys[key].numeric() && sheet.keys[key].size() <= few) return key;
  return sheet.keys.size();
}

Picture dot_plot(const Sheet& sheet, std::size_t key, std::size_t column, std::size_t most) {
  Plot plot = empty_plot(sheet, key, column);
  const std::size_t kinds = kinds_of(sheet), points = sheet.campaign.points.size();
  std::map<std::size_t, std::vector<std::size_t>> by_kind;
  for (const std::size_t i : thinned(points, most))
    by_kind[kinds < sheet.keys.size() ? sheet.keys[kinds].of[i] : 0].push_back(i);
  for (const auto& [kind, members] : by_kind) {
    Series series = series_of(sheet, members, key, column);
    if (kinds < sheet.keys.size()) series.name = sheet.keys[kinds].texts[kind];
    series.mark = Mark::dots;
    plot.series.push_back(std::move(series));
  }
  settle_axes(plot);
  close_in(plot.x, sheet.keys[key]);
  return {picture_json(plot), drawn_of(std::min(points, most), points)};
}

std::vector<Picture> dot_plots(const Sheet& sheet, std::size_t column) {
  std::vector<std::size_t> keys;
  for (const std::size_t key : sheet.free)
    if (sheet.keys[key].numeric()) keys.push_back(key);
  const std::size_t most =
      std::clamp<std::size_t>(max_total_specks / (keys.size() * sheet.shown.size()), 1, max_specks);
  std::vector<Picture> list;
  for (const std::size_t key : keys)
    list.push_back(sheet.star ? ray_plot(sheet, key, column) : dot_plot(sheet, key, column, most));
  return list;
}

}  // namespace

Layout layout_of(const Sheet& sheet) {
  constexpr std::size_t max_values = 5, max_maps = 4;
  Layout made{.axis = sheet.axis(), .second = sheet.keys.size()};
  if (made.axis == sheet.keys.size()) return made;
  std::size_t most = 2;
  for (const std::size_t key : sheet.free) {
    if (key == made.axis || !sheet.keys[key].numeric() || sheet.keys[key].size() <= most) continue;
    made.second = key;
    most = sheet.keys[key].size();
  }
  const bool two = made.second < sheet.keys.size() && sheet.keys[made.axis].size() > 2;
  const auto lines = sheet.grid ? lines_of(sheet, made.axis).size() : max_lines + 1;
  made.maps = sheet.grid && two && lines <= max_maps * sheet.keys[made.second].size();
  made.lines = lines <= max_lines && !(made.maps && sheet.keys[made.second].size() > max_values);
  made.dots = !made.maps && !made.lines;
  return made;
}

std::vector<Line> lines_of(const Sheet& sheet, std::size_t axis) {
  std::vector<Line> found;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const auto [at, is_new] = places.emplace(sheet.others(i, {axis}), found.size());
    if (is_new) found.push_back({at->first, {}});
    found[at->second].points.push_back(i);
  }
  for (Line& line : found)
    std::ranges::stable_sort(line.points, {},
                             [&](std::size_t i) { return sheet.keys[axis].of[i]; });
  return found;
}

Series series_of(const Sheet& sheet, const std::vector<std::size_t>& points, std::size_t key,
                 std::size_t column) {
  const double factor = sheet.multiples[column].factor;
  const Levels& levels = sheet.keys[key];
  Series series;
  for (const std::size_t i : points) {
    const Point& p = sheet.campaign.points[i];
    series.x.push_back(levels.numbers[levels.of[i]]);
    series.y.push_back(value_at(p, column) / factor);
    series.error.push_back(half_width_at(p, column) / factor);
  }
  return series;
}

std::vector<Picture> quantity_pictures(const Sheet& sheet, const Layout& layout,
                                       std::size_t column) {
  std::vector<Picture> list;
  if (layout.lines) list.push_back(line_plot(sheet, layout, column));
  if (layout.maps)
    for (Picture& map : heat_maps(sheet, layout, column)) list.push_back(std::move(map));
  if (layout.dots) list = dot_plots(sheet, column);
  return list;
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/plot/cell_map.hpp"
#include "mahlwerk/report/plot/colours.hpp"

namespace mahlwerk::report {
namespace {

/// Tick texts of a key's values: numbers without unit, which is in the axis label.
std::vector<std::string> tick_texts(const Levels& levels) {
  if (!levels.numeric()) return levels.texts;
  std::vector<std::string> list;
  for (const double v : levels.numbers) list.push_back(fmt::format("{:.6g}", v));
  return list;
}

std::string values_text(const Sheet& sheet, const Point& p) {
  std::string text;
  for (std::size_t i = 0; i < p.values.size() && i < sheet.campaign.keys.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", sheet.campaign.keys[i].key, p.values[i]);
  return text;
}

CellMap empty_map(const Sheet& sheet, std::size_t x, std::size_t y) {
  CellMap map;
  map.x_label = axis_label(sheet.campaign.keys[x]);
  map.y_label = axis_label(sheet.campaign.keys[y]);
  map.x = tick_texts(sheet.keys[x]);
  map.y = tick_texts(sheet.keys[y]);
  map.cells.resize(map.x.size() * map.y.size());
  return map;
}

/// Colour scale over the range of a quantity; logarithmic if it spans two decades or more.
struct Scale {
  double least = INFINITY, most = -INFINITY;
  bool logarithmic = false;
  double share(double v) const {
    if (!(most > least)) return 0.5;
    return logarithmic ? std::log(v / least) / std::log(most / least)
                       : (v - least) / (most - least);
  }
};
Scale scale_of(const Sheet& sheet, std::size_t column) {
  constexpr double far = 100;
  Scale s;
  for (const Point& p : sheet.campaign.points) {
    const double v = value_at(p, column);
    if (!std::isfinite(v)) continue;
    s.least = std::min(s.least, v);
    s.most = std::max(s.most, v);
  }
  s.logarithmic = s.least > 0 && s.most >= far * s.least;
  return s;
}

/// Three digits, or all digits from 1000 to a million.
std::string brief(double v) {
  const double size = std::abs(v);
  return size >= 999.5 && size < 1e6 ? fmt::format("{:.0f}", v) : fmt::format("{:.3g}", v);
}

void put(Cell& cell, const Sheet& sheet, std::size_t column, const Point& p, const Scale& scale) {
  constexpr double levels = 64;  // few distinct colours for many cells
  const double v = value_at(p, column);
  const Column& what = sheet.campaign.columns[column];
  cell.title = fmt::format("{}: ", values_text(sheet, p));
  if (p.waiting()) return;
  cell.failed = !std::isfinite(v);
  if (cell.failed) {
    cell.title += p.failure.empty() ? "no value" : "failed: " + p.failure;
    return;
  }
  const double share = std::round(scale.share(v) * levels) / levels;
  const Multiple& m = sheet.multiples[column];
  cell.colour = viridis(share);
  cell.ink = ink_on_viridis(share);
  cell.text = brief(v / m.factor);
  cell.title += label(what.name) + " " +
                readable_within(v, half_width_at(p, column), what.unit,
                                results::range_of(what.name), m.unit == "1" ? 0 : m.factor)
                    .text();
}

}  // namespace

std::vector<Picture> heat_maps(const Sheet& sheet, const Layout& layout, std::size_t column) {
  const std::size_t x = layout.axis, y = layout.second;
  const Scale scale = scale_of(sheet, column);
  const Column& what = sheet.campaign.columns[column];
  const Multiple& m = sheet.multiples[column];
  std::map<std::string, CellMap> maps;
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const std::string others = sheet.others(i, {x, y});
    const auto [at, is_new] = maps.try_emplace(others);
    CellMap& map = at->second;
    if (is_new) {
      map = empty_map(sheet, x, y);
      map.title = column_label(what, m) + (others.empty() ? "" : ", " + others);
      const auto end = [&](double v) { return std::isfinite(v) ? brief(v / m.factor) : ""; };
      map.legend = {
          end(scale.least), end(scale.most), scale.logarithmic ? "logarithmic scale" : "", {}};
    }
    put(map.cells[sheet.keys[y].of[i] * map.x.size() + sheet.keys[x].of[i]], sheet, column,
        sheet.campaign.points[i], scale);
  }
  std::vector<Picture> list;
  for (const auto& [others, map] : maps) {
    const std::string number = list.empty() ? "" : fmt::format("-{}", list.size() + 1);
    list.push_back({what.name + "-map" + number, svg(map), ""});
  }
  return list;
}

namespace {

/// The regimes of all points, in alphabetical order. The index gives the colour.
std::vector<std::string> regimes_of(const Campaign& c) {
  std::set<std::string> words;
  for (const Point& p : c.points)
    if (!p.regime.empty()) words.insert(p.regime);
  return {words.begin(), words.end()};
}

std::string regime_cells(const Sheet& sheet, std::size_t x, std::size_t y,
                         const std::vector<std::string>& words) {
  CellMap map = empty_map(sheet, x, y);
  map.title = "Regime";
  for (std::size_t k = 0; k < words.size(); ++k)
    map.legend.words.emplace_back(kind_colour(k), words[k]);
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const Point& p = sheet.campaign.points[i];
    Cell& cell = map.cells[sheet.keys[y].of[i] * map.x.size() + sheet.keys[x].of[i]];
    const auto kind = static_cast<std::size_t>(std::ranges::find(words, p.regime) - words.begin());
    cell.failed = p.regime.empty() && !p.waiting();
    cell.title = values_text(sheet, p) + ": " + (cell.failed ? "none" : p.regime);
    if (p.regime.empty()) continue;
    cell.colour = kind_colour(kind);
    cell.text = p.regime;
    cell.ink = ink_on_kind(kind);
  }
  return svg(map);
}

Plot regime_dots(const Sheet& sheet, std::size_t x, std::size_t y,
                 const std::vector<std::string>& words) {
  Plot plot{.title = "Regime",
            .x = Axis{.label = axis_label(sheet.campaign.keys[x])},
            .y = Axis{.label = axis_label(sheet.campaign.keys[y])},
            .series = {},
            .width = 480,
            .height = 340};
  for (std::size_t k = 0; k < words.size(); ++k) {
    Series series{.name = words[k], .mark = Mark::dots};
    for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
      if (sheet.campaign.points[i].regime != words[k]) continue;
      series.x.push_back(sheet.keys[x].numbers[sheet.keys[x].of[i]]);
      series.y.push_back(sheet.keys[y].numbers[sheet.keys[y].of[i]]);
    }
    plot.series.push_back(std::move(series));
  }
  plot.x.logarithmic = over_decades(sheet.keys[x].numbers);
  plot.y.logarithmic = over_decades(sheet.keys[y].numbers);
  return plot;
}

}  // namespace

std::vector<Picture> regime_map(const Sheet& sheet) {
  const std::vector<std::string> words = regimes_of(sheet.campaign);
  if (words.empty() || sheet.free.size() != 2) return {};
  std::size_t x = sheet.free[0], y = sheet.free[1];
  if (sheet.axis() == y) std::swap(x, y);  // the key with more values on the x axis
  if (sheet.grid) return {{"regimes", regime_cells(sheet, x, y, words), ""}};
  if (!sheet.keys[x].numeric() || !sheet.keys[y].numeric()) return {};
  return {picture_of("regimes", regime_dots(sheet, x, y, words))};
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mahlwerk/report/campaign/plots.hpp"

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

MapPanel empty_panel(const Sheet& sheet, std::size_t x, std::size_t y) {
  MapPanel panel;
  panel.x = {.label = axis_label(sheet.campaign.keys[x]), .names = tick_texts(sheet.keys[x])};
  panel.y = {.label = axis_label(sheet.campaign.keys[y]), .names = tick_texts(sheet.keys[y])};
  const std::size_t cells = panel.x.names.size() * panel.y.names.size();
  panel.values.resize(cells, NAN);
  panel.told.resize(cells);
  panel.failed.resize(cells);
  return panel;
}

/// A map whose colours span the values of a quantity; logarithmic if they span two decades or more.
ColourMap empty_map(const Sheet& sheet, std::size_t column) {
  constexpr double far = 100;
  ColourMap map;
  const Multiple& m = sheet.multiples[column];
  map.title = map.quantity = column_label(sheet.campaign.columns[column], m);
  map.least = HUGE_VAL, map.most = -HUGE_VAL;
  for (const Point& p : sheet.campaign.points) {
    const double v = value_at(p, column) / m.factor;
    if (!std::isfinite(v)) continue;
    map.least = std::min(map.least, v);
    map.most = std::max(map.most, v);
  }
  map.logarithmic = map.least > 0 && map.most >= far * map.least;
  return map;
}

void put(MapPanel& panel, std::size_t cell, const Sheet& sheet, std::size_t column,
         const Point& p) {
  const double v = value_at(p, column);
  const Column& what = sheet.campaign.columns[column];
  const Multiple& m = sheet.multiples[column];
  std::string& told = panel.told[cell];
  told = values_text(sheet, p) + ": ";
  if (p.waiting()) return;
  panel.failed[cell] = !std::isfinite(v);
  if (panel.failed[cell]) {
    told += p.failure.empty() ? "no value" : "failed: " + p.failure;
    return;
  }
  panel.values[cell] = v / m.factor;
  told += label(what.name) + " " +
          readable_within(v, half_width_at(p, column), what.unit, results::range_of(what.name),
                          m.unit == "1" ? 0 : m.factor)
              .text();
}

}  // namespace

std::vector<Picture> heat_maps(const Sheet& sheet, const Layout& layout, std::size_t column) {
  const std::size_t x = layout.axis, y = layout.second;
  const ColourMap empty = empty_map(sheet, column);
  std::map<std::string, ColourMap> maps;
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const std::string others = sheet.others(i, {x, y});
    const auto [at, is_new] = maps.try_emplace(others, empty);
    ColourMap& map = at->second;
    if (is_new) {
      map.title += others.empty() ? "" : ", " + others;
      map.panels = {empty_panel(sheet, x, y)};
    }
    MapPanel& panel = map.panels.front();
    put(panel, sheet.keys[y].of[i] * panel.x.names.size() + sheet.keys[x].of[i], sheet, column,
        sheet.campaign.points[i]);
  }
  std::vector<Picture> list;
  for (const auto& [others, map] : maps) list.push_back({picture_json(map)});
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

ColourMap regime_cells(const Sheet& sheet, std::size_t x, std::size_t y,
                       const std::vector<std::string>& words) {
  ColourMap map{.title = "Regime", .quantity = "regime", .words = words};
  map.panels = {empty_panel(sheet, x, y)};
  MapPanel& panel = map.panels.front();
  for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
    const Point& p = sheet.campaign.points[i];
    const std::size_t cell = sheet.keys[y].of[i] * panel.x.names.size() + sheet.keys[x].of[i];
    panel.failed[cell] = p.regime.empty() && !p.waiting();
    panel.told[cell] = values_text(sheet, p) + ": " + (panel.failed[cell] ? "none" : p.regime);
    if (!p.regime.empty())
      panel.values[cell] = static_cast<double>(std::ranges::find(words, p.regime) - words.begin());
  }
  return map;
}

Plot regime_dots(const Sheet& sheet, std::size_t x, std::size_t y,
                 const std::vector<std::string>& words) {
  Plot plot{.title = "Regime",
            .x = Axis{.label = axis_label(sheet.campaign.keys[x])},
            .y = Axis{.label = axis_label(sheet.campaign.keys[y])},
            .series = {},
            .shape = 0.7};
  for (const std::string& word : words) {
    Series series{.name = word, .mark = Mark::dots};
    for (std::size_t i = 0; i < sheet.campaign.points.size(); ++i) {
      if (sheet.campaign.points[i].regime != word) continue;
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
  if (sheet.grid) return {{picture_json(regime_cells(sheet, x, y, words))}};
  if (!sheet.keys[x].numeric() || !sheet.keys[y].numeric()) return {};
  return {{picture_json(regime_dots(sheet, x, y, words))}};
}

}  // namespace mahlwerk::report

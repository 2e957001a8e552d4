// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/plot/bars.hpp"

namespace mahlwerk::report {
namespace {

/// What an effect is sorted by: how far a quantity goes with the key, or its share of variance.
double size_of(const Effect& e, const Sensitivity& s) {
  if (s.method == Method::morris) return e.mean_absolute;
  if (s.method == Method::sobol) return std::isfinite(e.total) ? e.total : e.first_order;
  double least = INFINITY, most = -INFINITY;
  for (const double v : {e.low, e.high, s.base})
    if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  return std::isfinite(e.low) || std::isfinite(e.high) ? most - least : NAN;
}

/// The largest first, those of which nothing is known last.
std::vector<Effect> sorted(const Sensitivity& s) {
  std::vector<Effect> list = s.effects;
  std::ranges::stable_sort(list, std::greater{}, [&](const Effect& e) {
    const double size = size_of(e, s);
    return std::isfinite(size) ? size : -1.0;
  });
  return list;
}

/// Two values with overlapping intervals; not if an interval is missing.
bool alike(double a, double a_ci95, double b, double b_ci95) {
  return std::abs(a - b) <= std::hypot(a_ci95, b_ci95);
}

/// The effect is not told from none: as it says itself, else by the intervals. Without intervals
/// nothing is said.
bool may_be_none(const Effect& e, const Sensitivity& s) {
  if (e.told) return !*e.told;
  switch (s.method) {
    case Method::morris:
      return e.mean_absolute <= e.mean_absolute_ci95;
    case Method::sobol:
      return e.total <= e.total_ci95;
    case Method::one_at_a_time:
      break;
  }
  const bool low = alike(e.low, e.low_ci95, s.base, s.base_ci95);
  const bool high = alike(e.high, e.high_ci95, s.base, s.base_ci95);
  return low && high && alike(e.low, e.low_ci95, e.high, e.high_ci95);
}

Multiple multiple_of(const Sensitivity& s) {
  if (s.method == Method::sobol) return {1, "1"};
  double most = std::isfinite(s.base) && s.method == Method::one_at_a_time ? std::abs(s.base) : 0;
  for (const Effect& e : s.effects)
    for (const double v : {e.low, e.high, e.mean_absolute})
      if (std::isfinite(v)) most = std::max(most, std::abs(v));
  return multiple(most, s.unit);
}

std::string with_unit(const std::string& words, const Multiple& m) {
  if (m.unit == "1") return words;
  return fmt::format("{} ({})", words, m.unit == "1/s" ? "/s" : m.unit);
}

BarPlot one_at_a_time(const Sensitivity& s, const Multiple& m) {
  BarPlot plot{.title = label(s.quantity), .label = with_unit(label(s.quantity), m)};
  plot.base = s.base / m.factor;
  plot.words = {"key at its low end", "at its high end"};
  for (const Effect& e : sorted(s)) {
    BarGroup group{.name = e.key, .bars = {}};
    group.bars.push_back({e.low / m.factor, e.low_ci95 / m.factor, 0, e.low_end});
    group.bars.push_back({e.high / m.factor, e.high_ci95 / m.factor, 1, e.high_end});
    // Both on one side would hide each other.
    plot.side_by_side = plot.side_by_side || (e.low - s.base) * (e.high - s.base) > 0;
    plot.groups.push_back(std::move(group));
  }
  return plot;
}

BarPlot morris(const Sensitivity& s, const Multiple& m) {
  BarPlot plot{.title = label(s.quantity), .label = with_unit("mean size of the effect, µ*", m)};
  for (const Effect& e : sorted(s))
    plot.groups.push_back(
        {e.key, {{e.mean_absolute / m.factor, e.mean_absolute_ci95 / m.factor, 0, ""}}});
  return plot;
}

BarPlot sobol(const Sensitivity& s) {
  BarPlot plot{.title = label(s.quantity), .label = "share of the variance"};
  plot.side_by_side = true;
  plot.words = {"alone, S1", "with others, ST"};
  for (const Effect& e : sorted(s))
    plot.groups.push_back(
        {e.key, {{e.first_order, e.first_order_ci95, 0, ""}, {e.total, e.total_ci95, 1, ""}}});
  return plot;
}

/// Effects that differ from place to place (high sigma) are bent or depend on other keys.
Plot scatter_of(const Sensitivity& s, const Multiple& m) {
  Plot plot{.title = label(s.quantity) + ": how effects differ",
            .x = {.label = with_unit("mean size, µ*", m), .least = 0},
            .y = {.label = with_unit("scatter, σ", m), .least = 0},
            .series = {},
            .width = 480,
            .height = 320};
  for (const Effect& e : sorted(s)) {
    Series series{.name = e.key, .mark = Mark::dots};
    series.x = {e.mean_absolute / m.factor};
    series.y = {e.deviation / m.factor};
    series.error = {e.deviation_ci95 / m.factor};
    plot.series.push_back(std::move(series));
    const double row = 56;  // letters
    plot.height += 18 * static_cast<double>(width(e.key) + 7) / row;
  }
  return plot;
}

std::string cell(double value, double ci95, const Multiple& m, std::string_view unit) {
  return fmt::format("<td class=\"n\" data-v=\"{}\">{}</td>",
                     std::isfinite(value) ? fmt::format("{}", value) : "",
                     escaped(readable(value, ci95, unit, m.factor).number));
}

/// The numbers of the bars and those that they do not show.
std::string numbers(const Sensitivity& s, const Multiple& m) {
  std::string head, body;
  const auto heads = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) head += fmt::format("<th class=\"n\">{}</th>", name);
  };
  if (s.method == Method::morris) heads({"µ*", "µ", "σ"});
  if (s.method == Method::sobol) heads({"S1", "ST"});
  if (s.method == Method::one_at_a_time) heads({"low end", "there", "high end", "there"});
  for (const Effect& e : sorted(s)) {
    body += fmt::format("<tr><td>{}</td>", escaped(e.key));
    if (s.method == Method::morris)
      body += cell(e.mean_absolute, e.mean_absolute_ci95, m, s.unit) +
              cell(e.mean, e.mean_ci95, m, s.unit) + cell(e.deviation, e.deviation_ci95, m, s.unit);
    if (s.method == Method::sobol)
      body += cell(e.first_order, e.first_order_ci95, m, "") + cell(e.total, e.total_ci95, m, "");
    if (s.method == Method::one_at_a_time)
      body += fmt::format("<td class=\"n\">{}</td>{}<td class=\"n\">{}</td>{}", escaped(e.low_end),
                          cell(e.low, e.low_ci95, m, s.unit), escaped(e.high_end),
                          cell(e.high, e.high_ci95, m, s.unit));
    body += "</tr>\n";
  }
  const std::string base =
      s.method == Method::one_at_a_time
          ? fmt::format("<p>The case itself: {}.</p>\n",
                        escaped(readable(s.base, s.base_ci95, s.unit, m.factor).text()))
          : "";
  return fmt::format(
      "{}<div class=\"wide\"><table class=\"laws\"><thead><tr><th>{}</th>{}</tr></thead>\n<tbody>"
      "\n{}</tbody></table></div>\n",
      base, escaped(with_unit("key", m)), head, body);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace

std::string sensitivity_words(const Sensitivity& s) {
  const std::vector<Effect> effects = sorted(s);
  if (effects.empty() || !std::isfinite(size_of(effects.front(), s))) return "";
  const double size = size_of(effects.front(), s);
  const double ci95 = s.method == Method::morris  ? effects.front().mean_absolute_ci95
                      : s.method == Method::sobol ? effects.front().total_ci95
                                                  : NAN;
  const std::string much =
      s.method == Method::sobol
          ? fmt::format("with others it makes {} of the variance", readable(size, ci95, "").text())
          : fmt::format("{} {} over its range",
                        s.method == Method::morris ? "on average" : "it goes through",
                        readable(size, ci95, s.unit).text());
  std::vector<std::string> none;
  for (const Effect& e : effects)
    if (may_be_none(e, s)) none.push_back(e.key);
  if (none.size() == effects.size())
    return fmt::format("{}: no key has an effect that can be told from zero.", label(s.quantity));
  std::string text =
      fmt::format("{}: {} matters most ({}).", label(s.quantity), effects.front().key, much);
  if (!none.empty()) text += fmt::format(" Not told from zero: the effect of {}.", joined(none));
  return text;
}

std::vector<Picture> sensitivity_pictures(const Sensitivity& s) {
  if (s.effects.empty()) return {};
  const Multiple m = multiple_of(s);
  const std::string name = "tornado-" + s.quantity;
  const std::string below = numbers(s, m);
  switch (s.method) {
    case Method::morris:
      return {{name, svg(morris(s, m)), below}, {name + "-scatter", svg(scatter_of(s, m)), ""}};
    case Method::sobol:
      return {{name, svg(sobol(s)), below}};
    case Method::one_at_a_time:
      break;
  }
  if (!std::isfinite(s.base)) return {};  // bars without a foot
  return {{name, svg(one_at_a_time(s, m)), below}};
}

}  // namespace mahlwerk::report

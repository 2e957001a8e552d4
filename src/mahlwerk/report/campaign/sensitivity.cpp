// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/plot/bars.hpp"

namespace mahlwerk::report {
namespace {

Multiple multiple_of(const Sensitivity& s) {
  if (s.design == Design::sobol_indices) return {1, "1"};
  double most = 0;
  if (std::isfinite(s.base.value) && s.design == Design::one_at_a_time)
    most = std::abs(s.base.value);
  for (const Effect& e : s.effects)
    for (const double v : {e.low.value, e.high.value, e.mean_absolute.value})
      if (std::isfinite(v)) most = std::max(most, std::abs(v));
  return multiple(most, s.unit);
}

std::string with_unit(const std::string& words, const Multiple& m) {
  if (m.unit == "1") return words;
  return fmt::format("{} ({})", words, m.unit == "1/s" ? "/s" : m.unit);
}

/// A bar to a value of the quantity, its interval cut at the quantity's range.
Bar bar_within(const observe::IntervalEstimate& end, std::size_t colour, std::string note,
               const Sensitivity& s, const Multiple& m) {
  const double value = end.value, ci95 = end.half_width();
  const results::Range range = results::range_of(s.quantity);
  Bar bar{value / m.factor, ci95 / m.factor, colour, std::move(note)};
  if (!std::isfinite(value) || !std::isfinite(ci95)) return bar;
  bar.low = std::max(value - ci95, std::min(value, range.least)) / m.factor;
  bar.high = std::min(value + ci95, std::max(value, range.most)) / m.factor;
  return bar;
}

BarPlot one_at_a_time(const Sensitivity& s, const Multiple& m) {
  BarPlot plot{.title = label(s.quantity), .label = with_unit(label(s.quantity), m)};
  plot.base = s.base.value / m.factor;
  plot.legend = {"key at its low end", "at its high end"};
  for (const Effect& e : largest_first(s)) {
    BarGroup group{.name = e.key, .bars = {}};
    // Both ends of a key without effect coincide.
    const std::string low = e.inactive ? "" : e.low_end,
                      high = e.inactive ? e.low_end + ", " + e.high_end : e.high_end;
    group.bars.push_back(bar_within(e.low, 0, low, s, m));
    group.bars.push_back(bar_within(e.high, 1, high, s, m));
    // Two bars on the same side of the base would overlap.
    const bool one_side =
        !e.inactive && (e.low.value - s.base.value) * (e.high.value - s.base.value) >= 0;
    plot.side_by_side = plot.side_by_side || one_side;
    plot.groups.push_back(std::move(group));
  }
  return plot;
}

BarPlot morris(const Sensitivity& s, const Multiple& m) {
  BarPlot plot{.title = label(s.quantity), .label = with_unit("mean absolute effect, µ*", m)};
  for (const Effect& e : largest_first(s))
    plot.groups.push_back(
        {e.key,
         {{e.mean_absolute.value / m.factor, e.mean_absolute.half_width() / m.factor, 0, ""}}});
  return plot;
}

BarPlot sobol(const Sensitivity& s) {
  BarPlot plot{.title = label(s.quantity), .label = "share of the variance"};
  plot.side_by_side = true;
  plot.legend = {"first order, S1", "total, ST"};
  for (const Effect& e : largest_first(s))
    plot.groups.push_back(
        {e.key,
         {{e.first_order.value, e.first_order.half_width(), 0, ""},
          {e.total.value, e.total.half_width(), 1, "", e.total.low, e.total.high}}});
  return plot;
}

/// mu* and sigma of each key. A high sigma means a nonlinear effect or an interaction with other
/// keys.
Plot scatter_of(const Sensitivity& s, const Multiple& m) {
  Plot plot{.title = label(s.quantity),
            .x = Axis{.label = with_unit("mean absolute effect, µ*", m), .least = 0},
            .y = Axis{.label = with_unit("standard deviation, σ", m), .least = 0},
            .series = {},
            .shape = 0.65};
  for (const Effect& e : largest_first(s)) {
    Series series{.name = e.key, .mark = Mark::dots};
    series.x = {e.mean_absolute.value / m.factor};
    series.y = {e.deviation.value / m.factor};
    series.error = {e.deviation.half_width() / m.factor};
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string number_cell(double value, std::string_view text) {
  return fmt::format("<td class=\"n\" data-v=\"{}\">{}</td>",
                     std::isfinite(value) ? fmt::format("{}", value) : "", escaped(text));
}

std::string cell(const observe::IntervalEstimate& e, const Multiple& m, std::string_view unit) {
  return number_cell(e.value, readable(e.value, e.half_width(), unit, m.factor).number);
}

/// A total index and its interval, which may be asymmetric.
std::string total_cell(const observe::IntervalEstimate& total) {
  const auto [value, low, high] = total;
  if (!(low < high)) return number_cell(value, readable(value, NAN, "").number);
  return number_cell(value, fmt::format("{:.2g} ({:.2g} to {:.2g})", value, low, high));
}

std::string end_cells(std::string_view end, const observe::IntervalEstimate& at_end,
                      const Sensitivity& s, const Multiple& m) {
  return fmt::format("<td class=\"n\">{}</td>", escaped(end)) + cell(at_end, m, s.unit);
}

/// Whether the same number of effects, or groups, was used for each key.
bool counts_agree(const Sensitivity& s) {
  return std::ranges::all_of(s.effects,
                             [&](const Effect& e) { return e.count == s.effects.front().count; });
}

/// A sentence above the table: information common to all its numbers.
std::string lead(const Sensitivity& s, const Multiple& m) {
  if (s.design == Design::one_at_a_time)
    return fmt::format("Base case: {}.",
                       readable(s.base.value, s.base.half_width(), s.unit, m.factor).text());
  const bool shares = s.design == Design::sobol_indices;
  std::string text = counts_agree(s)
                         ? fmt::format("{}: {}.", shares ? "Groups of runs" : "Effects of each key",
                                       s.effects.front().count)
                         : "";
  if (!shares) return text;
  if (!std::isfinite(s.noise))
    return text +
           " The errors of the points are unknown: noise is included in the total index of every "
           "key.";
  return text + fmt::format(" Noise is {:.2g} % of the observed variance; it is subtracted.",
                            100 * s.noise);
}

std::vector<std::string> heads(const Sensitivity& s) {
  if (s.design == Design::one_at_a_time) return {"low end", "value", "high end", "value"};
  const bool shares = s.design == Design::sobol_indices;
  std::vector<std::string> names = shares ? std::vector<std::string>{"S1", "ST (interval)"}
                                          : std::vector<std::string>{"µ*", "from noise", "µ", "σ"};
  if (!counts_agree(s)) names.emplace_back(shares ? "groups" : "effects");
  return names;
}

std::string cells(const Effect& e, const Sensitivity& s, const Multiple& m) {
  if (s.design == Design::one_at_a_time)
    return end_cells(e.low_end, e.low, s, m) + end_cells(e.high_end, e.high, s, m);
  const std::string count =
      counts_agree(s) ? "" : number_cell(static_cast<double>(e.count), fmt::format("{}", e.count));
  if (s.design == Design::sobol_indices)
    return cell(e.first_order, m, "") + total_cell(e.total) + count;
  return cell(e.mean_absolute, m, s.unit) + cell({.value = e.of_noise}, m, s.unit) +
         cell(e.mean, m, s.unit) + cell(e.deviation, m, s.unit) + count;
}

/// Table of the numbers of the bars and further ones.
std::string numbers(const Sensitivity& s, const Multiple& m) {
  std::string head, body;
  for (const std::string& name : heads(s)) head += fmt::format("<th class=\"n\">{}</th>", name);
  for (const Effect& e : largest_first(s))
    body += fmt::format("<tr><td>{}</td>{}</tr>\n", escaped(e.key), cells(e, s, m));
  const std::string text = lead(s, m);
  return fmt::format(
      "{}<div class=\"wide\"><table class=\"laws\"><thead><tr><th>{}</th>{}</tr></thead>\n<tbody>"
      "\n{}</tbody></table></div>\n",
      text.empty() ? "" : fmt::format("<p>{}</p>\n", escaped(text)), escaped(with_unit("key", m)),
      head, body);
}

}  // namespace

double magnitude(const Effect& e, const Sensitivity& s) {
  if (s.design == Design::morris) return e.mean_absolute.value;
  if (s.design == Design::sobol_indices)
    return std::isfinite(e.total.value) ? e.total.value : e.first_order.value;
  double least = INFINITY, most = -INFINITY;
  for (const double v : {e.low.value, e.high.value, s.base.value})
    if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  return std::isfinite(e.low.value) || std::isfinite(e.high.value) ? most - least : NAN;
}

std::vector<Effect> largest_first(const Sensitivity& s) {
  std::vector<Effect> list = s.effects;
  std::ranges::stable_sort(list, std::greater{}, [&](const Effect& e) {
    const double size = magnitude(e, s);
    return std::isfinite(size) ? size : -INFINITY;
  });
  return list;
}

std::vector<Picture> sensitivity_pictures(const Sensitivity& s) {
  const auto known = [&](const Effect& e) { return std::isfinite(magnitude(e, s)); };
  if (std::ranges::none_of(s.effects, known)) return {};
  const Multiple m = multiple_of(s);
  const std::string below = numbers(s, m);
  if (s.design == Design::morris)
    return {{picture_json(morris(s, m)), below}, {picture_json(scatter_of(s, m))}};
  if (s.design == Design::sobol_indices) return {{picture_json(sobol(s)), below}};
  if (!std::isfinite(s.base.value)) return {};  // no base for the bars
  return {{picture_json(one_at_a_time(s, m)), below}};
}

}  // namespace mahlwerk::report

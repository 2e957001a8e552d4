// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/plot_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace mahlwerk::report {
namespace {

constexpr std::array<std::string_view, 7> mark_words{"line",    "points", "dots", "steps",
                                                     "squares", "area",   "note"};

/// Seven digits: more than a picture shows.
std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "null";
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : ",") + number(v);
  return "[" + text + "]";
}

std::string axis_json(const Axis& axis) {
  return fmt::format("{{\"label\":{},\"log\":{},\"least\":{},\"most\":{}}}",
                     json_string(axis.label), axis.logarithmic, number(axis.least),
                     number(axis.most));
}

/// The ends of the intervals as they are drawn; empty if no point has one.
std::array<std::vector<double>, 2> ends_of(const Series& s, const Axis& y) {
  std::array<std::vector<double>, 2> ends;
  bool known = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const Interval one = interval_at(s, i, y);
    known = known || one.known();
    ends[0].push_back(one.low);
    ends[1].push_back(one.high);
  }
  return known ? ends : std::array<std::vector<double>, 2>();
}

std::string series_json(const Series& s, std::size_t index, const Axis& y) {
  const auto [low, high] = ends_of(s, y);
  std::string intervals;
  if (!low.empty()) intervals = fmt::format(",\"low\":{},\"high\":{}", list(low), list(high));
  return fmt::format(
      "{{\"name\":{},\"mark\":\"{}\",\"colour\":{},\"band\":{},\"x\":{},\"y\":{}{}}}",
      json_string(s.name), mark_words[static_cast<std::size_t>(s.mark)], s.colour.value_or(index),
      s.band, list(s.x), list(s.y), intervals);
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (byte < 0x20 || c == '<' || c == '>' || c == '&')
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  }
  return out + "\"";
}

std::string plot_json(const Plot& plot) {
  std::string series;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    series += (i > 0 ? "," : "") + series_json(plot.series[i], i, plot.y);
  return fmt::format("{{\"title\":{},\"x\":{},\"y\":{},\"series\":[{}],\"shape\":{}}}",
                     json_string(plot.title), axis_json(plot.x), axis_json(plot.y), series,
                     number(plot.height / plot.width));
}

std::string drawing(std::string_view svg, std::string_view json) {
  return json.empty() ? std::string(svg)
                      : fmt::format(
                            "<noscript>{}</noscript><script type=\"application/json\" "
                            "class=\"plot\">{}</script>\n",
                            svg, json);
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/picture_json.hpp"

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

/// Four digits, for the many numbers of a map.
std::string brief(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "null";
}

/// The texts of `each` for all of them, as a list.
template <typename T, typename Each>
std::string list_of(const std::vector<T>& all, const Each& each) {
  std::string text;
  for (const auto& one : all) text += (text.empty() ? "" : ",") + each(one);
  return "[" + text + "]";
}

std::string list(const std::vector<double>& values) {
  return list_of(values, number);
}
std::string list(const std::vector<std::string>& texts) {
  return list_of(texts, json_string);
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

std::string bar_json(const Bar& b) {
  return fmt::format("{{\"end\":{},\"low\":{},\"high\":{},\"colour\":{},\"note\":{}}}",
                     number(b.end), number(b.least()), number(b.most()), b.colour,
                     json_string(b.note));
}

std::string group_json(const BarGroup& group) {
  return fmt::format("{{\"name\":{},\"bars\":{}}}", json_string(group.name),
                     list_of(group.bars, bar_json));
}

std::string map_axis_json(const MapAxis& axis) {
  return fmt::format(
      "{{\"label\":{},\"log\":{},\"unit\":{},{}}}", json_string(axis.label), axis.logarithmic,
      json_string(axis.unit),
      axis.names.empty() ? "\"edges\":" + list(axis.edges) : "\"names\":" + list(axis.names));
}

std::string panel_json(const MapPanel& panel) {
  std::string more;
  if (!panel.told.empty()) more += ",\"told\":" + list(panel.told);
  if (!panel.failed.empty())
    more += ",\"failed\":" +
            list_of(panel.failed, [](bool one) -> std::string { return one ? "true" : "false"; });
  if (!panel.arrows.empty()) more += ",\"arrows\":" + list_of(panel.arrows, brief);
  return fmt::format(
      "{{\"title\":{},\"x\":{},\"y\":{},\"polar\":{},\"ring\":{},\"diagonal\":{},\"width\":{},"
      "\"shape\":{},\"values\":{}{}}}",
      json_string(panel.title), map_axis_json(panel.x), map_axis_json(panel.y), panel.polar,
      number(panel.ring), panel.diagonal, number(panel.width), number(panel.shape),
      list_of(panel.values, brief), more);
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

std::string picture_json(const Plot& plot) {
  std::string series;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    series += (i > 0 ? "," : "") + series_json(plot.series[i], i, plot.y);
  return fmt::format(
      "{{\"kind\":\"plot\",\"title\":{},\"x\":{},\"y\":{},\"series\":[{}],\"shape\":{}}}",
      json_string(plot.title), axis_json(plot.x), axis_json(plot.y), series, number(plot.shape));
}

std::string picture_json(const BarPlot& plot) {
  return fmt::format(
      "{{\"kind\":\"bars\",\"title\":{},\"label\":{},\"base\":{},\"side_by_side\":{},\"legend\":{},"
      "\"groups\":{}}}",
      json_string(plot.title), json_string(plot.label), number(plot.base), plot.side_by_side,
      list(plot.legend), list_of(plot.groups, group_json));
}

std::string picture_json(const ColourMap& map) {
  return fmt::format(
      "{{\"kind\":\"map\",\"title\":{},\"quantity\":{},\"unit\":{},\"least\":{},\"most\":{},"
      "\"log\":{},\"note\":{},\"words\":{},\"panels\":{}}}",
      json_string(map.title), json_string(map.quantity), json_string(map.unit), number(map.least),
      number(map.most), map.logarithmic, json_string(map.note), list(map.words),
      list_of(map.panels, panel_json));
}

std::string drawing(std::string_view json) {
  return fmt::format("<script type=\"application/json\" class=\"picture\">{}</script>\n", json);
}

}  // namespace mahlwerk::report

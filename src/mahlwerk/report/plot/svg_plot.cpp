// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/plot/rich_text.hpp"
#include "mahlwerk/report/plot/scale.hpp"
#include "mahlwerk/report/plot/svg_element.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::size_t colour_count = 7;  // higher indices are dashed
constexpr std::array<std::string_view, 3> dashes{"", "7 3", "2 3"};
constexpr double area_opacity = 0.25;
constexpr double narrow = 400;  // [px] width up to which margins and dots are small

double letter_of(double font) {
  return letter_width * font / 12;
}

bool has_dots(const Series& s) {
  return s.mark == Mark::points || s.mark == Mark::dots || s.mark == Mark::squares;
}

double dot_radius(const Plot& plot) {
  return plot.width > narrow ? 3.5 : 2.6;
}

std::string square(double x, double y) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"7\" height=\"7\" fill=\"{}\"/>\n",
                     x - 3.5, y - 3.5, ink_colour);
}

/// Layout of a plot, and its SVG text.
class Canvas {
 public:
  explicit Canvas(const Plot& plot);
  std::string drawn() { return std::move(text_); }

 private:
  double across(double v) const { return left_ + x_.at(v) * (right_ - left_); }
  double down(double v) const { return bottom_ - y_.at(v) * (bottom_ - top_); }
  bool inside(double v, const AxisScale& s) const { return is_plottable(v, s.logarithmic); }
  /// Vertical position, clamped far outside the visible area.
  double cut_down(double v) const {
    return std::isfinite(v) && (!y_.logarithmic || v > 0) ? std::clamp(down(v), -1e4, 1e4) : 1e4;
  }

  void measure();
  void place_legend();
  void words(double x, double y, std::string_view anchor, std::string_view what,
             std::string_view extra = "");
  void grid();
  void legend();
  void band(const Series& s, std::string_view colour);
  void line(const Series& s, std::string_view colour, std::string_view dash);
  void points(const Series& s, std::string_view colour);
  void steps(const Series& s, std::string_view colour, bool filled);
  void many(const Series& s, std::string_view colour);

  const Plot& plot_;
  AxisScale x_, y_;
  double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
  struct Entry {
    std::size_t series;
    double x, y;
    std::vector<std::string> lines;
  };
  std::vector<Entry> entries_;  // of the legend
  std::vector<std::string> y_label_;
  std::string text_;
};

Canvas::Canvas(const Plot& plot) : plot_(plot), x_(plot.x.logarithmic), y_(plot.y.logarithmic) {
  measure();
  text_ = svg_head(plot.width, plot.height, plot.title, plot.font);
  grid();
  legend();
  // Dots on an axis are drawn whole.
  const double dot = std::ranges::any_of(plot.series, has_dots) ? 4 : 0;
  // An inner <svg> clips without an id; clip paths would need unique ids on pages with several
  // plots.
  text_ += fmt::format(
      "<svg x=\"{0:g}\" y=\"{1:g}\" width=\"{2:g}\" height=\"{3:g}\" viewBox=\"{0:g} {1:g} {2:g} "
      "{3:g}\" overflow=\"hidden\">\n",
      left_ - dot, top_ - dot, right_ - left_ + 2 * dot, bottom_ - top_ + 2 * dot);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    const std::size_t number = s.colour.value_or(i);
    const std::string_view colour = kind_colour(number);
    if (s.mark == Mark::note) continue;
    if (s.mark == Mark::steps) {
      steps(s, colour, i == 0);
      continue;
    }
    if (s.band || s.mark == Mark::area) band(s, colour);
    if (s.mark == Mark::line || s.mark == Mark::points)
      line(s, colour, dashes[number / colour_count % dashes.size()]);
    if (s.mark == Mark::points || s.mark == Mark::dots) points(s, colour);
    if (s.mark == Mark::squares) points(s, ink_colour);
  }
  text_ += "</svg>\n</svg>\n";
}

void Canvas::measure() {
  // If no value is negative, intervals are cut at 0.
  const bool positive = std::ranges::all_of(plot_.series, [](const Series& s) {
    return std::ranges::none_of(s.y, [](double v) { return v < 0; });
  });
  for (const Series& s : plot_.series) {
    for (const double v : s.x) x_.include(v);
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      if (s.mark != Mark::area) y_.include(s.y[i]);
      const Interval ends = interval_at(s, i, plot_.y);
      // An error bar may reach below 0, beyond a logarithmic axis.
      y_.include(positive && s.mark != Mark::area ? std::max(ends.low, 0.0) : ends.low);
      y_.include(ends.high);
    }
  }
  const bool points = std::ranges::any_of(plot_.series, has_dots);
  x_.set_limits(plot_.x, points);
  y_.set_limits(plot_.y, true);
  std::size_t widest = 0;
  for (const double v : ticks(y_.least, y_.most, y_.logarithmic, 5))
    widest = std::max(widest, width(tick_text(v, y_.logarithmic)));
  const double letter = letter_of(plot_.font);
  left_ = 34 + letter * static_cast<double>(widest);
  if (plot_.width > narrow) left_ = std::max(62.0, left_);
  right_ = plot_.width - 16;
  top_ = plot_.title.empty() ? 12 : 34;
  place_legend();
  bottom_ = plot_.height - (plot_.width > narrow ? 46 : 42);
  y_label_ = balanced(plot_.y.label, static_cast<std::size_t>((bottom_ - top_) / letter));
  const double shift = (plot_.font + 1) * std::max(0.0, static_cast<double>(y_label_.size()) - 1);
  left_ += shift;
  if (plot_.width > narrow)
    for (Entry& entry : entries_) entry.x += shift;
}

/// Places the legend above the plot, in as many rows as it needs. An entry that is wider than the
/// plot has several lines.
void Canvas::place_legend() {
  const double letter = letter_of(plot_.font), begin = plot_.width > narrow ? left_ : 14,
               row = plot_.font + 6, line = plot_.font + 2;
  const auto most = static_cast<std::size_t>((right_ - begin - 24) / letter);
  double x = begin, y = top_ + 6;
  for (std::size_t i = 0; i < plot_.series.size(); ++i) {
    const std::string& name = plot_.series[i].name;
    if (name.empty()) continue;
    const double room = 44 + letter * static_cast<double>(width(plain_text(name)));
    if (x > begin && x + room - 20 > right_) {
      x = begin;
      y += row;
    }
    std::vector<std::string> lines = wrapped(name, most);
    entries_.push_back({i, x, y, lines});
    x += room;
    y += line * (std::max(1.0, static_cast<double>(lines.size())) - 1);
  }
  if (!entries_.empty()) top_ = y + 14;
}

void Canvas::words(double x, double y, std::string_view anchor, std::string_view what,
                   std::string_view extra) {
  text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, extra, rich_text(what, plot_.font));
}

void Canvas::grid() {
  constexpr std::string_view rule = "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"/>\n";
  const std::string soft = fmt::format(" fill=\"{}\"", soft_colour);
  const int wanted = std::clamp(static_cast<int>(plot_.width / 56), 3, 7);
  for (const double v : ticks(x_.least, x_.most, x_.logarithmic, wanted)) {
    const double x = across(v);
    text_ += fmt::format(rule, x, top_, x, bottom_, grid_colour);
    words(x, bottom_ + 17, "middle", tick_text(v, x_.logarithmic), soft);
  }
  for (const double v : ticks(y_.least, y_.most, y_.logarithmic, 5)) {
    const double y = down(v);
    text_ += fmt::format(rule, left_, y, right_, y, grid_colour);
    words(left_ - 7, y + 4, "end", tick_text(v, y_.logarithmic), soft);
  }
  text_ += fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}L{0:.1f} {2:.1f}L{3:.1f} {2:.1f}\" fill=\"none\" "
      "stroke=\"{4}\"/>\n",
      left_, top_, bottom_, right_, soft_colour);
  if (!plot_.title.empty())
    words(left_, 18, "start", plot_.title, title_style(plot_.title, plot_.width - left_ - 4));
  words(0.5 * (left_ + right_), plot_.height - 8, "middle", plot_.x.label);
  const double middle = 0.5 * (top_ + bottom_);
  double x = 14;
  for (const std::string& line : y_label_) {
    words(x, middle, "middle", line,
          fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", x, middle));
    x += plot_.font + 1;
  }
}

void Canvas::legend() {
  for (const Entry& entry : entries_) {
    const Series& s = plot_.series[entry.series];
    const std::size_t number = s.colour.value_or(entry.series);
    const std::string_view colour = kind_colour(number);
    const double x = entry.x, y = entry.y - 4;
    if (s.mark == Mark::dots)
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"/>\n", x + 9,
                           y, dot_radius(plot_), colour);
    else if (s.mark == Mark::squares)
      text_ += square(x + 9, y);
    else if (s.mark == Mark::area)
      text_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"18\" height=\"10\" fill=\"{}\" "
          "fill-opacity=\"{}\"/>\n",
          x, y - 5, colour, area_opacity);
    else if (s.mark != Mark::note)
      text_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}h18\" stroke=\"{}\" stroke-width=\"{}\" "
          "stroke-dasharray=\"{}\"/>\n",
          x, y, colour, s.mark == Mark::steps ? 3 : 2,
          dashes[number / colour_count % dashes.size()]);
    if (s.mark == Mark::points)
      text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"/>\n", x + 9,
                           y, dot_radius(plot_), colour);
    double row = entry.y;
    for (const std::string& line : entry.lines) {
      words(x + (s.mark == Mark::note ? 0 : 24), row, "start", line);
      row += plot_.font + 2;
    }
  }
}

/// Shaded band of the errors, interrupted at points without error.
void Canvas::band(const Series& s, std::string_view colour) {
  std::string path, back;
  const auto close = [&] {
    if (!back.empty()) path += back + "Z";
    back.clear();
  };
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const Interval ends = interval_at(s, i, plot_.y);
    const bool drawn = s.mark == Mark::area || (i < s.y.size() && inside(s.y[i], y_));
    if (!drawn || !inside(s.x[i], x_) || !ends.known()) {
      close();
      continue;
    }
    const double x = across(s.x[i]);
    path += fmt::format("{}{:.1f} {:.1f}", back.empty() ? 'M' : 'L', x, cut_down(ends.high));
    back = fmt::format("L{:.1f} {:.1f}", x, cut_down(ends.low)) + back;
  }
  close();
  text_ += fmt::format("<path d=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", path, colour,
                       s.mark == Mark::area ? area_opacity : 0.16);
}

void Canvas::line(const Series& s, std::string_view colour, std::string_view dash) {
  std::string path;
  bool pen_up = true;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    const bool there = inside(s.x[i], x_) && inside(s.y[i], y_);
    if (there)
      path += fmt::format("{}{:.1f} {:.1f}", pen_up ? 'M' : 'L', across(s.x[i]), cut_down(s.y[i]));
    pen_up = !there;
  }
  text_ += fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\" "
      "stroke-linejoin=\"round\"/>\n",
      path, colour, s.mark == Mark::points ? 1 : 1.6, dash);
}

/// Many points as small dots, without error bars; overlapping dots are drawn once.
void Canvas::many(const Series& s, std::string_view colour) {
  std::set<std::pair<int, int>> places;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i)
    if (inside(s.x[i], x_) && inside(s.y[i], y_))
      places.emplace(static_cast<int>(std::lround(across(s.x[i]))),
                     static_cast<int>(std::lround(cut_down(s.y[i]))));
  std::string path;
  for (const auto& [x, y] : places) path += fmt::format("M{} {}h0", x, y);
  text_ += fmt::format(
      "<path d=\"{}\" stroke=\"{}\" stroke-width=\"3.6\" stroke-linecap=\"round\" "
      "stroke-opacity=\"0.55\" fill=\"none\"/>\n",
      path, colour);
}

void Canvas::points(const Series& s, std::string_view colour) {
  constexpr std::size_t few = 300;
  if (s.mark == Mark::dots && s.x.size() > few) return many(s, colour);
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    if (!inside(s.x[i], x_) || !inside(s.y[i], y_)) continue;
    const double x = across(s.x[i]), y = cut_down(s.y[i]);
    const Interval ends = interval_at(s, i, plot_.y);
    if (ends.low < ends.high)
      text_ += fmt::format(
          "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h6M{3:.1f} {2:.1f}h6\" stroke=\"{4}\" "
          "fill=\"none\"/>\n",
          x, cut_down(ends.high), cut_down(ends.low), x - 3, colour);
    text_ += s.mark == Mark::squares
                 ? square(x, y)
                 : fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"/>\n", x,
                               y, dot_radius(plot_), colour);
  }
}

void Canvas::steps(const Series& s, std::string_view colour, bool filled) {
  const std::size_t bins = std::min(s.y.size(), s.x.empty() ? 0 : s.x.size() - 1);
  std::string path;
  for (std::size_t i = 0; i < bins; ++i) {
    const double low = inside(s.x[i], x_) ? across(s.x[i]) : left_ - 10;
    if (path.empty()) path = fmt::format("M{:.1f} {:.1f}", low, bottom_ + 5);
    path +=
        fmt::format("V{:.1f}H{:.1f}", std::min(cut_down(s.y[i]), bottom_ + 5), across(s.x[i + 1]));
  }
  if (bins > 0) path += fmt::format("V{:.1f}", bottom_ + 5);
  text_ += fmt::format(
      "<path d=\"{0}\" fill=\"{1}\" fill-opacity=\"{2}\" stroke=\"{1}\" stroke-width=\"1.6\"/>\n",
      path, colour, filled ? 0.15 : 0);
}

}  // namespace

Interval interval_at(const Series& s, std::size_t i, const Axis& y) {
  Interval ends;
  if (i < s.low.size() && i < s.high.size())
    ends = {s.low[i], s.high[i]};
  else if (i < s.y.size() && i < s.error.size() && s.error[i] >= 0)
    ends = {s.y[i] - s.error[i], s.y[i] + s.error[i]};
  if (!std::isfinite(ends.low) || !std::isfinite(ends.high)) return {};
  // A value outside the range stays inside its interval.
  const bool has_value = i < s.y.size() && std::isfinite(s.y[i]);
  const double least = has_value ? std::min(y.range_least, s.y[i]) : y.range_least,
               most = has_value ? std::max(y.range_most, s.y[i]) : y.range_most;
  return {std::clamp(ends.low, least, most), std::clamp(ends.high, least, most)};
}

std::string svg(const Plot& plot) {
  return Canvas(plot).drawn();
}

}  // namespace mahlwerk::report

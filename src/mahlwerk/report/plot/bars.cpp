// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/plot/scale.hpp"
#include "mahlwerk/report/plot/svg_element.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr double row_height = 26, thick = 16, thin = 9;

class BarDrawing {
 public:
  explicit BarDrawing(const BarPlot& plot) : plot_(plot) {
    measure();
    legend();
    scale();
    double y = top_;
    for (const BarGroup& group : plot.groups) {
      text(left_ - 8, y + 0.5 * height_of(group) + 4, "end", group.name);
      bars(group, y);
      text_ += std::exchange(notes_, "");  // above the error bars of the other bar
      y += height_of(group);
    }
    const double x = across(plot.base);
    text_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\"/>\n", x, top_,
                         bottom_, ink_colour);
  }
  std::string drawn() const {
    return svg_head(plot_width, bottom_ + 46, plot_.title) + text_ + "</svg>\n";
  }

 private:
  double across(double v) const {
    return left_ + (v - least_) / (most_ - least_) * (right_ - left_);
  }
  double height_of(const BarGroup& group) const {
    return plot_.side_by_side
               ? std::max(row_height, 10 + 11.0 * static_cast<double>(group.bars.size()))
               : row_height;
  }
  static std::string worded(double x, double y, std::string_view anchor, std::string_view what,
                            std::string_view extra) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, extra, escaped(what));
  }
  void text(double x, double y, std::string_view anchor, std::string_view what,
            std::string_view extra = "") {
    text_ += worded(x, y, anchor, what, extra);
  }
  void measure();
  void legend();
  void scale();
  void bars(const BarGroup& group, double y);
  void bar(const Bar& b, double y, double size);

  const BarPlot& plot_;
  double left_ = 0, right_ = 0, top_ = 34, bottom_ = 0, least_ = 0, most_ = 1;
  std::string text_, notes_;
};

/// Computes the scale, with room for names on the left and notes at both ends of the bars.
void BarDrawing::measure() {
  std::size_t name = 0, note = 0;
  least_ = most_ = plot_.base;
  for (const BarGroup& group : plot_.groups) {
    name = std::max(name, width(group.name));
    for (const Bar& b : group.bars) {
      note = std::max(note, width(b.note));
      if (!std::isfinite(b.end)) continue;
      least_ = std::min({least_, b.end, b.least()});
      most_ = std::max({most_, b.end, b.most()});
    }
  }
  if (!(most_ > least_)) most_ = least_ + std::max(1.0, std::abs(least_));
  left_ = std::clamp(16 + letter_width * static_cast<double>(name), 60.0, 0.45 * plot_width);
  right_ = plot_width - 16;
  const double share = (letter_width * static_cast<double>(note) + 12) / (right_ - left_),
               wide = most_ - least_;
  const double room = wide * std::min(share / (1 - 2 * std::min(share, 0.35)) + 0.02, 1.0);
  if (least_ < plot_.base) least_ -= room;
  if (most_ > plot_.base) most_ += room;
}

void BarDrawing::legend() {
  text(16, 18, "start", plot_.title, title_style(plot_.title, plot_width - 20));
  double x = left_;
  for (std::size_t i = 0; i < plot_.legend.size(); ++i) {
    text_ += fmt::format("<rect x=\"{:.1f}\" y=\"30\" width=\"12\" height=\"12\" fill=\"{}\"/>\n",
                         x, kind_colour(i));
    text(x + 18, 40.5, "start", plot_.legend[i]);
    x += 36 + letter_width * static_cast<double>(width(plot_.legend[i]));
  }
  if (!plot_.legend.empty()) top_ += 20;
  bottom_ = top_;
  for (const BarGroup& group : plot_.groups) bottom_ += height_of(group);
}

void BarDrawing::scale() {
  for (const double v : ticks(least_, most_, false, 5)) {
    const double x = across(v);
    text_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\"/>\n", x, top_,
                         bottom_, grid_colour);
    text(x, bottom_ + 17, "middle", tick_text(v, false), fmt::format(" fill=\"{}\"", soft_colour));
  }
  text(0.5 * (left_ + right_), bottom_ + 37, "middle", plot_.label);
}

void BarDrawing::bars(const BarGroup& group, double y) {
  const double height = height_of(group);
  if (!plot_.side_by_side) {
    for (const Bar& b : group.bars) bar(b, y + 0.5 * (height - thick), thick);
    return;
  }
  double at = y + 0.5 * (height - 11.0 * static_cast<double>(group.bars.size())) + 1;
  for (const Bar& b : group.bars) {
    bar(b, at, thin);
    at += 11;
  }
}

void BarDrawing::bar(const Bar& b, double y, double size) {
  if (!std::isfinite(b.end)) return;
  const double from = across(plot_.base), to = across(b.end), middle = y + 0.5 * size;
  text_ += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
      "fill-opacity=\"0.85\"/>\n",
      std::min(from, to), y, std::abs(to - from), size, kind_colour(b.colour));
  const double low = across(b.least()), high = across(b.most());
  if (b.least() < b.most()) {
    text_ += fmt::format(
        "<path d=\"M{0:.1f} {2:.1f}H{1:.1f}M{0:.1f} {3:.1f}v6M{1:.1f} {3:.1f}v6\" fill=\"none\" "
        "stroke=\"{4}\"/>\n",
        low, high, middle, middle - 3, ink_colour);
  }
  if (b.note.empty()) return;
  const bool left = b.end < plot_.base;
  notes_ += worded(left ? std::min(low, to) - 5 : std::max(high, to) + 5, middle + 4,
                   left ? "end" : "start", b.note,
                   fmt::format(" font-size=\"11\" fill=\"{}\" stroke=\"{}\" stroke-width=\"3\" "
                               "paint-order=\"stroke\"",
                               soft_colour, ground_colour));
}

}  // namespace

std::string svg(const BarPlot& plot) {
  return BarDrawing(plot).drawn();
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/cell_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/plot/scale.hpp"
#include "mahlwerk/report/plot/svg_element.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::size_t titled = 900;  // larger maps have no tooltips

std::string words(double x, double y, std::string_view anchor, std::string_view text,
                  std::string_view extra = " fill=\"#59636e\"") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, extra, escaped(text));
}

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t most = 0;
  for (const std::string& text : texts) most = std::max(most, width(text));
  return most;
}

class MapDrawing {
 public:
  explicit MapDrawing(const CellMap& map) : map_(map) {
    left_ = std::clamp(34 + letter_width * static_cast<double>(widest(map.y)), 62.0, 200.0);
    wide_ = (plot_width - 16 - left_) / static_cast<double>(std::max<std::size_t>(map.x.size(), 1));
    const double rows = static_cast<double>(std::max<std::size_t>(map.y.size(), 1));
    tall_ = std::clamp(240 / rows, 0.5, 44.0);
    bottom_ = top_ + tall_ * rows;
    if (map.cells.size() <= titled) {
      each_cell();
    } else {
      runs_of_cells();
    }
    axes();
    key();
  }
  std::string drawn() const {
    return svg_head(plot_width, height_, map_.title) +
           words(left_, 18, "start", map_.title, title_style(map_.title, plot_width - left_ - 4)) +
           text_ + "</svg>\n";
  }

 private:
  double across(std::size_t i) const { return left_ + wide_ * static_cast<double>(i); }
  double down(std::size_t j) const { return bottom_ - tall_ * static_cast<double>(j + 1); }

  void each_cell();
  void runs_of_cells();
  void cross_out(double x, double y);
  void axes();
  void key();

  const CellMap& map_;
  double left_ = 0, top_ = 32, bottom_ = 0, wide_ = 0, tall_ = 0, height_ = 0;
  std::string text_;
};

void MapDrawing::cross_out(double x, double y) {
  text_ += fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}l{2:.1f} {3:.1f}m0 {4:.1f}l{5:.1f} {3:.1f}\" fill=\"none\" "
      "stroke=\"{6}\"/>\n",
      x + 0.3 * wide_, y + 0.3 * tall_, 0.4 * wide_, 0.4 * tall_, -0.4 * tall_, -0.4 * wide_,
      soft_colour);
}

/// Draws each cell. Texts are drawn in all cells or in none.
void MapDrawing::each_cell() {
  std::size_t longest = 0;
  for (const Cell& cell : map_.cells) longest = std::max(longest, width(cell.text));
  const bool fits = letter_width * static_cast<double>(longest) < wide_ - 2 && tall_ >= 15;
  for (std::size_t n = 0; n < map_.cells.size(); ++n) {
    const Cell& cell = map_.cells[n];
    const double x = across(n % map_.x.size()), y = down(n / map_.x.size());
    if (cell.colour.empty() && !cell.failed) continue;
    text_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill=\"{}\" stroke=\"{}\"><title>{}</title></rect>\n",
        x, y, wide_, tall_, cell.failed ? failed_colour : std::string_view(cell.colour),
        ground_colour, escaped(cell.title));
    if (cell.failed) cross_out(x, y);
    if (fits && !cell.text.empty())
      text_ +=
          words(x + 0.5 * wide_, y + 0.5 * tall_ + 4, "middle", cell.text,
                fmt::format(" font-size=\"11\" pointer-events=\"none\" fill=\"{}\"", cell.ink));
  }
}

/// Draws neighbouring cells of the same colour in a row as one path.
void MapDrawing::runs_of_cells() {
  const std::size_t columns = map_.x.size();
  for (std::size_t j = 0; j < map_.y.size(); ++j)
    for (std::size_t i = 0, end = 0; i < columns; i = end) {
      const std::string& colour = map_.cells[j * columns + i].colour;
      end = i + 1;
      while (end < columns && map_.cells[j * columns + end].colour == colour) ++end;
      if (!colour.empty())
        text_ += fmt::format("<path fill=\"{}\" d=\"M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z\"/>",
                             colour, across(i), down(j), wide_ * static_cast<double>(end - i) + 0.3,
                             tall_ + 0.3, -wide_ * static_cast<double>(end - i) - 0.3);
    }
  text_ += "\n";
}

/// Draws the axes with as many ticks as fit.
void MapDrawing::axes() {
  const double room = letter_width * static_cast<double>(widest(map_.x)) + 10;
  const auto each = static_cast<std::size_t>(std::max(1.0, std::ceil(room / wide_)));
  for (std::size_t i = 0; i < map_.x.size(); i += each)
    text_ += words(across(i) + 0.5 * wide_, bottom_ + 17, "middle", map_.x[i]);
  const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(15 / tall_)));
  for (std::size_t j = 0; j < map_.y.size(); j += every)
    text_ += words(left_ - 7, down(j) + 0.5 * tall_ + 4, "end", map_.y[j]);
  const double middle = 0.5 * (top_ + bottom_);
  text_ += words(0.5 * (left_ + plot_width - 16), bottom_ + 37, "middle", map_.x_label, "");
  text_ += words(14, middle, "middle", map_.y_label,
                 fmt::format(" transform=\"rotate(-90 14 {:.1f})\"", middle));
}

void MapDrawing::key() {
  double y = bottom_ + 54;
  constexpr int levels = 32;
  if (map_.legend.words.empty()) {
    const double part = (plot_width - 16 - left_) / levels;
    for (int i = 0; i < levels; ++i)
      text_ +=
          fmt::format("<path fill=\"{}\" d=\"M{:.1f} {:.1f}h{:.2f}v9h{:.2f}z\"/>",
                      viridis((i + 0.5) / levels), left_ + part * i, y, part + 0.5, -part - 0.5);
    text_ += "\n" + words(left_, y + 24, "start", map_.legend.low) +
             words(0.5 * (left_ + plot_width - 16), y + 24, "middle", map_.legend.about) +
             words(plot_width - 16, y + 24, "end", map_.legend.high);
    height_ = y + 32;
    return;
  }
  double x = left_;
  for (const auto& [colour, word] : map_.legend.words) {
    const double room = 34 + letter_width * static_cast<double>(width(word));
    if (x > left_ && x + room > plot_width) {
      x = left_;
      y += 20;
    }
    text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"12\" height=\"12\" fill=\"{}\"/>",
                         x, y, colour);
    text_ += words(x + 18, y + 10.5, "start", word, "");
    x += room;
  }
  height_ = y + 22;
}

}  // namespace

std::string svg(const CellMap& map) {
  return MapDrawing(map).drawn();
}

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/figure_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/report/plot/rich_text.hpp"
#include "mahlwerk/report/plot/scale.hpp"
#include "mahlwerk/report/plot/svg_element.hpp"

namespace mahlwerk::report {
namespace {

constexpr double line_height = 14, gap = 10, letter_room = 14;

/// A drawn part of the figure with its size [px].
struct Part {
  std::string text;
  double width = 0, height = 0;
};

/// Lines of a title from (x, y) downwards; adds their height to `y`.
std::string title_lines(const std::string& title, double x, double room, double& y) {
  const double letter = letter_width * figure_font / 12;
  std::string text;
  for (const std::string& line :
       balanced(title, static_cast<std::size_t>(std::max(1.0, room / letter)))) {
    y += line_height;
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y - 3,
                        rich_text(line, figure_font));
  }
  return text;
}

/// Letter, title and drawing of a panel at (x, y); `head`: height of the titles in its row.
Part titled_panel(const FigurePanel& panel, double x, double y, double head) {
  Part part{.text = "", .width = panel.width};
  double down = y;
  const double indent =
      panel.letter.empty() ? 0 : letter_room - 6 + 7 * static_cast<double>(panel.letter.size());
  if (!panel.letter.empty())
    part.text = fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" font-weight=\"700\">{}</text>\n", x + 2,
        y + line_height - 3, rich_text(panel.letter, 13));
  part.text += title_lines(panel.title, x + 2 + indent, panel.width - indent - 8, down);
  if (!panel.letter.empty()) down = std::max(down, y + line_height);
  down = std::max(down, y + head);
  part.height = down - y;
  if (panel.svg.empty()) return part;
  part.text += nested_svg(panel.svg, x, down, panel.width, panel.height, figure_font);
  part.height += panel.height;
  return part;
}

double title_height(const FigurePanel& panel) {
  FigurePanel bare = panel;
  bare.svg.clear();
  return titled_panel(bare, 0, 0, 0).height;
}

double width_of(const FigureBlock& block) {
  double wide = 0;
  for (const FigurePanel& panel : block.panels) wide += panel.width;
  return std::min(wide, page_width);
}

/// The rows of panels of a block.
std::vector<std::vector<const FigurePanel*>> rows_of(const FigureBlock& block) {
  std::vector<std::vector<const FigurePanel*>> rows;
  double x = page_width;
  for (const FigurePanel& panel : block.panels) {
    if (rows.empty() || x + panel.width > page_width) rows.emplace_back(), x = 0;
    rows.back().push_back(&panel);
    x += panel.width;
  }
  return rows;
}

/// Heights of the titles in a row of blocks, so that its drawings begin at the same height.
struct RowTitles {
  double of_blocks = 0, of_panels = 0;  // [px]
};

double block_title_height(const FigureBlock& block, double room) {
  double height = 0;
  title_lines(block.title, 0, room, height);
  return height > 0 ? height + 3 : 0;
}

Part drawn_block(const FigureBlock& block, double x, double y, double room,
                 const RowTitles& titles) {
  Part part{.text = "", .width = width_of(block)};
  double down = y;
  part.text = title_lines(block.title, x + 2, room, down);
  down = y + titles.of_blocks;
  double head = titles.of_panels;
  for (const auto& row : rows_of(block)) {
    double across = x, bottom = down;
    for (const FigurePanel* panel : row) head = std::max(head, title_height(*panel));
    for (const FigurePanel* panel : row) {
      const Part one = titled_panel(*panel, across, down, head);
      part.text += one.text;
      across += panel->width;
      bottom = std::max(bottom, down + one.height);
    }
    down = bottom + gap;
    head = 0;
  }
  part.height = down - y;
  return part;
}

/// A row of blocks from the height y [px] downwards.
Part drawn_row(const std::vector<const FigureBlock*>& row, double y) {
  Part part;
  RowTitles titles;
  const auto room = [&](const FigureBlock& block) {
    return (row.size() == 1 ? std::max(column_width, width_of(block)) : width_of(block)) - 8;
  };
  for (const FigureBlock* block : row) {
    titles.of_blocks = std::max(titles.of_blocks, block_title_height(*block, room(*block)));
    const auto panels = rows_of(*block);
    for (const FigurePanel* panel : panels.front())
      titles.of_panels = std::max(titles.of_panels, title_height(*panel));
  }
  for (const FigureBlock* block : row) {
    const Part one = drawn_block(*block, part.width, y, room(*block), titles);
    part.text += one.text;
    part.width += one.width;
    part.height = std::max(part.height, one.height);
  }
  return part;
}

}  // namespace

std::string figure_svg(const std::string& title, const std::vector<FigureBlock>& blocks) {
  std::vector<std::vector<const FigureBlock*>> rows;
  double x = page_width, widest = 0;
  for (const FigureBlock& block : blocks) {
    const double wide = width_of(block);
    if (rows.empty() || x + wide > page_width) rows.emplace_back(), x = 0;
    rows.back().push_back(&block);
    x += wide;
    widest = std::max(widest, x);
  }
  std::string text;
  double y = 4;
  for (const auto& row : rows) {
    const Part one = drawn_row(row, y);
    text += one.text;
    y += one.height;
  }
  return svg_head(widest <= column_width ? column_width : page_width, y, title, figure_font) +
         text + "</svg>\n";
}

}  // namespace mahlwerk::report

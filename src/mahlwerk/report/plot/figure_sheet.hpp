// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

// Several plots as the panels of one figure for print. At its natural size of 96 px per inch a
// figure of one column is 90 mm wide, of two columns 180 mm, and its text has 8 points.
namespace mahlwerk::report {

constexpr double column_width = 340;  ///< [px] of one column
constexpr double page_width = 680;    ///< [px] of two columns
constexpr double figure_font = 11;    ///< [px] font size

/// One drawing of a figure.
struct FigurePanel {
  std::string letter;  ///< "a"; may be empty
  std::string title;   ///< may be empty
  std::string svg;     ///< begins with svg_head(); empty: no drawing, only the title
  double width = column_width, height = 250;  ///< [px] of the drawing
};

/// Panels with a common title, drawn side by side and together.
struct FigureBlock {
  std::string title;  ///< may be empty
  std::vector<FigurePanel> panels;
};

/// The blocks as one <svg> element, row by row. `title` is its description for screen readers.
std::string figure_svg(const std::string& title, const std::vector<FigureBlock>& blocks);

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace mahlwerk::report {

/// An axis of a map: the edges of its cells, one more than cells, or a name for each cell.
struct MapAxis {
  std::string label = {};  ///< with the unit of the edges: "height (mm)"
  std::vector<double> edges = {};
  std::vector<std::string> names = {};
  bool logarithmic = false;
  std::string unit = {};  ///< of edges whose marks have one of its multiples: "J"
};

/// One grid of cells.
struct MapPanel {
  std::string title = {};
  MapAxis x = {}, y = {};
  bool polar = false;                  ///< x is an angle [rad], y a radius
  std::vector<double> values = {};     ///< row by row from below; NaN: no value
  std::vector<std::string> told = {};  ///< of each cell: its values in words; empty: from the axes
  std::vector<bool> failed = {};       ///< cells without a value that are crossed out; empty: none
  /// Column, row and direction of each arrow; the longest has the length 1.
  std::vector<double> arrows = {};
  double ring = 0;        ///< radius of a circle about the origin, in units of x; 0: none
  bool diagonal = false;  ///< a dashed line from the lower left to the upper right corner
  double width = 480;     ///< [px] at most
  double shape = 0;       ///< height over width of the grid; 0: from the number of rows
};

/// Cells whose colours are values of one quantity, or words.
struct ColourMap {
  std::string title, quantity = {}, unit = {};
  double least = 0, most = 1;           ///< ends of the scale of colours
  bool logarithmic = false;             ///< the scale of colours
  std::string note = {};                ///< beside the scale: "the longest arrow is 1.2 m/s"
  std::vector<std::string> words = {};  ///< the values are indices of these; empty: numbers
  std::vector<MapPanel> panels = {};
};

}  // namespace mahlwerk::report

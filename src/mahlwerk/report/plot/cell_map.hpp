// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mahlwerk::report {

/// One cell of a map.
struct Cell {
  std::string colour = {};   ///< empty: no cell
  std::string ink = "#000";  ///< colour of its text
  std::string text = {};     ///< drawn if there is room
  std::string title = {};    ///< tooltip
  bool failed = false;       ///< crossed out
};

/// Legend of a map: a colour scale from `low` to `high`, or words.
struct MapLegend {
  std::string low = {}, high = {}, about = {};
  std::vector<std::pair<std::string, std::string>> words = {};  ///< colour, word
};

/// Heat map over the values of two keys.
struct CellMap {
  std::string title, x_label, y_label;
  std::vector<std::string> x, y;  ///< tick texts, from left and from below
  std::vector<Cell> cells;        ///< row-major from below: x.size() times y.size()
  MapLegend legend;
};

/// The map as one <svg> element. Maps with many cells have no tooltips.
std::string svg(const CellMap& map);

}  // namespace mahlwerk::report

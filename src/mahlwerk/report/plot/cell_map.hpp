// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mahlwerk::report {

/// One place of a map.
struct Cell {
  std::string colour = {};   ///< empty: nothing is there
  std::string ink = "#000";  ///< of its text
  std::string text = {};     ///< shown if there is room
  std::string title = {};    ///< shown under the pointer
  bool failed = false;       ///< crossed out
};

/// What the colours of a map mean: a scale from `low` to `high`, or words.
struct MapLegend {
  std::string low = {}, high = {}, about = {};
  std::vector<std::pair<std::string, std::string>> words = {};  ///< colour, word
};

/// Values of two keys side by side, and what was found where they meet.
struct CellMap {
  std::string title, x_label, y_label;
  std::vector<std::string> x, y;  ///< from left, from below
  std::vector<Cell> cells;        ///< row by row from below: x.size() times y.size()
  MapLegend legend;
};

/// The map as one <svg> element. Of many cells titles are left out.
std::string svg(const CellMap& map);

}  // namespace mahlwerk::report

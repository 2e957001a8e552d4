// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mahlwerk::report {

enum class Mark {
  line,    ///< points joined
  points,  ///< dots with error bars, joined by a thin line
  dots,    ///< the same, not joined; of more than 300 specks without errors
  steps    ///< a histogram: x holds the edges, one more than y
};

struct Series {
  std::string name;  ///< in the legend; empty: none
  std::vector<double> x = {}, y = {};
  std::vector<double> error = {};  ///< half-widths of y, or empty
  Mark mark = Mark::line;
  /// Which of the colours, from 0; none: that of its place among the series.
  std::optional<std::size_t> colour = std::nullopt;
  bool band = false;  ///< the errors are shaded from point to point, too
};

struct Axis {
  std::string label;  ///< with its unit: "impact energy (mJ)"
  bool logarithmic = false;
  /// What is shown; NaN: what the data need.
  double least = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  double width = 720, height = 360;  ///< of the view box; it scales to the page
};

/// The plot as one <svg> element. Colours are those of Okabe and Ito, told apart by most
/// colour-blind readers; text and grid follow the page's --ink, --soft and --grid where it sets
/// them.
std::string svg(const Plot& plot);

}  // namespace mahlwerk::report

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mahlwerk::report {

enum class Mark {
  line,    ///< joined points
  points,  ///< dots with error bars, joined by a thin line
  dots,    ///< dots with error bars, not joined; more than 300 are drawn small, without error bars
  steps    ///< a histogram: x holds the edges, one more than y
};

struct Series {
  std::string name;  ///< in the legend; empty: no entry
  std::vector<double> x = {}, y = {};
  std::vector<double> error = {};  ///< half-widths of y, or empty
  Mark mark = Mark::line;
  /// Index of the colour; nullopt: the index of the series.
  std::optional<std::size_t> colour = std::nullopt;
  bool band = false;  ///< also draw the errors as a shaded band
};

struct Axis {
  std::string label;  ///< with its unit: "impact energy (mJ)"
  bool logarithmic = false;
  /// Limits; NaN: from the data.
  double least = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  double width = 720, height = 360;  ///< of the view box; it scales to the page
};

/// The plot as one <svg> element, in the colours of Okabe and Ito, which most colour-blind readers
/// can distinguish. Text and grid use the page's --ink, --soft and --grid if it sets them.
std::string svg(const Plot& plot);

}  // namespace mahlwerk::report

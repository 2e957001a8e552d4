// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// Curves as data, which the script of a page draws. Marks in labels: "$E_{n}$" is an italic E with
// the upright subscript n, "f^{2}" a superscript; a mark without its counterpart stands as it is.
namespace mahlwerk::report {

enum class Mark {
  line,     ///< joined points
  points,   ///< dots with error bars, joined by a thin line
  dots,     ///< dots with error bars, not joined; more than 300 are drawn small, without error bars
  steps,    ///< a histogram: x holds the edges, one more than y
  squares,  ///< black squares with error bars, not joined: measured values
  area,     ///< only the area between the ends of the intervals
  note      ///< not drawn: its name stands in the legend
};

/// Ends of an interval; NaN without one.
struct Interval {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  bool known() const { return low <= high; }
};

struct Series {
  /// In the legend, with marks; empty: no entry.
  std::string name;
  std::vector<double> x = {}, y = {};
  std::vector<double> error = {};  ///< half-widths of y, or empty
  Mark mark = Mark::line;
  /// Index of the colour; nullopt: the index of the series.
  std::optional<std::size_t> colour = std::nullopt;
  bool band = false;  ///< also draw the errors as a shaded band
  /// Ends of the intervals of y, which replace y - error and y + error; or empty.
  std::vector<double> low = {}, high = {};
};

/// Write its type where it is initialised inside a Plot, `.x = Axis{...}`: if a later member
/// throws, g++ 12 destroys an axis without type twice.
struct Axis {
  /// With its unit, "impact energy (mJ)", and marks.
  std::string label;
  bool logarithmic = false;
  /// Limits; NaN: from the data.
  double least = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();
  /// Range of the quantity: intervals are cut at its ends.
  double range_least = -std::numeric_limits<double>::infinity();
  double range_most = std::numeric_limits<double>::infinity();
};

/// The interval of a series' point as it is drawn: cut at the range of the axis.
Interval interval_at(const Series& series, std::size_t point, const Axis& y);

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  double shape = 0.5;  ///< height over width
};

}  // namespace mahlwerk::report

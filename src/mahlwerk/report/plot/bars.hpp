// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace mahlwerk::report {

/// A bar from the base of its plot to `end`, with the interval of its end.
struct Bar {
  double end = NAN, ci95 = NAN;
  std::size_t colour = 0;  ///< of kinds (colours.hpp)
  std::string note = {};   ///< beside its end: "200 rpm"
  /// Of an interval that lies unevenly, in place of `ci95`.
  double low = NAN, high = NAN;

  bool uneven() const { return std::isfinite(low) && std::isfinite(high); }
  double half() const { return std::isfinite(ci95) ? ci95 : 0; }
  double least() const { return uneven() ? low : end - half(); }
  double most() const { return uneven() ? high : end + half(); }
};

/// Bars of one thing; on one line if they go to different sides, else one below the other.
struct BarGroup {
  std::string name;
  std::vector<Bar> bars;
};

/// Groups of bars, the first on top.
struct BarPlot {
  std::string title, label;
  double base = 0;
  bool side_by_side = false;  ///< the bars of a group one below the other
  std::vector<BarGroup> groups = {};
  std::vector<std::string> legend =
      {};  ///< what the colours mean, from the first on; none: nothing
};

/// The plot as one <svg> element.
std::string svg(const BarPlot& plot);

}  // namespace mahlwerk::report

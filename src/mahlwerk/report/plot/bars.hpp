// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace mahlwerk::report {

/// A bar from the base of its plot to `end`, with the error bar of its end.
struct Bar {
  double end = NAN, ci95 = NAN;
  std::size_t colour = 0;  ///< index, as of a series
  std::string note = {};   ///< text beside its end: "200 rpm"
  /// Asymmetric interval, replaces `ci95`.
  double low = NAN, high = NAN;

  bool uneven() const { return std::isfinite(low) && std::isfinite(high); }
  double half() const { return std::isfinite(ci95) ? ci95 : 0; }
  double least() const { return uneven() ? low : end - half(); }
  double most() const { return uneven() ? high : end + half(); }
};

/// The bars of one name: on one line, or one below the other if the plot is side_by_side.
struct BarGroup {
  std::string name;
  std::vector<Bar> bars;
};

/// Groups of bars, the first on top.
struct BarPlot {
  std::string title, label;
  double base = 0;
  bool side_by_side = false;  ///< draw the bars of a group one below the other
  std::vector<BarGroup> groups = {};
  std::vector<std::string> legend =
      {};  ///< meaning of the colours, from the first on; empty: no legend
};

}  // namespace mahlwerk::report

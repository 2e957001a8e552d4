// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/plot/svg_plot.hpp"

// How values lie along an axis, and which of them stand beside it.
namespace mahlwerk::report {

constexpr double plot_width = 480;    ///< [px] of every plot
constexpr double letter_width = 6.6;  ///< [px] average of one at 12 px

/// Numbers alone, and positive ones alone on a logarithmic axis.
bool is_plottable(double v, bool logarithmic);

/// Least and most of an axis, from what it is told or what the data hold, with a little air.
struct AxisScale {
  double least = INFINITY, most = -INFINITY;
  bool logarithmic;

  explicit AxisScale(bool is_logarithmic) : logarithmic(is_logarithmic) {}
  void include(double v);
  void set_limits(const Axis& axis, bool air);
  double at(double v) const;  ///< 0 at the least, 1 at the most
};

/// Attributes of a picture's title, in letters small enough for `room` [px].
std::string title_style(std::string_view title, double room);

/// Round numbers from `least` to `most`, about `wanted` of them; powers of ten and, where they are
/// few, what lies between, on a logarithmic axis.
std::vector<double> ticks(double least, double most, bool logarithmic, int wanted);

}  // namespace mahlwerk::report

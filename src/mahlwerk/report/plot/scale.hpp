// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/plot/svg_plot.hpp"

// Axis scales and ticks.
namespace mahlwerk::report {

constexpr double plot_width = 480;    ///< [px] width of every plot
constexpr double letter_width = 6.6;  ///< [px] average character width at 12 px

/// Whether `v` is finite and, on a logarithmic axis, positive.
bool is_plottable(double v, bool logarithmic);

/// Limits of an axis, from its settings or the data, with a margin.
struct AxisScale {
  double least = INFINITY, most = -INFINITY;
  bool logarithmic;

  explicit AxisScale(bool is_logarithmic) : logarithmic(is_logarithmic) {}
  void include(double v);
  void set_limits(const Axis& axis, bool air);
  double at(double v) const;  ///< position of v: 0 at `least`, 1 at `most`
};

/// SVG attributes of a title, with a font size that fits `room` [px].
std::string title_style(std::string_view title, double room);

/// Tick values: about `wanted` round numbers from `least` to `most`; on a logarithmic axis powers
/// of ten and, if these are few, values between them.
std::vector<double> ticks(double least, double most, bool logarithmic, int wanted);

}  // namespace mahlwerk::report

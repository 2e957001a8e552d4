// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/scale.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

/// Relative difference below which two values count as equal.
constexpr double alike = 1e-9;

std::vector<double> powers(double least, double most, int wanted) {
  const int first = static_cast<int>(std::ceil(std::log10(least) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(most) + 1e-9));
  const int stride = std::max(1, (last - first) / std::max(wanted, 1) + 1);
  std::vector<double> list;
  if (last - first >= 2) {
    for (int e = first; e <= last; e += stride) list.push_back(std::pow(10, e));
    return list;
  }
  for (int e = first - 1; e <= last; ++e)  // less than two decades: 1, 2, 5
    for (const double m : {1.0, 2.0, 5.0}) {
      const double v = m * std::pow(10, e);
      if (v >= least * (1 - 1e-9) && v <= most * (1 + 1e-9)) list.push_back(v);
    }
  return list;
}

}  // namespace

bool is_plottable(double v, bool logarithmic) {
  constexpr double least = 1e-300;  // the end of an axis is below its least value
  return std::isfinite(v) && (!logarithmic || v > least);
}

void AxisScale::include(double v) {
  if (!is_plottable(v, logarithmic)) return;
  least = std::min(least, v);
  most = std::max(most, v);
}

void AxisScale::set_limits(const Axis& axis, bool air) {
  if (!(least <= most)) least = logarithmic ? 0.1 : 0, most = 1;
  // Values that differ only by rounding count as equal.
  if (most - least <= alike * std::max(std::abs(least), std::abs(most))) most = least;
  if (least == most && logarithmic) least /= 2, most *= 2;
  if (least == most) least -= 0.5 * std::max(std::abs(least), 1.0), most = 2 * most - least;
  if (air && logarithmic) least /= 1.3, most *= 1.3;
  if (air && !logarithmic) {
    const double room = 0.06 * (most - least);
    // Starts at zero if zero is near: sizes can then be compared by eye.
    const bool from_zero = least >= 0 && least < 0.5 * most;
    least = from_zero ? 0 : least - room;
    most += room;
  }
  if (std::isfinite(axis.least)) least = axis.least;
  if (std::isfinite(axis.most)) most = axis.most;
}

double AxisScale::at(double v) const {
  if (logarithmic)  // differences of logarithms: quotients may overflow
    return (std::log(v) - std::log(least)) / (std::log(most) - std::log(least));
  return (v - least) / (most - least);
}

std::string title_style(std::string_view title, double room) {
  constexpr double usual = 14, least = 9, wide = 0.6;  // wide: character width over font size
  const double letters = std::max(1.0, static_cast<double>(width(title)));
  return fmt::format(" font-size=\"{:.3g}\" font-weight=\"600\"",
                     std::clamp(room / (wide * letters), least, usual));
}

std::vector<double> ticks(double least, double most, bool logarithmic, int wanted) {
  if (!(most - least > alike * std::max(std::abs(least), std::abs(most)))) return {};
  if (logarithmic) return powers(least, most, wanted);
  const double rough = (most - least) / wanted;
  const double scale = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * scale;
  for (const double m : {5.0, 2.0, 1.0}) {
    if (m * scale >= rough * 0.999) step = m * scale;
  }
  std::vector<double> list;
  for (double k = std::ceil(least / step - 1e-9); k * step <= most + 1e-9 * step; ++k)
    list.push_back(k * step + 0.0);  // not -0
  return list;
}

}  // namespace mahlwerk::report

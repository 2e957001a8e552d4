// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/approach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::observe {
namespace {

/// Five samples leave two degrees of freedom beside three parameters.
constexpr std::size_t least_samples = 5;
/// How many times the variance of the residuals, for each parameter more, a model must remove to be
/// preferred: Fisher's F of two parameters at 1e-4 and 100 samples.
constexpr double clear = 10;
struct Sample {
  double time, value;  // time since the first sample
};
using Samples = std::vector<Sample>;

/// value = level + slope x, by least squares.
struct Line {
  double level = 0, slope = 0, squares = 0;  // squares: sum of the squared residuals
};
template <class X>
Line line(const Samples& all, const X& x) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(all.size());
  for (const Sample& s : all) sx += x(s), sy += s.value;
  for (const Sample& s : all) {
    const double dx = x(s) - sx / n;
    sxx += dx * dx, sxy += dx * (s.value - sy / n);
  }
  Line found;
  found.slope = sxx > 0 ? sxy / sxx : 0;
  found.level = sy / n - found.slope * sx / n;
  for (const Sample& s : all) {
    const double off = s.value - found.level - found.slope * x(s);
    found.squares += off * off;
  }
  return found;
}

Line exponential(const Samples& all, double time) {
  return line(all, [&](const Sample& s) { return math::exp(-s.time / time); });
}

/// The time constant of the least sum of squares: the best of a grid, then golden sections. For
/// each one, level and slope follow from linear equations (variable projection).
double best_time(const Samples& all, double least, double most) {
  constexpr int points = 80;
  const double step = math::log(most / least) / (points - 1);
  const auto squares = [&](double at) {
    return exponential(all, least * math::exp(step * at)).squares;
  };
  int best = 0;
  double fewest = squares(0);
  for (int i = 1; i < points; ++i)
    if (const double here = squares(i); here < fewest) best = i, fewest = here;
  constexpr double golden = 1 / std::numbers::phi;
  double a = std::max(best - 1, 0), b = std::min(best + 1, points - 1);
  constexpr int sections = 40;  // 0.618^40 = 4e-9 of a step
  for (int i = 0; i < sections; ++i) {
    const double c = b - golden * (b - a), d = a + golden * (b - a);
    if (squares(c) <= squares(d))
      b = d;
    else
      a = c;
  }
  return least * math::exp(step * 0.5 * (a + b));
}

/// The share of the samples that count as independent, by the correlation of the residuals from one
/// sample to the next.
double independent_share(const Samples& all, const Line& fit, double time) {
  double squares = 0, products = 0, last = 0;
  for (const Sample& s : all) {
    const double off = s.value - fit.level - fit.slope * math::exp(-s.time / time);
    squares += off * off, products += off * last;
    last = off;
  }
  const double correlation = squares > 0 ? std::max(0.0, products / squares) : 0;
  return (1 - correlation) / (1 + correlation);
}

}  // namespace

Approach fit_approach(std::span<const double> times, std::span<const double> values) {
  Samples all;
  double largest = 0;
  for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i)
    if (std::isfinite(values[i])) {
      all.push_back({times[i] - times[0], values[i]});
      largest = std::max(largest, std::abs(values[i]));
    }
  if (all.size() < least_samples) return {};
  const double counted = all.back().time;
  const double interval = counted / static_cast<double>(all.size() - 1);
  if (!(interval > 0)) return {};
  // exp(-4) of the change is left at the second sample; ten times the counted time is a line.
  const double shortest = interval / 4, time = best_time(all, shortest, 10 * counted);
  const Line fit = exponential(all, time);
  const double rounding = 1e-13 * largest;
  const auto n = static_cast<double>(all.size());
  const double squares = std::max(fit.squares, n * rounding * rounding);
  // How much less the sum of squares is, in variances of the residuals.
  const auto gain = [&](const Line& other) {
    return (other.squares - squares) / squares * (n - 3);
  };
  const Line constant = line(all, [](const Sample&) { return 0.0; });
  const Line straight = line(all, [](const Sample& s) { return s.time; });
  Approach found{.start = fit.level + fit.slope, .end = fit.level};
  // Slow swings about a level are no approach; about one, they do not make it a line.
  if (!(gain(constant) * independent_share(all, fit, time) > 2 * clear)) {
    double sum = 0;
    for (const Sample& s : all) sum += s.value;
    found.kind = Approach::Kind::flat;
    found.start = found.end = sum / n;
  } else if (time < 1.01 * shortest) {
    found.kind = Approach::Kind::fast;
  } else if (time > counted || !(gain(straight) > clear)) {
    return {};
  } else {
    found.kind = Approach::Kind::found;
    found.time = time;
  }
  return found;
}

}  // namespace mahlwerk::observe

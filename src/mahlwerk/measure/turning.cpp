// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/measure/oscillation.hpp"
#include "mahlwerk/measure/times.hpp"

namespace mahlwerk::measure {
namespace {

/// exp(-2 pi i f t) at each time, t from the middle.
std::vector<Complex> turned_back(std::span<const double> time, double f) {
  const double middle = 0.5 * (time.front() + time.back());
  std::vector<Complex> made;
  for (const double t : time) {
    const SinCos at = sin_cos(-2 * std::numbers::pi * f * (t - middle));
    made.emplace_back(at.cos, at.sin);
  }
  return made;
}

/// Least squares of centre and radius of one turning vector.
struct CircleFit {
  Complex centre, radius;
  double explained = 0;  ///< sum of squares

  CircleFit(const std::vector<Complex>& points, const std::vector<Complex>& back) {
    const auto n = static_cast<double>(points.size());
    Complex sum = 0, turned = 0, overlap = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum += points[i];
      turned += points[i] * back[i];
      overlap += back[i];
    }
    const double determinant = n * n - std::norm(overlap);
    centre = (n * sum - std::conj(overlap) * turned) / determinant;
    radius = (n * turned - overlap * sum) / determinant;
    explained = (centre * std::conj(sum) + radius * std::conj(turned)).real();
  }
};

/// Improves the frequency and radius of a vector, for points without the others; returns the rest.
std::vector<Complex> fit_vector(std::span<const double> time, const std::vector<Complex>& points,
                                TurningVector& vector, Complex& centre) {
  const double reach = 0.7 / (time.back() - time.front());
  vector.frequency =
      maximum_within(vector.frequency - reach, vector.frequency + reach,
                     [&](double f) { return CircleFit(points, turned_back(time, f)).explained; });
  const std::vector<Complex> back = turned_back(time, vector.frequency);
  const CircleFit fit(points, back);
  vector.radius = fit.radius;
  centre = fit.centre;
  std::vector<Complex> rest = points;
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= fit.radius * std::conj(back[i]);
  return rest;
}

void add_vector(std::vector<Complex>& points, std::span<const double> time,
                const TurningVector& vector) {
  const std::vector<Complex> back = turned_back(time, vector.frequency);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += vector.radius * std::conj(back[i]);
}

double peak_of(std::span<const double> time, const std::vector<Complex>& points) {
  std::vector<double> x, y;
  for (const Complex& point : points) {
    x.push_back(point.real());
    y.push_back(point.imag());
  }
  return peak_frequency({even_series(time, x, y)}, true);
}

/// Deviations from the power of the rest beside the frequency of the vector.
void set_deviations(std::span<const double> time, const std::vector<Complex>& rest, double highest,
                    TurningVector& vector, int& freedom) {
  const double length = time.back() - time.front();
  std::vector<double> powers;
  for (int k = noise_first; k <= noise_last; ++k)
    for (const double f : {vector.frequency - k / length, vector.frequency + k / length}) {
      if (std::abs(f) > highest || std::abs(f) < 0.9 / length) continue;
      const std::vector<Complex> back = turned_back(time, f);
      Complex sum = 0;
      for (std::size_t i = 0; i < rest.size(); ++i) sum += rest[i] * back[i];
      powers.push_back(std::norm(sum / static_cast<double>(rest.size())));
    }
  if (powers.size() < 3)
    throw InputError(
        Fault{"", "the film is too short to estimate errors", "film longer", "bad-readings"});
  const double power = noise_power(powers).power;
  freedom = std::min(freedom, noise_power(powers).freedom);
  vector.deviation = std::sqrt(0.5 * power);
  vector.frequency_deviation =
      std::sqrt(6 * power / std::norm(vector.radius)) / (2 * std::numbers::pi * length);
}

InputError no_turning(bool second) {
  return InputError(Fault{
      "",
      second ? "no second rotation stands out of the scatter of the positions: the mark is at "
               "the middle of the jar, or the jar does not turn in the laboratory (ratio -1)"
             : "no rotation stands out of the scatter of the positions",
      second ? "track a mark near the rim of the jar"
             : "check the columns, or track a mark that moves",
      "bad-readings"});
}

}  // namespace

Turning fit_turning(std::span<const double> time, std::span<const double> x,
                    std::span<const double> y, int count) {
  check_times(time);
  std::vector<Complex> rest;
  for (std::size_t i = 0; i < x.size(); ++i) rest.emplace_back(x[i], y[i]);
  Turning made{.highest = 0.5 / even_series(time, x, y).interval, .freedom = 1000};
  const double length = time.back() - time.front();
  for (int i = 0; i < count; ++i) {
    made.vectors.push_back({.frequency = peak_of(time, rest)});
    rest = fit_vector(time, rest, made.vectors.back(), made.centre);
  }
  double moved = 1;  // [cycles per film]
  for (int round = 0; round < 8 && count > 1 && moved > 1e-5; ++round) {
    moved = 0;
    for (TurningVector& vector : made.vectors) {  // each vector changes the fit of the other
      const double before = vector.frequency;
      add_vector(rest, time, vector);
      rest = fit_vector(time, rest, vector, made.centre);
      moved = std::max(moved, length * std::abs(vector.frequency - before));
    }
  }
  std::vector<Complex> without_centre = rest;
  for (Complex& point : without_centre) point -= made.centre;
  for (TurningVector& vector : made.vectors) {
    set_deviations(time, without_centre, made.highest, vector, made.freedom);
    const double periods = std::abs(vector.frequency) * length;
    if (periods < 0.98 * least_periods)
      throw InputError(Fault{"",
                             fmt::format("the film shows {:.1f} turns; at least {:.0f} are needed",
                                         periods, least_periods),
                             "film longer: 20 turns and more give small errors", "bad-readings"});
    if (std::norm(vector.radius) < 40 * vector.deviation * vector.deviation)
      throw no_turning(made.vectors.size() > 1 && &vector != &made.vectors.front());
  }
  std::ranges::stable_sort(made.vectors, std::ranges::greater(),
                           [](const TurningVector& v) { return std::norm(v.radius); });
  return made;
}

}  // namespace mahlwerk::measure

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/oscillation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/measure/times.hpp"

namespace mahlwerk::measure {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
using Row = std::array<double, 4>;  // 1, t, cos, sin

/// Solves symmetric positive equations by Cholesky's decomposition.
Row solved(std::array<Row, 4> m, Row b) {
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
    m[j][j] = std::sqrt(std::max(m[j][j], 1e-300));
    for (std::size_t i = j + 1; i < 4; ++i) {
      for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
      m[i][j] /= m[j][j];
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= m[i][k] * b[k];
    b[i] /= m[i][i];
  }
  for (std::size_t i = 4; i-- > 0;) {
    for (std::size_t k = i + 1; k < 4; ++k) b[i] -= m[k][i] * b[k];
    b[i] /= m[i][i];
  }
  return b;
}

/// Least squares of constant, drift and a sine of one frequency.
class SineModel {
 public:
  SineModel(std::span<const double> time, double frequency) {
    const double middle = 0.5 * (time.front() + time.back()),
                 half = 0.5 * (time.back() - time.front());
    for (const double t : time) {
      const SinCos at = sin_cos(two_pi * frequency * (t - middle));
      rows_.push_back({1, (t - middle) / half, at.cos, at.sin});
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) normal_[i][j] += rows_.back()[i] * rows_.back()[j];
    }
  }

  Row fitted(const std::vector<double>& values) const { return solved(normal_, projected(values)); }
  /// Sum of squares that the model explains.
  double explained(const std::vector<double>& values) const {
    const Row b = projected(values), x = solved(normal_, b);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += b[i] * x[i];
    return sum;
  }
  std::vector<double> residuals(const std::vector<double>& values, const Row& fit) const {
    std::vector<double> rest;
    for (std::size_t i = 0; i < values.size(); ++i) {
      double model = 0;
      for (std::size_t j = 0; j < 4; ++j) model += rows_[i][j] * fit[j];
      rest.push_back(values[i] - model);
    }
    return rest;
  }

 private:
  Row projected(const std::vector<double>& values) const {
    Row b{};
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < 4; ++j) b[j] += rows_[i][j] * values[i];
    return b;
  }

  std::vector<Row> rows_;
  std::array<Row, 4> normal_{};
};

/// The frequencies beside `frequency` at which the noise is estimated.
std::vector<double> neighbours(double frequency, double length, double highest) {
  std::vector<double> made;
  for (int k = noise_first; k <= noise_last; ++k)
    for (const double f : {frequency - k / length, frequency + k / length})
      if (f > 0.9 / length && f < highest) made.push_back(f);
  return made;
}

/// Sum of squares of the amplitudes that residuals have at a frequency.
double squared_amplitude(std::span<const double> time, const std::vector<double>& rest, double f) {
  double c = 0, s = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const SinCos at = sin_cos(two_pi * f * (time[i] - time.front()));
    c += rest[i] * at.cos;
    s += rest[i] * at.sin;
  }
  const double scale = 2 / static_cast<double>(rest.size());
  return scale * scale * (c * c + s * s);
}

InputError too_short(double periods) {
  return InputError(Fault{"",
                          fmt::format("the film shows {:.1f} periods; at least {:.0f} are needed",
                                      periods, least_periods),
                          "film longer: 20 periods and more give small errors", "bad-readings"});
}

InputError no_motion() {
  return InputError(Fault{"", "no oscillation stands out of the scatter of the positions",
                          "check the columns, or track a mark that moves", "bad-readings"});
}

}  // namespace

void check_times(std::span<const double> time) {
  const auto fault = [](std::string what, std::string remedy) {
    return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
  };
  if (time.size() < 12)
    throw fault(fmt::format("there are {} positions; at least 12 are needed", time.size()),
                "track more frames");
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw fault(fmt::format("the time does not increase from {} s to {} s", time[i - 1], time[i]),
                  "sort the rows by time, and give each time once");
}

NoisePower noise_power(std::span<const double> beside) {
  constexpr double euler = 0.5772156649015329;  // minus the mean logarithm of a power of mean 1
  constexpr double variance = std::numbers::pi * std::numbers::pi / 6;  // of this logarithm
  double sum = 0;
  for (const double one : beside) sum += math::log(std::max(one, 1e-280));
  const auto n = static_cast<double>(beside.size());
  return {math::exp(sum / n + euler), std::max(1, static_cast<int>(2 * n / variance))};
}

Oscillation fit_oscillation(std::span<const double> time,
                            const std::vector<std::vector<double>>& series) {
  check_times(time);
  std::vector<EvenSeries> even;
  for (const std::vector<double>& one : series)
    even.push_back(even_series(time, one, std::vector<double>(one.size())));
  const double length = time.back() - time.front();
  Oscillation made{.highest = 0.5 / even.front().interval};
  const double rough = peak_frequency(even, false);
  made.frequency = maximum_within(std::max(0.5 / length, rough - 0.7 / length),
                                  rough + 0.7 / length, [&](double f) {
                                    const SineModel model(time, f);
                                    double sum = 0;
                                    for (const std::vector<double>& one : series)
                                      sum += model.explained(one);
                                    return sum;
                                  });
  made.periods = made.frequency * length;
  if (made.periods < 0.98 * least_periods) throw too_short(made.periods);

  const SineModel model(time, made.frequency);
  const std::vector<double> beside = neighbours(made.frequency, length, made.highest);
  if (beside.size() < 2) throw too_short(made.periods);
  double information = 0, size = 0, noise = 0;
  for (const std::vector<double>& one : series) {
    const Row fit = model.fitted(one);
    const std::vector<double> rest = model.residuals(one, fit);
    std::vector<double> powers;
    for (const double f : beside) powers.push_back(squared_amplitude(time, rest, f));
    const double power = noise_power(powers).power;  // as squared amplitude
    made.freedom = noise_power(powers).freedom;
    const double amplitude2 = fit[2] * fit[2] + fit[3] * fit[3];
    made.coordinates.push_back({fit[0], fit[2], fit[3], std::sqrt(0.5 * power)});  // (mea.2)
    information += amplitude2 * length * length / (6 * power);  // of the angular frequency (mea.3)
    size += amplitude2;
    noise += power;
  }
  if (!(size > 20 * noise)) throw no_motion();
  made.frequency_deviation = 1 / (two_pi * std::sqrt(information));
  return made;
}

}  // namespace mahlwerk::measure

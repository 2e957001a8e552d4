// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace mahlwerk::measure {

using Complex = std::complex<double>;

/// The discrete Fourier transform sum_k x_k exp(-2 pi i j k/n), in place. The number of values must
/// be a power of two.
void fourier_transform(std::vector<Complex>& values);

/// The least power of two that is not below `count`, which must be at most 2^62.
std::size_t power_of_two(std::size_t count);

/// A series of points (x + i y) on equidistant times.
struct EvenSeries {
  double interval = 0;  ///< [s]
  std::vector<Complex> values;
};

/// Interpolates points linearly on equidistant times, at the median interval of `time` [s], which
/// must increase; the straight line through the first and last quarter's means is removed. Throws
/// InputError if gaps make the series more than 20 times as long as the points.
EvenSeries even_series(std::span<const double> time, std::span<const double> x,
                       std::span<const double> y);

/// [Hz] Frequency of the largest peak of the summed power spectra of series with the same times,
/// at least one cycle over their length. With `both_senses` it is negative where x + i y turns from
/// y to x.
double peak_frequency(const std::vector<EvenSeries>& series, bool both_senses);

}  // namespace mahlwerk::measure

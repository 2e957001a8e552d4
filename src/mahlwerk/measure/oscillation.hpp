// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "mahlwerk/measure/fourier.hpp"

// Sine fits to the coordinates of marks.
namespace mahlwerk::measure {

/// One coordinate: x = centre + cosine cos(2 pi f t) + sine sin(2 pi f t), t from the middle.
struct SineFit {
  double centre = 0, cosine = 0, sine = 0;
  /// Standard deviation of `cosine` and of `sine`, from the residuals near the frequency (mea.2):
  /// errors that are correlated from frame to frame count with their power at that frequency.
  double deviation = 0;
};

struct Oscillation {
  double frequency = 0, frequency_deviation = 0;  ///< [Hz]
  double periods = 0;                             ///< in the film
  double highest = 0;                             ///< [Hz] half the rate of frames
  int freedom = 0;                                ///< degrees of freedom of the deviations
  std::vector<SineFit> coordinates = {};          ///< one for each series, in its unit
};

/// Fits sines of one common frequency to `series` at the times [s] (mea.1). Throws InputError for
/// fewer than 12 times, times that do not increase, fewer than five periods, or no oscillation that
/// stands out of the noise.
Oscillation fit_oscillation(std::span<const double> time,
                            const std::vector<std::vector<double>>& series);

/// A turning vector: radius exp(2 pi i f t) of the position x + i y.
struct TurningVector {
  double frequency = 0, frequency_deviation = 0;  ///< [Hz]; negative: from y to x
  Complex radius = 0;
  double deviation = 0;  ///< standard deviation of each part of the radius
};

struct Turning {
  Complex centre = 0;
  std::vector<TurningVector> vectors = {};  ///< the largest first
  double highest = 0;                       ///< [Hz] half the rate of frames
  int freedom = 0;
};

/// Fits `count` (1 or 2) turning vectors to a mark (mea.5). Throws InputError as above, and if a
/// vector does not stand out of the noise.
Turning fit_turning(std::span<const double> time, std::span<const double> x,
                    std::span<const double> y, int count);

}  // namespace mahlwerk::measure

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace mahlwerk::measure {

/// Throws InputError for fewer than 12 times [s], or if they do not increase.
void check_times(std::span<const double> time);

/// Least periods or turns in a film: with fewer the noise cannot be told from the motion, and
/// intervals would be too narrow.
constexpr double least_periods = 5;

/// The number in (low, high) at which a function with a single maximum there is largest.
template <class F>
double maximum_within(double low, double high, const F& f) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = f(a),
         at_b = f(b);
  for (int i = 0; i < 40; ++i) {
    if (at_a > at_b) {
      high = b, b = a, at_b = at_a;
      at_a = f(a = high - golden * (high - low));
    } else {
      low = a, a = b, at_a = at_b;
      at_b = f(b = low + golden * (high - low));
    }
  }
  return 0.5 * (low + high);
}

/// Frequencies from the second to the seventh beside another one, in steps of one cycle per film,
/// at which residuals show the noise there (mea.2).
constexpr int noise_first = 2, noise_last = 7;

/// The power of noise at a frequency and the degrees of freedom of this estimate, at least 1.
struct NoisePower {
  double power = 0;
  int freedom = 1;
};
/// From its powers at the frequencies beside it, at least one: their geometric mean, corrected for
/// chance (mea.2). A steep spectrum or a single strong line hardly changes it.
NoisePower noise_power(std::span<const double> beside);

}  // namespace mahlwerk::measure

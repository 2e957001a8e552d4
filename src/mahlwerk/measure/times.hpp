// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace mahlwerk::measure {

/// Throws InputError for fewer than 12 times [s], or if they do not increase.
void check_times(std::span<const double> time);

/// The number in (low, high) at which a function with a single maximum there is largest.
template <class F>
double maximum_within(double low, double high, const F& f) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = f(a),
         at_b = f(b);
  for (int i = 0; i < 60; ++i) {
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

/// Frequencies from the second to the ninth beside another one, in steps of one cycle per film, at
/// which residuals show the noise there (mea.2).
constexpr int noise_first = 2, noise_last = 9;

}  // namespace mahlwerk::measure

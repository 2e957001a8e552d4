// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace mahlwerk::observe {

/// A mean, or a value that a model predicts, and its 95 % confidence half-width; NaN where unknown.
struct Estimate {
  double mean = std::numeric_limits<double>::quiet_NaN();
  double ci95 = std::numeric_limits<double>::quiet_NaN();  ///< by Student's t; NaN for one value
};

/// A value and its 95 % confidence interval, which may be asymmetric; NaN where unknown.
struct IntervalEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();

  static constexpr IntervalEstimate around(double value, double half_width) {
    return {value, value - half_width, value + half_width};
  }
  /// Half the width of the interval, whether or not it is symmetric.
  [[nodiscard]] constexpr double half_width() const { return 0.5 * (high - low); }
};

/// Mean and half-width of `values`, one per replicate (sta.1); unknown without any.
Estimate estimate(const std::vector<double>& values);

/// Mean of a stationary series of equidistant values, and its half-width by batch means: the batch
/// size doubles until neighbouring batches are almost uncorrelated (sta.3), and the remaining
/// correlation widens the interval (sta.4). The half-width is NaN for fewer than ten values.
Estimate time_series_estimate(const std::vector<double>& values);

/// Length of the initial transient by MSER-5 (sta.5): the number of first values whose removal
/// minimises the standard error of the mean of the rest. At most half of the values; half of them
/// means that the series has not settled.
std::size_t transient_length(const std::vector<double>& values);

/// The line through equidistant values, by least squares.
struct Trend {
  double mean = 0;
  double change = 0;   ///< along the line, from the first to the last value
  double ci95 = 0;     ///< half-width of the 95 % confidence interval of the change
  double scatter = 0;  ///< standard deviation of the values from the line
};
/// Of three values or more, which scatter independently about the line (sta.9).
Trend trend(const std::vector<double>& values);

/// Two-sided 95 % quantile of Student's t for `freedom` >= 1 degrees of freedom (sta.2).
double student95(int freedom);

}  // namespace mahlwerk::observe

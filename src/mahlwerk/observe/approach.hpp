// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>

// A quantity that approaches its end value exponentially (mix.3), fitted to samples.
namespace mahlwerk::observe {

/// end - (end - start) exp(-t/time), by least squares.
struct Approach {
  enum class Kind {
    found,  ///< all members are known
    fast,   ///< the end is reached within the first interval: `end` and `start` are known
    flat,   ///< no change that the scatter does not explain: `end` is the mean, as `start`
    open    ///< it has not ended within the samples, or there are too few
  };
  Kind kind = Kind::open;
  double start = std::numeric_limits<double>::quiet_NaN();
  double end = std::numeric_limits<double>::quiet_NaN();
  double time = std::numeric_limits<double>::quiet_NaN();  ///< [s] time constant
};

/// `times` [s] ascend; values that are not finite are left out.
Approach fit_approach(std::span<const double> times, std::span<const double> values);

}  // namespace mahlwerk::observe

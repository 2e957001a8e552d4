// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace mahlwerk::powder {

/// Size distribution of a powder, by mass.
struct Feed {
  enum class Law {
    equal,         ///< all of one size
    sieves,        ///< sieve data, uniform in the logarithm of the size between two openings
    lognormal,     ///< by median and geometric standard deviation
    rosin_rammler  ///< passing 1 - exp(-(x/size)^spread)
  };
  Law law = Law::equal;
  double size = 0;    ///< [m] size; median of lognormal, 63.2 % passing of rosin_rammler
  double spread = 0;  ///< [1] geometric standard deviation > 1; the exponent > 0 of rosin_rammler
  /// Sieves: opening [m] and the mass share that passes it, from 0 to 1; both rise.
  std::vector<std::array<double, 2>> passing = {};

  double undersize(double x) const;     ///< [1] mass share finer than `x` [m]
  double quantile(double share) const;  ///< [m] size that this mass share, 0 to 1, is finer than
  /// [m] The 1e-6 and 1 - 1e-6 quantiles.
  double smallest() const { return quantile(1e-6); }
  double largest() const { return quantile(1 - 1e-6); }
  bool operator==(const Feed&) const = default;
};

}  // namespace mahlwerk::powder

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace mahlwerk::powder {

/// Sizes of a powder, by mass.
struct Feed {
  enum class Law {
    equal,         ///< all of one size
    sieves,        ///< between the openings of sieves, evenly in the logarithm of the size
    lognormal,     ///< by median and geometric standard deviation
    rosin_rammler  ///< passing 1 - exp(-(x/size)^spread)
  };
  Law law = Law::equal;
  double size = 0;    ///< [m] of all; the median of lognormal, 63.2 % passing of rosin_rammler
  double spread = 0;  ///< [1] geometric standard deviation > 1; the exponent > 0 of rosin_rammler
  /// Of sieves: opening [m] and the share of the mass that passes it, from 0 to 1; both rise.
  std::vector<std::array<double, 2>> passing = {};

  double undersize(double x) const;     ///< [1] of the mass than `x` [m]
  double quantile(double share) const;  ///< [m] size that this share, 0 to 1, is finer than
  /// [m] Sizes outside of which there is less than a thousandth of a thousandth.
  double smallest() const { return quantile(1e-6); }
  double largest() const { return quantile(1 - 1e-6); }
  bool operator==(const Feed&) const = default;
};

}  // namespace mahlwerk::powder

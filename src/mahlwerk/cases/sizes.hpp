// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// How the diameters of a ball set spread, and the few sizes that stand for them.
namespace mahlwerk::cases {

/// What a case says of the diameters of a set (docs/theory/charge.md).
struct Distribution {
  enum class Law {
    equal,      ///< all of one diameter
    normal,     ///< by number, cut off at three spreads
    lognormal,  ///< by number, cut off at three spreads
    uniform,    ///< by number
    sieves      ///< by mass, between the openings of sieves
  };
  Law law = Law::equal;
  double diameter = 0;       ///< [m] mean of normal, median of lognormal
  double spread = 0;         ///< [1] standard deviation over mean; geometric standard deviation
  double smallest = 0;       ///< [m] of uniform
  double largest = 0;        ///< [m] of uniform
  std::int64_t classes = 0;  ///< into which normal, lognormal and uniform are cut
  /// Of sieves: opening [m] and the share of the mass that passes it, from 0 to 1; both rise.
  std::vector<std::array<double, 2>> passing = {};
  bool operator==(const Distribution&) const = default;
};

/// Balls of one size within a set.
struct SizeClass {
  double diameter = 0;  ///< [m]
  std::int64_t count = 0;
  bool operator==(const SizeClass&) const = default;
};

constexpr std::int64_t most_classes = 32;     ///< of one set
constexpr std::int64_t default_classes = 12;  ///< unless said otherwise
constexpr double cut_off = 3;                 ///< spreads on either side

/// A class before balls are counted out: where it begins and ends, the size of ball that keeps its
/// mass, and its share of the number.
struct SizeShare {
  double low = 0, high = 0, diameter = 0;  ///< [m]
  double share = 0;                        ///< [1] of the number of balls
};

/// The classes of a distribution, smallest first; not of Law::equal (chg.1 to chg.6).
std::vector<SizeShare> size_shares(const Distribution& of);

/// [m] diameter of the ball of mean volume (chg.7).
double mean_volume_diameter(const std::vector<SizeShare>& shares);
double mean_volume_diameter(const std::vector<SizeClass>& classes);

/// `count` balls, counted out by largest remainders: the sum is exact (chg.8).
std::vector<std::int64_t> apportion(std::int64_t count, const std::vector<SizeShare>& shares);

/// The most classes, default_classes at most, of which none remains without a ball.
std::int64_t max_filled_classes(Distribution of, std::int64_t count);

/// "equal", "normal", ... in the order of Distribution::Law.
const std::vector<std::string>& distribution_words();
/// Rows of opening and share as a case writes them.
std::string passing_text(const std::vector<std::array<double, 2>>& passing);

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// The size distribution of a ball set and its discretisation into size classes.
namespace mahlwerk::cases {

/// Distribution of the diameters of a ball set (docs/theory/charge.md).
struct Distribution {
  enum class Law {
    equal,      ///< all balls of one diameter
    normal,     ///< by number, truncated at three spreads
    lognormal,  ///< by number, truncated at three spreads
    uniform,    ///< by number
    sieves      ///< by mass, between the openings of sieves
  };
  Law law = Law::equal;
  double diameter = 0;       ///< [m] mean of normal, median of lognormal
  double spread = 0;         ///< [1] standard deviation over mean; geometric standard deviation
  double smallest = 0;       ///< [m] lower end of uniform
  double largest = 0;        ///< [m] upper end of uniform
  std::int64_t classes = 0;  ///< number of size classes of normal, lognormal and uniform
  /// Of sieves: opening [m] and the share of the mass that passes it, from 0 to 1; both increase.
  std::vector<std::array<double, 2>> passing = {};
  bool operator==(const Distribution&) const = default;
};

/// Balls of one size within a set.
struct SizeClass {
  double diameter = 0;  ///< [m]
  std::int64_t count = 0;
  bool operator==(const SizeClass&) const = default;
};

constexpr std::int64_t max_classes = 32;      ///< of one set
constexpr std::int64_t default_classes = 12;  ///< largest number of classes by default
constexpr double cut_off = 3;                 ///< truncation of normal and lognormal [spreads]

/// A size class before balls are apportioned to it: its bounds, the diameter of the ball with the
/// mean mass of the class, and its share of the number.
struct SizeShare {
  double low = 0, high = 0, diameter = 0;  ///< [m]
  double share = 0;                        ///< [1] of the number of balls
};

/// The size classes of a distribution other than Law::equal, smallest first (chg.1 to chg.6).
std::vector<SizeShare> size_shares(const Distribution& of);

/// [m] Diameter of the ball of mean volume (chg.7).
double mean_volume_diameter(const std::vector<SizeShare>& shares);
double mean_volume_diameter(const std::vector<SizeClass>& classes);

/// Numbers of balls by class, by the method of largest remainders: the sum is exactly `count`
/// (chg.8).
std::vector<std::int64_t> apportion(std::int64_t count, const std::vector<SizeShare>& shares);

/// The largest number of classes, up to default_classes, for which `count` balls leave no class
/// empty.
std::int64_t max_filled_classes(Distribution of, std::int64_t count);

/// "equal", "normal", ... in the order of Distribution::Law.
const std::vector<std::string>& distribution_words();
/// Rows of opening and share, as written in a case file.
std::string passing_text(const std::vector<std::array<double, 2>>& passing);

}  // namespace mahlwerk::cases

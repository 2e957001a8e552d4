// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Tavares (UFRJ): lognormally distributed grain strengths; hits that do not break weaken a grain.
struct Tavares {
  static constexpr std::string_view name = "tavares";
  static constexpr std::string_view about =
      "lognormal strengths, damage by hits that do not break, t10 by energy";
  static constexpr bool predicts_t10 = true, tracks_strength = true;
  double e_infinity = 0;  ///< [J/kg] > 0 median strength of large grains, E_inf
  double d_0 = 0;         ///< [m] > 0 size below which grains are stronger
  double phi = 0;         ///< [1] > 0 exponent of the increase of strength
  double sigma = 0;       ///< [1] > 0 spread of the logarithm of the strength
  double cut = 0;         ///< [1] largest strength over the median; 0: none
  double gamma = 0;       ///< [1] > 0 damage constant
  double a = 0;           ///< [1] 0 to 1: largest t10
  double b = 0;           ///< [1] > 0 rate at which t10 approaches `a`
  static constexpr auto fields() {
    using M = Tavares;
    constexpr Range shares{.least = 0, .most = 1, .without_least = true, .without_most = true};
    return std::array{
        Field<M>{"e_infinity", "J/kg", &M::e_infinity, positive,
                 "median specific fracture energy of large grains, E_inf"},
        Field<M>{"d_0", "m", &M::d_0, positive, "size below which grains are stronger, d_0"},
        Field<M>{"phi", "", &M::phi, positive,
                 "exponent of the increase of strength below d_0, phi"},
        Field<M>{"sigma", "", &M::sigma, positive,
                 "standard deviation of the logarithm of the fracture energy"},
        Field<M>{"cut", "", &M::cut, not_negative,
                 "largest fracture energy over the median, E_max/E_50; 0 for none", 0.0, "no cut"},
        Field<M>{"gamma", "", &M::gamma, positive,
                 "damage constant of hits that do not break, gamma"},
        Field<M>{"a", "", &M::a, shares, "largest t10, A"},
        Field<M>{"b", "", &M::b, positive, "rate at which t10 approaches A, b'"}};
  }

  /// [J/kg] Median specific fracture energy of grains of `size` [m] (brk.4).
  double median(double size) const { return e_infinity * (1 + math::pow(d_0 / size, phi)); }
  /// [1] Strength over median strength at `z` standard deviations (brk.5).
  double relative_strength(double z) const {
    const double s = math::exp(sigma * z);
    return cut > 0 ? cut * s / (cut + s) : s;
  }
  /// [1] Inverse of relative_strength: standard deviations; infinite at and above the cut.
  double deviations(double relative_strength) const {
    const double s = relative_strength;
    if (cut > 0 && s >= cut) return HUGE_VAL;
    return math::log(cut > 0 ? cut * s / (cut - s) : s) / sigma;
  }
  /// [1] Probability that a hit of `energy` [J/kg] breaks a fresh grain (brk.5).
  double breakage_probability(double size, double energy) const {
    return 0.5 * math::erfc(-deviations(energy / median(size)) / std::numbers::sqrt2);
  }
  /// [1] Damage D, the relative loss of strength by a hit that does not break. `load`, 0 to 1, is
  /// the hit's energy over that strength (brk.6).
  double damage(double load) const;
  double t10(double size, double energy) const {  // (brk.7)
    return -a * math::expm1(-b * energy / median(size));
  }
  bool operator==(const Tavares&) const = default;
};

}  // namespace mahlwerk::powder

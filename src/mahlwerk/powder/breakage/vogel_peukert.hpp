// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Vogel and Peukert 2003: the probability of breakage grows with the energy above a least energy
/// (brk.1).
struct VogelPeukert {
  static constexpr std::string_view name = "vogel-peukert";
  static constexpr std::string_view about = "probability 1 - exp(-f_mat (x W - x W_min))";
  static constexpr bool predicts_t10 = false, tracks_strength = false;
  double f_mat = 0;    ///< [kg/(J m)] > 0
  double x_w_min = 0;  ///< [J m/kg] >= 0 size times least specific energy, of the material
  static constexpr auto fields() {
    using M = VogelPeukert;
    return std::array{Field<M>{"f_mat", "kg/J/m", &M::f_mat, positive,
                               "strength of the material: how soon its grains break, f_Mat"}
                          .with({.symbol = "$f_{Mat}$"}),
                      Field<M>{"x_w_min", "J m/kg", &M::x_w_min, not_negative,
                               "size times the least specific energy that breaks, x W_min"}
                          .with({.symbol = "$xW_{m,min}$"})};
  }
  double breakage_probability(double size, double energy) const {  // (brk.1)
    const double above = size * energy - x_w_min;
    return above > 0 ? -math::expm1(-f_mat * above) : 0;
  }
  /// Whether a hit breaks: `drawn`, uniform in (0, 1), is below `breakage_probability`. Bounds of
  /// the exponential decide most cases without computing it.
  bool breaks(double size, double energy, double drawn) const {
    const double z = f_mat * (size * energy - x_w_min);
    if (drawn >= z) return false;
    return drawn * (1 + z) < z || drawn < -math::expm1(-z);
  }
  bool operator==(const VogelPeukert&) const = default;
};

}  // namespace mahlwerk::powder

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Shi and Kojovic 2007: every hit above a least energy breaks; its energy determines t10 (brk.2).
struct ShiKojovic {
  static constexpr std::string_view name = "shi-kojovic";
  static constexpr std::string_view about = "t10 = M (1 - exp(-f_mat (x E - x E_min)))";
  static constexpr bool predicts_t10 = true, tracks_strength = false;
  double t10_most = 0;  ///< [1] 0 to 1: t10 of the hardest hits, M
  double f_mat = 0;     ///< [kg/(J m)] > 0
  double x_e_min = 0;   ///< [J m/kg] >= 0
  static constexpr auto fields() {
    using M = ShiKojovic;
    constexpr Range shares{.least = 0, .most = 1, .without_least = true, .without_most = true};
    return std::array{
        Field<M>{"t10_most", "", &M::t10_most, shares,
                 "share finer than a tenth of the size after the hardest hits, M"},
        Field<M>{"f_mat", "kg/J/m", &M::f_mat, positive, "strength of the material, f_mat"}.with(
            {.symbol = "$f_{Mat}$"}),
        Field<M>{"x_e_min", "J m/kg", &M::x_e_min, not_negative,
                 "size times the least specific energy that breaks, x E_min"}};
  }
  double breakage_probability(double size, double energy) const {
    return size * energy > x_e_min ? 1 : 0;
  }
  double t10(double size, double energy) const {  // (brk.2)
    const double above = size * energy - x_e_min;
    return above > 0 ? -t10_most * math::expm1(-f_mat * above) : 0;
  }
  bool operator==(const ShiKojovic&) const = default;
};

}  // namespace mahlwerk::powder

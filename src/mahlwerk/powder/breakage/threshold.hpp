// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Threshold energy: a hit of at least this specific energy breaks, a weaker hit has no effect
/// (brk.3).
struct Threshold {
  static constexpr std::string_view name = "threshold";
  static constexpr std::string_view about = "breaks at specific energies from W (x_0/x)^m";
  static constexpr bool predicts_t10 = false, tracks_strength = false;
  double energy = 0;          ///< [J/kg] > 0 that breaks a grain of the reference size
  double reference_size = 0;  ///< [m] > 0
  double exponent = 0;        ///< [1] 0 to 3
  static constexpr auto fields() {
    using M = Threshold;
    constexpr Range exponents{.least = 0, .most = 3};
    return std::array{Field<M>{"energy", "J/kg", &M::energy, positive,
                               "specific energy that breaks a grain of the reference size"},
                      Field<M>{"reference_size", "m", &M::reference_size, positive,
                               "reference size, for which the energy is given"},
                      Field<M>{"exponent", "", &M::exponent, exponents,
                               "exponent of its growth for finer grains: 0 none, 0.5 as for "
                               "Griffith's cracks, 1 as by Vogel and Peukert",
                               0.0, "the same for all sizes"}};
  }
  double breakage_probability(double size, double given) const {  // (brk.3)
    return given >= energy * math::pow(reference_size / size, exponent) ? 1 : 0;
  }
  bool operator==(const Threshold&) const = default;
};

}  // namespace mahlwerk::powder

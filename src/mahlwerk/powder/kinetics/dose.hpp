// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"

namespace mahlwerk::powder {

/// Conversion by a dose of energy: a reaction or a property (dos.1). First-order with the exponent
/// 1, Avrami-like with others.
struct DoseKinetics {
  static constexpr std::string_view name = "dose";
  static constexpr std::string_view about = "conversion by the energy per mass of powder";
  double dose_constant = 0;  ///< [J/kg] > 0 dose beyond the onset that converts 63.2 %
  double exponent = 1;       ///< [1] > 0
  double onset = 0;          ///< [J/kg] >= 0 dose below which the conversion is 0
  static constexpr auto fields() {
    using M = DoseKinetics;
    return std::array{
        Field<M>{"dose_constant", "J/kg", &M::dose_constant, positive,
                 "dose of energy, by mass of powder, that converts 63.2 %"},
        Field<M>{"exponent", "", &M::exponent, positive, "Avrami's exponent"},
        Field<M>{"onset", "J/kg", &M::onset, not_negative, "dose below which nothing happens", 0.0,
                 "conversion begins at once"}};
  }

  /// [1] Conversion by a `dose` [J/kg] >= 0 (dos.1).
  double at(double dose) const {
    const double beyond = std::max(dose - onset, 0.0);
    return -math::expm1(-math::pow(beyond / dose_constant, exponent));
  }
  ReactionShares shares(const MillingConditions& mill, double time) const {
    return ReactionShares::of_one_product(at(mill.dose_rate * time));
  }
  bool operator==(const DoseKinetics&) const = default;
};

}  // namespace mahlwerk::powder

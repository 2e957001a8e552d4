// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"

namespace mahlwerk::powder {

/// A self-propagating reaction (Takacs 2002): induction without conversion, then ignition, which
/// converts the powder at once.
struct IgnitionKinetics {
  static constexpr std::string_view name = "ignition";
  static constexpr std::string_view about =
      "self-propagating: nothing until a critical dose or temperature, then all at once";
  enum class Trigger {
    dose,        ///< (rea.8)
    temperature  ///< (rea.9)
  };
  double ignition_dose = 0;         ///< [J/kg] > 0 critical dose
  double ignition_temperature = 0;  ///< [K] > 0 of the powder before milling
  double milled_temperature = 0;    ///< [K] > 0 its limit after long milling, not above the former
  double activation_dose = 0;       ///< [J/kg] > 0 dose of 63.2 % of its decrease
  double flash_rise = 0;            ///< [K] >= 0 rise at a contact above the powder's temperature
  double converted_share = 1;       ///< [1] conversion by ignition, > 0, at most 1
  Trigger trigger = Trigger::dose;
  static constexpr auto fields() {
    using M = IgnitionKinetics;
    constexpr Range shares{.least = 0, .most = 1, .without_least = true};
    return std::array{
        Field<M>{"ignition_dose", "J/kg", &M::ignition_dose, positive,
                 "dose of energy at which the powder ignites"},
        Field<M>{"ignition_temperature", "K", &M::ignition_temperature, positive,
                 "ignition temperature of the powder before milling"},
        Field<M>{"milled_temperature", "K", &M::milled_temperature, positive,
                 "ignition temperature after long milling"},
        Field<M>{"activation_dose", "J/kg", &M::activation_dose, positive,
                 "dose by which milling lowers the ignition temperature by 63.2 % of the whole"},
        Field<M>{"flash_rise", "K", &M::flash_rise, not_negative,
                 "rise of the temperature at a contact above that of the powder", 0.0,
                 "the powder's temperature alone"},
        Field<M>{"converted_share", "", &M::converted_share, shares,
                 "share of the powder that ignition converts", 1.0, "all of it"}};
  }

  /// [K] Ignition temperature after a `dose` [J/kg] >= 0 (rea.9).
  double temperature_after(double dose) const;
  /// [s] Milling time until ignition; infinite if it is beyond `horizon` [s] by temperature.
  double ignition_time(const MillingConditions& mill, double horizon) const;
  ReactionShares shares(const MillingConditions& mill, double time) const;
  bool operator==(const IgnitionKinetics&) const = default;
};

}  // namespace mahlwerk::powder

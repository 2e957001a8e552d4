// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"

namespace mahlwerk::powder {

constexpr double gas_constant = 8.31446261815324;  ///< [J/(mol K)] exact since 2019

/// First order with a rate by Arrhenius, in the temperature of the powder, and a barrier that
/// stress lowers (rea.6). Attempts are by time, or by the mill's impacts: the mill then sets the
/// frequency factor and the temperature the exponential (Andersen and Mack 2017).
struct ThermalKinetics {
  static constexpr std::string_view name = "thermal";
  static constexpr std::string_view about =
      "first order, by Arrhenius in the temperature, with a barrier that stress lowers";
  enum class Attempts {
    by_time,   ///< also in pauses of the mill
    by_impact  ///< in proportion to collisions above the speed threshold
  };
  double frequency_factor = 0;   ///< [1/s] > 0 by time
  double factor_per_impact = 0;  ///< [1] > 0 by impact
  double activation_energy = 0;  ///< [J/mol] >= 0
  double activation_volume = 0;  ///< [m3/mol] >= 0
  double stress = 0;             ///< [Pa] >= 0 on the powder while the mill runs
  Attempts attempts = Attempts::by_time;
  static constexpr auto fields() {
    using M = ThermalKinetics;
    return std::array{Field<M>{"frequency_factor", "1/s", &M::frequency_factor, positive,
                               "frequency factor of Arrhenius' law"},
                      Field<M>{"factor_per_impact", "", &M::factor_per_impact, positive,
                               "frequency factor over the rate of collisions above the threshold"},
                      Field<M>{"activation_energy", "J/mol", &M::activation_energy, not_negative,
                               "activation energy without stress"},
                      Field<M>{"activation_volume", "m3/mol", &M::activation_volume, not_negative,
                               "decrease of the barrier per stress", 0.0, "stress has no effect"},
                      Field<M>{"stress", "Pa", &M::stress, not_negative,
                               "stress that acts on the powder while the mill runs", 0.0, "none"}};
  }

  /// [1/s] Rate constant at `temperature` [K] > 0 (rea.6).
  double rate_constant(const MillingConditions& mill, double temperature, bool milling) const;
  ReactionShares shares(const MillingConditions& mill, double time) const;
  bool operator==(const ThermalKinetics&) const = default;
};

}  // namespace mahlwerk::powder

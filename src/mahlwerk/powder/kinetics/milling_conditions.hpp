// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/kinetics/powder_temperature.hpp"

// What the models of kinetics know of the mill, and what they predict.
namespace mahlwerk::powder {

/// Hits of one energy on the powder.
struct PowderHits {
  double energy = 0;  ///< [J] > 0 of each hit
  double rate = 0;    ///< [1/s] of these hits
  double mass = 0;    ///< [kg] >= 0 powder that each hit captures, mean
};

/// Treatment of the powder by a mill in steady operation.
struct MillingConditions {
  double powder_mass = 0;        ///< [kg] > 0
  double dose_rate = 0;          ///< [W/kg] energy per mass of powder and time
  double impact_rate = 0;        ///< [1/s] collisions at or above the speed threshold
  std::vector<PowderHits> hits;  ///< for models by impact
  PowderTemperature temperature;
};

/// Shares of the powder by mass after a milling time.
struct ReactionShares {
  double conversion = 0;      ///< [1] converted share of the reactant, 0 to 1
  double product = 0;         ///< [1] share of the first product; the yield
  double second_product = 0;  ///< [1] share of the second product

  static ReactionShares of_one_product(double conversion) { return {conversion, conversion, 0}; }
};

}  // namespace mahlwerk::powder

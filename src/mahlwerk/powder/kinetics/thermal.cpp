// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/kinetics/thermal.hpp"

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

double ThermalKinetics::rate_constant(const MillingConditions& mill, double temperature,
                                      bool milling) const {
  double attempt_rate = frequency_factor;
  if (attempts == Attempts::by_impact)
    attempt_rate = milling ? factor_per_impact * mill.impact_rate : 0;
  const double lowered = activation_energy - (milling ? stress * activation_volume : 0);
  return attempt_rate * math::exp(-std::max(lowered, 0.0) / (gas_constant * temperature));
}

ReactionShares ThermalKinetics::shares(const MillingConditions& mill, double time) const {
  const double attempted = mill.temperature.integral(  // (rea.7)
      [&](double temperature, bool milling) { return rate_constant(mill, temperature, milling); },
      time);
  return ReactionShares::of_one_product(-math::expm1(-attempted));
}

}  // namespace mahlwerk::powder

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/kinetics/ignition.hpp"

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

double IgnitionKinetics::temperature_after(double dose) const {
  return ignition_temperature +
         (ignition_temperature - milled_temperature) * math::expm1(-dose / activation_dose);
}

double IgnitionKinetics::ignition_time(const MillingConditions& mill, double horizon) const {
  if (trigger == Trigger::dose) return ignition_dose / mill.dose_rate;  // (rea.8)
  return mill.temperature.first_time(
      [&](double temperature, double time) {
        return temperature + flash_rise >= temperature_after(mill.dose_rate * time);
      },
      horizon);
}

ReactionShares IgnitionKinetics::shares(const MillingConditions& mill, double time) const {
  return ReactionShares::of_one_product(ignition_time(mill, time) <= time ? converted_share : 0);
}

}  // namespace mahlwerk::powder

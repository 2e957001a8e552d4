// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::parts::power_meter {

/// Meter of the motor's power; the section [power_meter] (docs/theory/sensors.md).
struct PowerMeter {
  double interval = 0;    ///< [s] between two readings
  double idle_power = 0;  ///< [W] of the motor without a charge
  double efficiency = 1;  ///< [1] of the drive: power of the charge over that of the motor
  bool operator==(const PowerMeter&) const = default;
};

}  // namespace mahlwerk::parts::power_meter

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::parts::thermocouple {

/// Thermocouple: the section [thermocouple] (docs/theory/sensors.md). Needs [heat].
struct Thermocouple {
  enum class Place { wall, gas, balls };
  Place place = Place::wall;
  double lag = 5;  ///< [s] time constant
  bool operator==(const Thermocouple&) const = default;
};

}  // namespace mahlwerk::parts::thermocouple

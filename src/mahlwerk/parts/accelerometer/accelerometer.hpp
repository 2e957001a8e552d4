// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace mahlwerk::parts::accelerometer {

/// Accelerometer at the jar; the section [accelerometer] (docs/theory/sensors.md).
struct Accelerometer {
  enum class Axis { x, y, z };
  Axis axis = Axis::z;                        ///< measured direction, in the jar's own axes
  std::optional<double> mass = std::nullopt;  ///< [kg] that impacts accelerate; none: the jar's
  double bandwidth = 10e3;                    ///< [Hz] of the sensor, at -3 dB
  double sample_rate = 100e3;                 ///< [Hz] of the recorder
  double duration = 0.1;                      ///< [s] of the record, from the first counted time
  bool operator==(const Accelerometer&) const = default;
};

}  // namespace mahlwerk::parts::accelerometer

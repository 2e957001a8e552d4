// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

// Sensors of a laboratory's mill, which a run imitates (docs/theory/sensors.md).
namespace mahlwerk::cases {

/// Meter of the motor's power; absent from a case without [power_meter].
struct PowerMeter {
  double interval = 0;    ///< [s] between two readings
  double idle_power = 0;  ///< [W] of the motor without a charge
  double efficiency = 1;  ///< [1] of the drive: power of the charge over that of the motor
  bool operator==(const PowerMeter&) const = default;
};

/// Microphone or acoustic sensor that counts hits; absent from a case without [microphone].
struct Microphone {
  enum class Hears { jar, all };  ///< hits on the jar only, or also those between balls
  double threshold = 0;           ///< [J] least normal energy of a hit that is heard
  double definition_time = 1e-3;  ///< [s] hits with shorter intervals are heard as one
  Hears hears = Hears::jar;
  bool operator==(const Microphone&) const = default;
};

/// Accelerometer at the jar; absent from a case without [accelerometer].
struct Accelerometer {
  enum class Axis { x, y, z };
  Axis axis = Axis::z;                        ///< measured direction, in the jar's own axes
  std::optional<double> mass = std::nullopt;  ///< [kg] that impacts accelerate; none: the jar's
  double bandwidth = 10e3;                    ///< [Hz] of the sensor, at -3 dB
  double sample_rate = 100e3;                 ///< [Hz] of the recorder
  double duration = 0.1;                      ///< [s] of the record, from the first counted time
  bool operator==(const Accelerometer&) const = default;
};

/// Thermocouple; absent from a case without [thermocouple]. Needs Heat.
struct Thermocouple {
  enum class Place { wall, gas, balls };
  Place place = Place::wall;
  double lag = 5;  ///< [s] time constant
  bool operator==(const Thermocouple&) const = default;
};

struct Sensors {
  std::optional<PowerMeter> power_meter;
  std::optional<Microphone> microphone;
  std::optional<Accelerometer> accelerometer;
  std::optional<Thermocouple> thermocouple;
  bool operator==(const Sensors&) const = default;
};

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

// Temperatures of balls and jar: a lumped thermal model of two nodes in air of constant
// temperature.
namespace mahlwerk::powder {

/// Heat capacities of balls and jar, and heat transfer coefficients.
struct HeatNodes {
  double balls_capacity = 0;  ///< [J/K] > 0
  double jar_capacity = 0;    ///< [J/K] > 0
  double exchange = 0;        ///< [W/K] >= 0 heat transfer between balls and jar
  double cooling = 0;         ///< [W/K] >= 0 heat transfer from the jar to the air
};

/// Heating powers.
struct Heating {
  double balls = 0, jar = 0;  ///< [W]
};

struct Temperatures {
  double balls = 0, jar = 0;  ///< [K]
};

/// Operation of a mill: cycles of milling and pause.
struct MillCycles {
  double power = 0;         ///< [W] dissipated power during milling
  double share = 0;         ///< [1] share of it that heats the balls, 0 to 1
  double ambient = 0;       ///< [K] temperature of the air, and initial temperature
  double milling = 0;       ///< [s] > 0 milling time of one cycle
  double pause = 0;         ///< [s] >= 0 pause after it
  std::int64_t cycles = 1;  ///< >= 1

  Heating heating() const { return {share * power, (1 - share) * power}; }
};

/// Temperatures at a time.
struct HeatPoint {
  double time = 0;            ///< [s] since the mill was first switched on
  double balls = 0, jar = 0;  ///< [K]
  bool milling = false;       ///< whether the mill ran just before
};

/// Temperatures `duration` [s] >= 0 after `start` at constant heating, with air at `ambient` [K].
/// Exact solution (hea.4).
Temperatures temperatures_after(const HeatNodes& nodes, const Heating& heating, double ambient,
                                const Temperatures& start, double duration);

/// A thermocouple in surroundings of a temperature between those of balls and jar.
struct Thermocouple {
  double share_of_balls = 0;  ///< [1] of the balls' temperature, the rest of the jar's; 0 to 1
  double lag = 0;             ///< [s] >= 0 time constant of its reading

  double around(const Temperatures& now) const {  ///< [K]
    return share_of_balls * now.balls + (1 - share_of_balls) * now.jar;
  }
};

/// [K] Its reading `duration` [s] >= 0 after it showed `reading` [K], with all else as in
/// temperatures_after(). Exact solution (sns.8).
double reading_after(const Thermocouple& sensor, const HeatNodes& nodes, const Heating& heating,
                     double ambient, const Temperatures& start, double reading, double duration);

/// [K] Temperature of a gas without heat capacity between balls and wall: the mean of theirs, by
/// area [m2] (sns.7). As a share of the balls' temperature.
double share_of_balls_in_gas(double balls_area, double wall_area);

/// Steady temperatures of milling without pauses (hea.5); infinite without cooling.
Temperatures steady_temperatures(const HeatNodes& nodes, const Heating& heating, double ambient);

/// Temperatures over all cycles, from the start to the end of the last pause: about `points` times,
/// including each start and end of milling.
std::vector<HeatPoint> temperature_history(const HeatNodes& nodes, const MillCycles& mill,
                                           int points = 400);

}  // namespace mahlwerk::powder

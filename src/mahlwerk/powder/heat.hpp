// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

// How warm balls and jar get: two lumps of one temperature each, in air that stays as it is.
namespace mahlwerk::powder {

/// Balls and jar as lumps of heat.
struct HeatNodes {
  double balls_capacity = 0;  ///< [J/K] > 0
  double jar_capacity = 0;    ///< [J/K] > 0
  double exchange = 0;        ///< [W/K] >= 0 between balls and jar
  double cooling = 0;         ///< [W/K] >= 0 from the jar to the air
};

/// Heat put in.
struct Heating {
  double balls = 0, jar = 0;  ///< [W]
};

struct Temperatures {
  double balls = 0, jar = 0;  ///< [K]
};

/// What a mill does: it mills, it rests, and does both again.
struct MillCycles {
  double power = 0;         ///< [W] lost while it mills
  double share = 0;         ///< [1] of it that heats the balls, 0 to 1
  double ambient = 0;       ///< [K] of the air, and of all at the start
  double milling = 0;       ///< [s] > 0 of one cycle
  double pause = 0;         ///< [s] >= 0 after it
  std::int64_t cycles = 1;  ///< >= 1

  Heating heating() const { return {share * power, (1 - share) * power}; }
};

/// Temperatures at a time.
struct HeatPoint {
  double time = 0;            ///< [s] since the mill was first switched on
  double balls = 0, jar = 0;  ///< [K]
};

/// Temperatures `duration` [s] >= 0 after `start`, heated evenly, the air at `ambient` [K]. Exact
/// (hea.4).
Temperatures temperatures_after(const HeatNodes& nodes, const Heating& heating, double ambient,
                                const Temperatures& start, double duration);

/// Temperatures that milling without a pause tends to (hea.5); infinite where heat has no way out.
Temperatures steady_temperatures(const HeatNodes& nodes, const Heating& heating, double ambient);

/// Temperatures over all cycles, from the start to the end of the last pause: about `points` of
/// them, each beginning and end of milling among them.
std::vector<HeatPoint> temperature_history(const HeatNodes& nodes, const MillCycles& mill,
                                           int points = 400);

}  // namespace mahlwerk::powder

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

// The rule that names the regime of a drum or a planetary mill (docs/theory/regimes.md).
namespace mahlwerk::results {

/// The measured numbers that name a regime. A comparison with an undefined number is false.
struct RegimeSigns {
  /// Acceleration of a ball that goes round with the wall, seen from the carrier, over the field:
  /// the Froude number of a drum.
  double froude = 0;
  double flight_share = 0;    ///< share of the balls' time without any contact
  double airborne_share = 0;  ///< share of the mass in flight outside the bed
  double emptiest_sector = 0;
  double jar_lag = 0;         ///< speed seen from the jar over the wall's speed
  double carrier_motion = 0;  ///< speed seen from the carrier over the wall's speed
  double wall_slip = 0;       ///< slip of the balls at the wall over the wall's speed
  double wall_share = 0;      ///< share of the mass in balls at the wall
  double intermittency = 1;   ///< 1: the charge moves steadily
};

std::string_view regime_word(const RegimeSigns& signs, bool drum);

}  // namespace mahlwerk::results

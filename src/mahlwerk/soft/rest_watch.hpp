// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/soft/species_pairs.hpp"

namespace mahlwerk::soft {

/// Speeds of a charge that may have come to rest.
struct ChargeMotion {
  double lift = 0;      ///< [1] largest height to which a ball could rise, over its diameter
  double spinning = 0;  ///< [J] energy of the spins
  double least = std::numeric_limits<double>::infinity();  ///< [J] smallest m g d
  double largest = 0;                                      ///< [m] diameter

  void add(const Species& ball, const Vec3& velocity, const Vec3& spin, double gravity) {
    const double diameter = 2 * ball.radius;
    lift = std::max(lift, squared(velocity) / (2 * gravity * diameter));
    spinning += 0.5 * ball.inertia * squared(spin);
    least = std::min(least, ball.mass * gravity * diameter);
    largest = std::max(largest, diameter);
  }
};

/// Finds when the charge of a jar that stands still has come to rest. It stays at rest from then on
/// (dem.47).
struct RestWatch {
  static constexpr double largest_lift = 1e-10;
  static constexpr double falls = 8;  ///< of a ball by its diameter that it watches: a topple grows
  static constexpr double largest_change = 1e-7;  ///< of the energy of the spins, over m g d

  double quiet_since = -1;  ///< [s] from then on no ball was faster; < 0: some are
  double spinning = 0;      ///< [J] energy of the spins then
  bool at_rest = false;

  void serialize(Archive& archive) { archive(quiet_since)(spinning)(at_rest); }

  void update(double time, const ChargeMotion& now, double gravity) {
    const bool quiet = now.lift < largest_lift;
    const bool steady = std::abs(now.spinning - spinning) < largest_change * now.least;
    if (!quiet || !steady || quiet_since < 0) {
      quiet_since = quiet ? time : -1;
      spinning = now.spinning;
    } else {
      at_rest = time - quiet_since > falls * std::sqrt(2 * now.largest / gravity);
    }
  }
};

}  // namespace mahlwerk::soft

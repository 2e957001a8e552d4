// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/soft/settings.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

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

  /// To be called in regular steps. `ball(k)` is the Species, velocity and spin of ball k.
  template <class F>
  void update(double time, const Settings& settings, const MovingWall& jar, std::size_t balls,
              const F& ball) {
    if (!settings.free_flight_skip || !jar.stands_still() || settings.liquid) return;
    const double gravity = norm(jar.gravity());
    double lift = 0, now_spinning = 0, least = geometry::never, largest = 0;
    for (std::size_t k = 0; k < balls; ++k) {
      const auto& [species, velocity, spin] = ball(k);
      const double diameter = 2 * species.radius;
      lift = std::max(lift, squared(velocity) / (2 * gravity * diameter));
      now_spinning += 0.5 * species.inertia * squared(spin);
      least = std::min(least, species.mass * gravity * diameter);
      largest = std::max(largest, diameter);
    }
    const bool quiet = lift < largest_lift,
               steady = std::abs(now_spinning - spinning) < largest_change * least;
    if (!quiet || !steady || quiet_since < 0) {
      quiet_since = quiet ? time : -1;
      spinning = now_spinning;
    } else {
      at_rest = time - quiet_since > falls * std::sqrt(2 * largest / gravity);
    }
  }
};

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::soft {

/// Tells a run that goes wrong: it makes energy from nothing, at once and much of it.
struct EnergyWatch {
  double last_residual = 0, most_energy = 0;  ///< [J] at the last check; ever

  void begin(const scene::EnergyBalance& a) { most_energy = a.kinetic + a.elastic; }
  /// `wall_energy` is what the wall would give the balls if they moved with it, `least` an energy
  /// that is nothing, both in J.
  bool jumped(const scene::EnergyBalance& a, double wall_energy, double least) {
    const double jump = std::abs(a.residual() - last_residual);
    last_residual = a.residual();
    // A charge may come to rest, or be at rest where the wall moves; what it once had, and what the
    // wall would give it, is the measure.
    most_energy = std::max(most_energy, a.kinetic + a.elastic + wall_energy);
    return !(jump <= 0.1 * (most_energy + least));
  }
};

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::soft {

/// Detects an unstable run: the residual of the energy balance jumps between two checks.
struct EnergyWatch {
  double last_residual = 0, max_energy = 0;  ///< [J] at the last check; largest so far

  void begin(const scene::EnergyBalance& a) { max_energy = a.kinetic + a.elastic; }
  /// Updates the residual and the largest energy. Returns whether the residual jumped since the
  /// last check. `wall_energy` [J] is the kinetic energy of the balls at the speed of the wall,
  /// `least` [J] a negligible energy.
  bool update_and_test(const scene::EnergyBalance& a, double wall_energy, double least) {
    const double jump = std::abs(a.residual() - last_residual);
    last_residual = a.residual();
    // The reference is the largest energy so far, not the present one: a charge may come to rest,
    // or be at rest when the wall starts to move.
    max_energy = std::max(max_energy, a.kinetic + a.elastic + wall_energy);
    return !(jump <= 0.1 * (max_energy + least));
  }
};

}  // namespace mahlwerk::soft

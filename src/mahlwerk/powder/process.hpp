// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/nip.hpp"

// What each hit does to grains.
namespace mahlwerk::powder {

/// How hits become broken grains. Energies of collisions are those the case chose.
struct Process {
  Indirect<AnyCapture> capture;
  double energy_share = 1;  ///< [1] of a collision's energy that the caught grains get
  Indirect<AnyBreakage> breakage;
  Indirect<AnyFragments> fragments;
  Bed bed = Bed::by_size;
  double sticking = 0;  ///< [1] share of the grains up to `sticking_size` that lie out of reach
  double sticking_size = std::numeric_limits<double>::infinity();  ///< [m]
  double welding = 0;         ///< [1] chance that a hit that does not break welds two like grains
  double welding_energy = 0;  ///< [J/kg] specific energy below which nothing welds
  double density = 0;         ///< [kg/m3] > 0 of the solid
  double mass = 0;            ///< [kg] > 0 of the powder

  /// A grain of `size` [m] as the capture model asks for it.
  Grain grain(double size) const;
  /// What a collision catches of grains of `size` [m]; no more than there is powder.
  Capture capture_per_hit(const Nip& nip, double energy, double size) const;
};

}  // namespace mahlwerk::powder

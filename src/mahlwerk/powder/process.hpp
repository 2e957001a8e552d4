// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/nip.hpp"

// Effect of hits on grains: capture, breakage, fragments, sticking and welding.
namespace mahlwerk::powder {

/// Models and parameters of grinding. Energies of collisions are those that [capture] chooses.
struct Process {
  Indirect<AnyCapture> capture;
  double energy_share = 1;  ///< [1] share of a collision's energy that captured grains get
  Indirect<AnyBreakage> breakage;
  Indirect<AnyFragments> fragments;
  Bed bed = Bed::by_size;
  double sticking = 0;  ///< [1] share of grains up to `sticking_size` that stick and are not hit
  double sticking_size = std::numeric_limits<double>::infinity();  ///< [m]
  double welding = 0;         ///< [1] probability that a hit without breakage welds two like grains
  double welding_energy = 0;  ///< [J/kg] specific energy below which nothing welds
  double density = 0;         ///< [kg/m3] > 0 density of the solid
  double mass = 0;            ///< [kg] > 0 mass of the powder

  /// A grain of `size` [m] with its density and fracture energy, for the capture model.
  Grain grain(double size) const;
  /// Capture of grains of `size` [m] by a collision, limited to the mass of the powder.
  Capture capture_per_hit(const Nip& nip, double energy, double size) const;
};

}  // namespace mahlwerk::powder

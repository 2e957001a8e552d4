// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "mahlwerk/powder/models.hpp"

// Milling as the powder sees it: hits of given energies, and what each does to grains.
namespace mahlwerk::powder {

/// Collisions of one energy in one kind of nip.
struct Stress {
  int nip = 0;
  double energy = 0;  ///< [J]
  double rate = 0;    ///< [1/s]
};

/// All collisions of a mill.
struct StressSpectrum {
  std::vector<Nip> nips;
  std::vector<Stress> stresses;
};

/// What a bed is made of.
enum class Bed {
  by_size,  ///< each hit meets grains of one size, which it meets as often as there is mass of them
  mixed     ///< each hit meets the powder as it is, in a bed as high as its mean size
};

/// How hits become broken grains. Energies of collisions are those the case chose.
struct Process {
  AnyCapture capture = {};
  double energy_share = 1;  ///< [1] of a collision's energy that the caught grains get
  AnyBreakage breakage = {};
  AnyFragments fragments = {};
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
  Catch caught(const Nip& nip, double energy, double size) const;
};

}  // namespace mahlwerk::powder

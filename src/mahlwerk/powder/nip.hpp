// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

// Where powder is caught: between two bodies that collide, and what is caught there.
namespace mahlwerk::powder {

/// Two bodies that may catch powder between them.
struct Nip {
  double radius = 0;   ///< [m] > 0 effective, R*; the geometric mean of both directions (cap.2)
  double modulus = 0;  ///< [Pa] > 0 effective, E*
};

/// A grain of the bed in the nip.
struct Grain {
  double size = 0;             ///< [m] > 0
  double density = 0;          ///< [kg/m3] > 0
  double fracture_energy = 0;  ///< [J/kg] median specific energy that breaks it, E_50
  double mass() const { return density * std::numbers::pi / 6 * size * size * size; }  ///< [kg]
};

/// What a collision catches: with this `probability` so many grains, each of which gets the same
/// share.
struct Capture {
  double probability = 0;  ///< [1] 0 to 1
  double grains = 0;       ///< [1] how many, at least one
  double radius = 0;       ///< [m] of the spot they are caught on

  double mean_mass(const Grain& g) const { return probability * grains * g.mass(); }  ///< [kg]
};

/// [m] Hertz's radius of contact of a collision that stores `energy` [J] (cap.1).
inline double contact_radius(const Nip& nip, double energy) {
  return std::pow(1.875 * energy / nip.modulus, 0.2) * std::pow(nip.radius, 0.4);
}

/// A mass that may be less than one grain: then a collision catches one now and then.
inline Capture capture_of_mass(double mass, const Grain& g, double radius) {
  const double grains = mass / g.mass();
  return grains < 1 ? Capture{grains, 1, radius} : Capture{1, grains, radius};
}

}  // namespace mahlwerk::powder

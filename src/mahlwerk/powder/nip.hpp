// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

// The nip between two colliding bodies, and the powder captured in it.
namespace mahlwerk::powder {

/// Geometry and stiffness of two bodies that may capture powder between them.
struct Nip {
  double radius = 0;   ///< [m] > 0 effective radius R*, geometric mean of two directions (cap.2)
  double modulus = 0;  ///< [Pa] > 0 effective modulus E*
};

/// A grain of the bed in the nip.
struct Grain {
  double size = 0;             ///< [m] > 0
  double density = 0;          ///< [kg/m3] > 0
  double fracture_energy = 0;  ///< [J/kg] median specific fracture energy, E_50
  double mass() const { return density * std::numbers::pi / 6 * size * size * size; }  ///< [kg]
};

/// Grains that a collision captures: `grains` with this `probability`, else none. All grains get
/// the same share of the energy.
struct Capture {
  double probability = 0;  ///< [1] 0 to 1
  double grains = 0;       ///< [1] number of grains, at least one
  double radius = 0;       ///< [m] radius of the area of capture

  double mean_mass(const Grain& g) const { return probability * grains * g.mass(); }  ///< [kg]
};

/// [m] Hertz's contact radius of a collision that stores `energy` [J] (cap.1).
inline double contact_radius(const Nip& nip, double energy) {
  return math::pow(1.875 * energy / nip.modulus, 0.2) * math::pow(nip.radius, 0.4);
}

/// Capture of a mean `mass` [kg]. A mass below that of one grain becomes a probability below 1.
inline Capture capture_of_mass(double mass, const Grain& g, double radius) {
  const double grains = mass / g.mass();
  return grains < 1 ? Capture{grains, 1, radius} : Capture{1, grains, radius};
}

}  // namespace mahlwerk::powder

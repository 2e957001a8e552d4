// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

// Flash temperature at the contact of two colliding bodies.
namespace mahlwerk::powder {

/// Properties of two colliding bodies, all > 0.
struct FlashPair {
  double radius = 0;            ///< [m] effective radius R*
  double mass = 0;              ///< [kg] effective mass m*
  double modulus = 0;           ///< [Pa] effective modulus E*
  double effusivity = 0;        ///< [J/(m2 K s^0.5)] of one
  double other_effusivity = 0;  ///< [J/(m2 K s^0.5)] of the other
};

/// [J/(m2 K s^0.5)] Thermal effusivity from conductivity [W/(m K)], density [kg/m3] and heat
/// capacity [J/(kg K)] (hea.10).
inline double effusivity(double conductivity, double density, double heat_capacity) {
  return std::sqrt(conductivity * density * heat_capacity);
}

/// [K/J] Flash temperature rise over the energy lost in a collision (hea.7). `energy_normal` [J] is
/// 1/2 m* u_n^2. Returns 0 if it is 0, as there is no contact area then.
inline double flash_factor(double energy_normal, const FlashPair& p) {
  if (!(energy_normal > 0)) return 0;
  constexpr double hertz_time = 2.943275184324706;  // 2 sqrt(pi) Gamma(7/5)/Gamma(9/10) (dem.9)
  const double depth =                              // (hea.8)
      math::pow(1.875 * energy_normal / (p.modulus * std::sqrt(p.radius)), 0.4);
  const double area = std::numbers::pi * p.radius * depth;
  const double time = hertz_time * depth * std::sqrt(0.5 * p.mass / energy_normal);  // (hea.9)
  return 2 / (area * std::sqrt(std::numbers::pi * time) * (p.effusivity + p.other_effusivity));
}

/// [s] Hertz's contact time of a collision of `energy_normal` [J] > 0 (hea.9).
inline double hertz_time(double energy_normal, const FlashPair& p) {
  constexpr double factor = 2.943275184324706;  // as above
  const double depth = math::pow(1.875 * energy_normal / (p.modulus * std::sqrt(p.radius)), 0.4);
  return factor * depth * std::sqrt(0.5 * p.mass / energy_normal);
}

/// [1] Duration of an impact, its overlap, and one over its force, with the given moduli over those
/// with moduli multiplied by `softening` (hea.11).
inline double softened_duration(double softening) {
  constexpr double hertz_exponent = 0.4;
  return math::pow(softening, hertz_exponent);
}

/// [1] Length of the part of a contact that is an impact, over Hertz's contact time (hea.11).
constexpr double impact_phase = 2;

/// [1] Duration of a contact over Hertz's contact time, both with the given moduli (hea.11).
/// `longer` [1] is its duration with softened moduli over Hertz's time with the given ones,
/// `factor` [1] softened_duration(). Not below 1.
inline double unsoftened_duration(double longer, double factor) {
  const double impact = std::fmin(longer, impact_phase / factor);
  return std::fmax(1, longer - (1 - factor) * impact);
}

}  // namespace mahlwerk::powder

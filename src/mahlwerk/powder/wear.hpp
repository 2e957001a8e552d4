// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Wear of bodies by contacts. Each body wears by its own hardness.
namespace mahlwerk::powder {

/// [Pa] Hardness as a pressure, from a Vickers number > 0 in kgf/mm2 (wea.2).
constexpr double hardness(double vickers) {
  return 9.80665e6 * vickers;
}

/// [N m] Normal force times sliding distance of contacts that dissipated `lost` [J] >= 0 at this
/// finite coefficient of friction (wea.3). Losses of sticking contacts count as sliding at the
/// Coulomb limit. Returns 0 without friction, where losses do not give the distance.
constexpr double load_distance(double lost, double friction) {
  return friction > 0 ? lost / friction : 0;
}

/// [m3] Archard wear volume: `coefficient` K [1], `load_distance` [N m], `hardness` [Pa] (wea.1).
constexpr double archard(double coefficient, double load_distance, double hardness) {
  return coefficient * load_distance / hardness;
}

/// [1] Finnie's function f of the impact angle, from the normal and tangential speeds, both >= 0 in
/// m/s (wea.6). 0 head-on and without speed, at most 0.303.
constexpr double finnie(double approach, double slip) {
  const double speed2 = approach * approach + slip * slip;
  const double cut = 3 * approach <= slip ? approach * (2 * slip - 3 * approach) : slip * slip / 3;
  return speed2 > 0 ? cut / speed2 : 0;
}

/// [m3] Finnie wear volume of one impact: `coefficient` k [1], effective `mass` [kg], speeds [m/s],
/// `hardness` [Pa] (wea.4).
constexpr double finnie_volume(double coefficient, double mass, double approach, double slip,
                               double hardness) {
  const double energy = mass * (approach * approach + slip * slip);
  return coefficient * energy * finnie(approach, slip) / hardness;
}

/// [ug/g] Contamination: worn `volume` [m3] of `density` [kg/m3] per mass of powder [kg] > 0
/// (wea.7).
constexpr double ug_per_g(double volume, double density, double powder_mass) {
  return 1e6 * volume * density / powder_mass;
}

}  // namespace mahlwerk::powder

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What contacts take off their bodies. Each body wears by its own hardness.
namespace mahlwerk::powder {

/// [Pa] Hardness as a pressure, of a Vickers number > 0: kilograms-force over mm2 (wea.2).
constexpr double hardness(double vickers) {
  return 9.80665e6 * vickers;
}

/// [N m] Normal force times way slid of contacts that rubbed away `lost` [J] >= 0 at this friction,
/// finite (wea.3). Losses of contacts that stuck count as slid under the limiting force. 0 without
/// friction: what does not rub does not tell how far it slid.
constexpr double load_distance(double lost, double friction) {
  return friction > 0 ? lost / friction : 0;
}

/// [m3] Archard: `coefficient` K [1], `load_distance` [N m], `hardness` [Pa] (wea.1).
constexpr double archard(double coefficient, double load_distance, double hardness) {
  return coefficient * load_distance / hardness;
}

/// [1] Finnie's f of the angle at which an impact meets the surface, from its speeds along the
/// normal and across, both >= 0 in m/s (wea.6). 0 head-on and without speed, at most 0.303.
constexpr double finnie(double approach, double slip) {
  const double speed2 = approach * approach + slip * slip;
  const double cut = 3 * approach <= slip ? approach * (2 * slip - 3 * approach) : slip * slip / 3;
  return speed2 > 0 ? cut / speed2 : 0;
}

/// [m3] Finnie, of one impact: `coefficient` k [1], effective `mass` [kg], speeds [m/s],
/// `hardness` [Pa] (wea.4).
constexpr double finnie_volume(double coefficient, double mass, double approach, double slip,
                               double hardness) {
  const double energy = mass * (approach * approach + slip * slip);
  return coefficient * energy * finnie(approach, slip) / hardness;
}

/// [ug/g] What is worn, `volume` [m3] of `density` [kg/m3], in the powder [kg] > 0 (wea.7).
constexpr double ug_per_g(double volume, double density, double powder_mass) {
  return 1e6 * volume * density / powder_mass;
}

}  // namespace mahlwerk::powder

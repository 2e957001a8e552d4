// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/contact/restitution.hpp"
#include "mahlwerk/contact/slip_factor.hpp"

// Instantaneous collisions of rough spheres (hard-sphere model): impulses and losses.
namespace mahlwerk::contact {

/// Collision rule. Chen et al. 2016: constant e_n and e_t, no Coulomb limit. Walton: the same below
/// the Coulomb limit `friction` (mu), sliding above it. e_n may depend on the speed.
struct BounceRule {
  Restitution restitution = 1;        ///< e_n in [0, 1]
  double tangential_restitution = 1;  ///< e_t in [-1, 1]: 1 smooth, 0 no slip, -1 perfectly rough
  double friction = INFINITY;         ///< mu >= 0; infinite: no Coulomb limit (Chen et al. 2016)
  bool operator==(const BounceRule&) const = default;
};

/// The impulses of one collision [N s]. Both oppose the motion of the ball relative to the other
/// body.
struct Impulse {
  double normal = 0;      ///< along n
  double tangential = 0;  ///< along the slip direction
};

/// Impulses of a collision of spheres (evt.6, evt.7): effective mass `mass` [kg], `approach` u_n
/// and `slip` |u_t| [m/s]. `restitution` overrides the restitution of the rule. `factor` is the
/// slip factor of the two bodies (hol.4).
inline Impulse bounce(const BounceRule& rule, double mass, double approach, double slip,
                      double restitution, double factor = solid_slip_factor) {
  const double normal = mass * (1 + restitution) * approach;
  const double sticking = 1 / factor * mass * (1 - rule.tangential_restitution) * slip;
  return {normal, std::min(sticking, rule.friction * normal)};
}
inline Impulse bounce(const BounceRule& rule, double mass, double approach, double slip) {
  return bounce(rule, mass, approach, slip, rule.restitution.at(approach));
}

/// Energy that the collision dissipates [J], from the velocities before it and its impulses
/// (evt.8). `factor` as for bounce().
struct Loss {
  double normal = 0, tangential = 0;
};
inline Loss loss(const Impulse& j, double mass, double approach, double slip,
                 double factor = solid_slip_factor) {
  return {j.normal * (approach - 0.5 * j.normal / mass),
          j.tangential * (slip - 0.5 * factor * j.tangential / mass)};
}

}  // namespace mahlwerk::contact

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/step_data.hpp"

// Springs and dashpots, corrected for the length of the step: a collision has its restitution and
// spin in sixteen to thirty steps (docs/theory/soft.md, dem.37, dem.45).
namespace mahlwerk::soft {

/// Corrects the damper of a contact. Its rate was predicted from the force of the step before; the
/// elastic force has changed since (dem.45). `h` is dt^2/(2 m*) [s2/kg].
template <class V>
[[gnu::always_inline]] inline void correct_damper(const V& h, contact::LawForce<V>& f) {
  const V excess = h * f.slope * f.damper;
  f.damper -= excess, f.force -= excess, f.load -= excess;
}

/// Tangential spring and dashpot of a step (dem.37).
template <class V>
struct TangentialSpring {
  V stiffness;    ///< [N/m]
  V damping;      ///< [N s/m] `stabilising` included
  V stabilising;  ///< [N s/m] takes away what the predicted slip gives the spring
};
template <class V>
[[gnu::always_inline]] inline TangentialSpring<V> tangential_spring(const LaneGroup<V>& group,
                                                                    const PairParameters& pair,
                                                                    const contact::LawForce<V>& f,
                                                                    double dt) {
  // (w dt)^2, far below 2 in usual steps; q = sin^2(w dt/2), to 1e-4 of it.
  const V squared = min(group(pair.phase_squared_per_stiffness) * f.stiffness, V{} + 2.0);
  const V share = 1.0 / 4 - squared * (1.0 / 48 - squared * (1.0 / 1440)), q = share * squared;
  const V inverse = 1.0 / (1.0 + 3.0 * q), stiffness = (4.0 * share * inverse) * f.stiffness;
  TangentialSpring<V> spring;
  spring.stiffness = stiffness * (1.0 + 2.0 * q);
  spring.stabilising = (dt * stiffness) * q;
  spring.damping = f.damping * inverse + spring.stabilising;
  return spring;
}

}  // namespace mahlwerk::soft

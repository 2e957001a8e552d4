// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/step_data.hpp"

namespace mahlwerk::soft {

/// Twisting friction (Marshall 2009): the torque on i along the normal [N m], its negative on j. A
/// spring, a dashpot and a slider, those of friction over the contact area (dem.42 to dem.44). The
/// stored angle is half a step ahead, as the tangential spring is.
template <class V>
[[gnu::always_inline]] inline V twisting_torque(
    const LaneGroup<V>& group, const PairParameters& pair, GroupHistory<V>& history,
    WorkOfStep<V>& work, const StepConstants& constants, const ContactGeometry<V>& geometry,
    const PairMotion<V>& motion, const contact::LawForce<V>& law_force, const MaskOf<V>& touching) {
  const V zero{};
  const V square = group(pair.twisting_radius) * max(geometry.overlap, zero);  // a^2
  const V stiffness = 0.5 * square * law_force.stiffness,
          damping = 0.5 * square * law_force.damping,
          limit = (2.0 / 3) * sqrt(square) * group(pair.friction) * law_force.load;
  const V spin = dot(motion.wi - motion.wj, geometry.n), half_turn = 0.5 * constants.dt * spin;
  const V angle = history.twist + half_turn, dashpot = damping * spin;
  const V torque = max(min(-(stiffness * angle) - dashpot, limit), -limit);
  // At the limit the spring keeps what balances the limit, and the part that a dashpot holds which
  // acts against it, as (dem.20).
  const V opposing = max(where<V>(less(dashpot * angle, zero), abs(dashpot)), zero);
  const V most = (limit + opposing) / max(stiffness, zero + 1e-300);
  const V kept = max(min(angle, most), -most);
  history.twist = where<V>(touching, kept + half_turn);
  work.rolling = work.rolling - where<V>(touching, constants.dt * (torque * spin));
  return where<V>(touching, torque);
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/step_data.hpp"

// Partial slip: the tangential stiffness falls as slip spreads from the edge of the contact area
// (Mindlin and Deresiewicz 1953), in the incremental form of Walton and Braun (1986) with the load
// term of Thornton and Yin (1991) (dem.40, dem.41).
namespace mahlwerk::soft {

/// Cube root of numbers from 0 to 1, to rounding: Halley's iteration from y^(5/16).
template <class V>
[[gnu::always_inline]] inline V cube_root(const V& y) {
  const V quarter = sqrt(sqrt(y));
  V root = quarter * sqrt(sqrt(quarter));
  for (int i = 0; i < 3; ++i) {
    const V cubed = root * root * root;
    root = root * (cubed + 2.0 * y) / (2.0 * cubed + y + 1e-300);
  }
  return root;
}

/// The tangential stiffness of a step: `across` [N/m] for slip across the direction of loading,
/// the share `along` of it for slip along this direction.
template <class V>
struct PartialSlip {
  Vec<V> direction;
  V across, along;

  [[gnu::always_inline]] Vec<V> force_change(const Vec<V>& slip) const {
    return across * (slip - ((1.0 - along) * dot(slip, direction)) * direction);
  }
};

/// Advances the elastic tangential force T = history.spring [N] to this step: half the slip of the
/// step, and the change of the load. Updates the turning point of the force.
template <class V>
[[gnu::always_inline]] inline PartialSlip<V> load_tangentially(
    const LaneGroup<V>& group, const PairParameters& pair, GroupHistory<V>& history,
    const Vec<V>& normal, const Vec<V>& half_slip, const V& stiffness, const V& load,
    Vec<V>& force) {
  const V zero{}, one = zero + 1.0, friction = group(pair.friction);
  force = rotate_to_tangent_plane(history.spring, normal);
  // The force of the turning point stays the same share of the limit.
  history.turning_force = (load / max(history.load, zero + 1e-200)) *
                          rotate_to_tangent_plane(history.turning_force, normal);
  const auto reversed = both(less(dot(force - history.turning_force, half_slip), zero),
                             less(zero, history.load));  // the first step turns nothing
  history.turning_force = select<V>(reversed, force, history.turning_force);
  const Vec<V> since = force - history.turning_force;
  const V size = sqrt(dot(since, since));
  PartialSlip<V> slip{(one / max(size, zero + 1e-300)) * since, stiffness, one};
  const V room = max(friction * load - dot(history.turning_force, slip.direction), zero + 1e-300);
  const V load_change = friction * (load - history.load);
  // A load that grows faster than the tangential force closes the slipping ring.
  const auto sticks = less(2.0 * stiffness * dot(half_slip, slip.direction), load_change);
  slip.along = select<V>(sticks, one, cube_root(one - min(size / room, one)));
  force =
      force + slip.force_change(half_slip) + ((one - slip.along) * load_change) * slip.direction;
  history.load = load;
  return slip;
}

}  // namespace mahlwerk::soft

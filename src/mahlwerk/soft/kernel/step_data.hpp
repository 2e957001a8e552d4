// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/rolling.hpp"
#include "mahlwerk/contact/twisting.hpp"
#include "mahlwerk/soft/kernel/contact_transitions.hpp"

// What the forces of a step need: constants, relative motion and geometry of a group of pairs.
namespace mahlwerk::soft {

/// Constants of a step, for all packets.
struct StepConstants {
  double dt = 0, inverse_dt = 0;  ///< [s], [1/s]
  Vec3 jar_velocity{};
  contact::Rolling rolling = contact::Rolling::none;
  double rolling_damping = 0;
  bool rescaled = false;  ///< ContactModel::rescaled_unloading (dem.21)
  bool partial_slip = false;
  contact::Twisting twisting = contact::Twisting::none;
  bool periodic = false;
  Vec3 periods{};
};

/// Whether contacts need FrictionHistory.
inline bool has_friction_history(const StepConstants& constants) {
  return constants.partial_slip || constants.twisting != contact::Twisting::none;
}
template <class V>
[[gnu::always_inline]] inline void get_friction_history(const LaneGroup<V>& group,
                                                        const FrictionHistory& from,
                                                        GroupHistory<V>& history) {
  history.turning_force = group(from.turning_force);
  history.load = group(from.load), history.twist = group(from.twist);
}
/// Stores the history of partial slip and twisting friction where a model needs it.
template <class V>
[[gnu::always_inline]] inline void put_friction_history(const StepConstants& constants,
                                                        const LaneGroup<V>& group,
                                                        const GroupHistory<V>& history,
                                                        FrictionHistory& out) {
  if (constants.partial_slip) {
    group.put(out.turning_force, history.turning_force);
    group.put(out.load, history.load);
  }
  if (constants.twisting == contact::Twisting::marshall) group.put(out.twist, history.twist);
}

/// A 3-vector in all lanes.
template <class V>
[[gnu::always_inline]] inline Vec<V> in_all_lanes(const Vec3& a) {
  const V zero{};
  return {zero + a.x, zero + a.y, zero + a.z};
}

/// Relative position and motion of the pairs of a group.
template <class V>
struct PairMotion {
  Vec<V> separation;         ///< [m] from i to j
  Vec<V> relative_velocity;  ///< [m/s] velocity of i minus that of j
  Vec<V> vj;                 ///< [m/s] velocity of j, for walls only
  Vec<V> wi, wj;             ///< [rad/s] spins
};

/// Force [N] on i, its negative on j; torques [N m] on both.
template <class V>
struct ContactForce {
  Vec<V> force, torque_i, torque_j;
};

/// Impulse and work of a group in a step (ContactWork).
template <class V>
struct WorkOfStep {
  V impulse{}, normal{}, tangential{}, rolling{}, sliding{}, wall{}, overlap{};
  V elastic{};  ///< [N] elastic part of the normal force
};

/// Geometry and relative motion of contacts, independent of the forces.
template <class V>
struct ContactGeometry {
  Vec<V> n;            ///< from i to j
  V overlap;           ///< [m]
  V lever_i, lever_j;  ///< [m] distances from the centres to the contact
  Vec<V> u;            ///< [m/s] relative velocity at the contact (dem.1)
  V overlap_rate;      ///< [m/s] u.n, rate of the overlap
  Vec<V> slip;         ///< [m/s] tangential part of u
};

/// Centre distance [m] below which a pair is in contact: the sum of the radii, and for a pair
/// already in contact also the pull-off distance.
template <class V>
[[gnu::always_inline]] inline V touch_distance(const LaneGroup<V>& group,
                                               const PairParameters& pair,
                                               const MaskOf<V>& touching) {
  return group(pair.radius_i) + group(pair.radius_j) +
         where<V>(touching, group(pair.pull_off_distance));
}

template <class V>
[[gnu::always_inline]] inline ContactGeometry<V> contact_geometry(const LaneGroup<V>& group,
                                                                  const PairParameters& pair,
                                                                  const PairMotion<V>& motion,
                                                                  const V& distance_squared) {
  ContactGeometry<V> geometry;
  const V radius_i = group(pair.radius_i);
  const V distance = sqrt(distance_squared);
  geometry.n = (1.0 / max(distance, V{} + 1e-300)) * motion.separation;  // 0 in free lanes
  geometry.overlap = radius_i + group(pair.radius_j) - distance;
  geometry.lever_i = radius_i - group(pair.overlap_share) * geometry.overlap;
  geometry.lever_j = distance - geometry.lever_i;
  geometry.u = motion.relative_velocity +
               cross(geometry.lever_i * motion.wi + geometry.lever_j * motion.wj, geometry.n);
  geometry.overlap_rate = dot(geometry.u, geometry.n);
  geometry.slip = geometry.u - geometry.overlap_rate * geometry.n;
  return geometry;
}

/// Rotates a vector into the tangent plane of the normal n, with its length kept (dem.18). Uses the
/// series of 1/sqrt(1 - q), q the squared sine of the angle of rotation.
template <class V>
[[gnu::always_inline]] inline Vec<V> rotate_to_tangent_plane(const Vec<V>& vector,
                                                             const Vec<V>& n) {
  const V normal_part = dot(vector, n);
  const V q = normal_part * normal_part / max(dot(vector, vector), V{} + 1e-300);
  const V scale = 1.0 + q * (0.5 + 0.375 * q);
  return scale * (vector - normal_part * n);
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/rolling.hpp"
#include "mahlwerk/soft/kernel/contact_transitions.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"

// Contact forces and torques of eight pairs at a time (docs/theory/soft.md).
namespace mahlwerk::soft {

/// Constants of a step, for all packets.
struct alignas(64) StepConstants {
  double dt = 0, inverse_dt = 0;  ///< [s], [1/s]
  Vec<Lanes> jar_velocity{};
  contact::Rolling rolling = contact::Rolling::none;
  double rolling_damping = 0;
  bool rescaled = false;  ///< ContactModel::rescaled_unloading (dem.21)
  bool periodic = false;
  Vec<Lanes> periods{};
};

/// Relative position and motion of the pairs of a packet.
struct alignas(64) PairMotion {
  Vec<Lanes> separation;         ///< [m] from i to j
  Vec<Lanes> relative_velocity;  ///< [m/s] velocity of i minus that of j
  Vec<Lanes> vj;                 ///< [m/s] velocity of j, for walls only
  Vec<Lanes> wi, wj;             ///< [rad/s] spins
};

/// Force [N] on i, its negative on j; torques [N m] on both.
struct alignas(64) ContactForce {
  Vec<Lanes> force, torque_i, torque_j;
};

/// Geometry and relative motion of contacts, independent of the forces.
struct alignas(64) ContactGeometry {
  Vec<Lanes> n;            ///< from i to j
  Lanes overlap;           ///< [m]
  Lanes lever_i, lever_j;  ///< [m] distances from the centres to the contact
  Vec<Lanes> u;            ///< [m/s] relative velocity at the contact (dem.1)
  Lanes overlap_rate;      ///< [m/s] u.n, rate of the overlap
  Vec<Lanes> slip;         ///< [m/s] tangential part of u
};

/// Centre distance [m] below which a pair is in contact: the sum of the radii, and for a pair
/// already in contact also the pull-off distance.
[[gnu::always_inline]] inline Lanes touch_distance(const PairParameters& pair, LaneMask touching) {
  return pair.radius_i + pair.radius_j + select(touching, pair.pull_off_distance, Lanes{});
}

[[gnu::always_inline]] inline ContactGeometry contact_geometry(const PairParameters& pair,
                                                               const PairMotion& motion,
                                                               Lanes distance_squared) {
  ContactGeometry geometry;
  const Lanes distance = sqrt(distance_squared);
  geometry.n = (1.0 / max(distance, Lanes{} + 1e-300)) * motion.separation;  // 0 in free lanes
  geometry.overlap = pair.radius_i + pair.radius_j - distance;
  geometry.lever_i = pair.radius_i - pair.overlap_share * geometry.overlap;
  geometry.lever_j = distance - geometry.lever_i;
  geometry.u = motion.relative_velocity +
               cross(geometry.lever_i * motion.wi + geometry.lever_j * motion.wj, geometry.n);
  geometry.overlap_rate = dot(geometry.u, geometry.n);
  geometry.slip = geometry.u - geometry.overlap_rate * geometry.n;
  return geometry;
}

/// Rotates a vector into the tangent plane of the normal n, with its length kept (dem.18). Uses the
/// series of 1/sqrt(1 - q), q the squared sine of the angle of rotation.
[[gnu::always_inline]] inline Vec<Lanes> rotate_to_tangent_plane(const Vec<Lanes>& vector,
                                                                 const Vec<Lanes>& n) {
  const Lanes normal_part = dot(vector, n);
  const Lanes q = normal_part * normal_part / max(dot(vector, vector), Lanes{} + 1e-300);
  const Lanes scale = 1.0 + q * (0.5 + 0.375 * q);
  return scale * (vector - normal_part * n);
}

/// Friction force on i [N]: tangential spring and dashpot, cut off at the Coulomb limit (dem.18 to
/// dem.21, dem.37). The stored spring is half a step ahead: each step adds half its slip before the
/// force and half after it (trapezoidal rule). `load_reversed`: lanes whose load has changed sign
/// since the last step, so that the Coulomb limit passed through 0.
[[gnu::always_inline]] inline Vec<Lanes> tangential_force(
    const PairParameters& pair, History& history, ContactWork& work, const StepConstants& constants,
    const ContactGeometry& geometry, const contact::LawForce<Lanes>& law_force, LaneMask touching,
    LaneMask load_reversed) {
  if (constants.rescaled) {
    const Lanes ratio = law_force.stiffness / history.stiffness;
    history.spring =
        select(less(law_force.stiffness, history.stiffness), ratio, Lanes{} + 1.0) * history.spring;
  }
  const Lanes zero{}, one = zero + 1.0;
  const Lanes stiffness =
      law_force.stiffness * (1.0 - pair.stiffness_correction * law_force.stiffness);
  const Vec<Lanes> half_slip = (0.5 * constants.dt) * geometry.slip;
  Vec<Lanes> spring = rotate_to_tangent_plane(history.spring, geometry.n);
  const auto opposing_damping = [&] {
    return max(-(law_force.damping * dot(geometry.slip, spring)), zero);
  };
  if (any(load_reversed)) {  // the limit was 0 about half a step ago
    const Lanes ratio = opposing_damping() / max(stiffness * dot(spring, spring), zero + 1e-150);
    spring = select(load_reversed, min(ratio, one), one) * spring;
  }
  spring = spring + half_slip;
  Vec<Lanes> force = -(stiffness * spring) - law_force.damping * geometry.slip;
  const Lanes limit = pair.friction * law_force.load, squared = dot(force, force);
  const LaneMask sliding = touching & less(limit * limit, squared);
  if (any(sliding)) {
    // Shortens the spring so that its force is the Coulomb limit plus the force of a dashpot that
    // acts against it (dem.20).
    const Lanes size = sqrt(squared), square = dot(spring, spring);
    const Lanes spring_energy = max(stiffness * square, zero + 1e-150);
    const Lanes limited_energy = limit * sqrt(square) + opposing_damping(),
                inverse_product = 1.0 / (size * spring_energy);
    force = select(sliding, limit * (spring_energy * inverse_product), one) * force;
    const Vec<Lanes> limited_spring = select(sliding & less(limited_energy, spring_energy),
                                             limited_energy * (size * inverse_product), one) *
                                      spring;
    const Lanes work_done = dot(force, limited_spring - spring);
    work.sliding += select(sliding, work_done, zero);
    spring = limited_spring;
  }
  history.spring = select<Lanes>(touching, spring + half_slip, Vec<Lanes>{});
  return select<Lanes>(touching, force, Vec<Lanes>{});
}

/// Rolling resistance: the torque on i [N m], its negative on j (dem.22 to dem.25).
[[gnu::always_inline]] inline Vec<Lanes> rolling_torque(
    const PairParameters& pair, History& history, ContactWork& work, const StepConstants& constants,
    const ContactGeometry& geometry, const PairMotion& motion,
    const contact::LawForce<Lanes>& law_force, LaneMask touching) {
  Vec<Lanes> rolling_velocity = motion.wi - motion.wj;
  rolling_velocity =
      rolling_velocity - dot(rolling_velocity, geometry.n) * geometry.n;  // no resistance to twist
  const Lanes zero{}, limit = pair.rolling_coefficient * law_force.load;
  // Limits the torque to one that stops the rolling in sixteen steps. Spins are predicted from the
  // torque of the last step, and a ball may have a dozen contacts that all resist: without the
  // limit, they would reverse its rotation and make it oscillate.
  const auto limited = [&](const Lanes& size) {
    return min(size, (0.0625 * constants.inverse_dt) * pair.inertia);
  };
  Vec<Lanes> torque;
  if (constants.rolling == contact::Rolling::cdt) {
    const Lanes speed = sqrt(dot(rolling_velocity, rolling_velocity));
    const Lanes coefficient = limit / max(speed, zero + 1e-300);
    torque = -(limited(coefficient) * rolling_velocity);
  } else if (constants.rolling == contact::Rolling::viscous) {
    const Vec<Lanes> surface =
        cross(geometry.lever_i * motion.wi + geometry.lever_j * motion.wj, geometry.n);
    const Lanes ratio =
        dot(surface, surface) / max(dot(rolling_velocity, rolling_velocity), zero + 1e-300);
    torque = -(limited(limit * sqrt(ratio)) * rolling_velocity);
  } else {
    const Lanes stiffness = pair.rolling_stiffness_ratio * law_force.stiffness;
    Vec<Lanes> spring_torque = rotate_to_tangent_plane(history.rolling_spring_torque, geometry.n) -
                               (constants.dt * stiffness) * rolling_velocity;
    const Lanes squared = dot(spring_torque, spring_torque);
    const LaneMask at_limit = less(limit * limit, squared);
    if (any(at_limit)) {
      const Lanes factor = limit / sqrt(max(squared, zero + 1e-300));
      spring_torque = select<Lanes>(at_limit, factor * spring_torque, spring_torque);
    }
    // Each ball rolls about the contact, with the inertia (7/5) m R^2 = 7/2 of that about its
    // centre.
    const Lanes damping =
        limited(2.0 * constants.rolling_damping * sqrt(3.5 * pair.inertia * stiffness));
    torque = spring_torque - select(at_limit, zero, damping) * rolling_velocity;
    history.rolling_spring_torque = select<Lanes>(touching, spring_torque, Vec<Lanes>{});
  }
  work.rolling -= select(touching, constants.dt * dot(torque, rolling_velocity), zero);
  return select<Lanes>(touching, torque, Vec<Lanes>{});
}

/// Forces and torques of a packet in a step. Updates its history and its work.
/// `transitions` is null if no contact begins or ends; `walls` is true if there may be walls.
template <class Law>
[[gnu::always_inline]] inline ContactForce contact_force(
    const PairParameters& pair, History& history, ContactWork& work, const StepConstants& constants,
    const PairMotion& motion, const ContactGeometry& geometry, LaneMask touching,
    const ContactTransitions* transitions, bool walls) {
  const Lanes zero{};
  contact::LawForce<Lanes> law_force = Law::template evaluate<Lanes>(
      pair.coefficients, history.law_history, select(touching, geometry.overlap, zero),
      select(touching, geometry.overlap_rate, zero));
  const LaneMask tensile = less(law_force.load, zero) & touching;
  const LaneMask load_reversed = (tensile ^ history.tensile) & touching;
  history.tensile = tensile;
  const Lanes stiffness = law_force.stiffness;
  LaneMask active = touching;
  TransitionCorrection correction;
  if (transitions != nullptr) {
    correction = correct_transitions<Law>(pair, history, *transitions, geometry.overlap,
                                          geometry.overlap_rate, constants.dt, law_force);
    active |= correction.corrected;
    history.spring = select<Lanes>(transitions->begun, correction.initial_slip_time * geometry.slip,
                                   history.spring);
  }
  law_force.force = select(active, law_force.force, zero);
  law_force.load = abs(law_force.load);
  const Vec<Lanes> friction =
      tangential_force(pair, history, work, constants, geometry, law_force, active, load_reversed);
  history.stiffness = stiffness;
  ContactForce out;
  out.force = friction - law_force.force * geometry.n;
  const Vec<Lanes> arm = cross(geometry.n, friction);
  out.torque_i = geometry.lever_i * arm;
  out.torque_j = geometry.lever_j * arm;
  Lanes wall_power{};
  if (walls) wall_power = dot(out.force, motion.vj + constants.jar_velocity);
  if (constants.rolling != contact::Rolling::none) {
    const Vec<Lanes> torque =
        rolling_torque(pair, history, work, constants, geometry, motion, law_force, touching);
    out.torque_i = out.torque_i + torque;
    out.torque_j = out.torque_j - torque;
    if (walls) wall_power += dot(torque, motion.wj);
  }
  Lanes rate = geometry.overlap_rate;
  Vec<Lanes> slip = geometry.slip;
  if (transitions != nullptr) {  // the velocities were predicted from the force of the last step
    const Lanes half = (3.0 / 7.0 * constants.inverse_dt) *
                       pair.stiffness_correction;  // half a step over the mass
    rate -=
        select(correction.corrected, half * (law_force.force - correction.previous_force), zero);
    slip = slip + select(correction.corrected & transitions->begun, 3.5 * half, zero) * friction;
  }
  work.impulse += constants.dt * law_force.force;
  work.normal += constants.dt * (law_force.force * rate);
  work.tangential -= constants.dt * dot(friction, slip);
  if (walls) work.wall += select(pair.wall, constants.dt * wall_power, zero);
  work.max_overlap = max(work.max_overlap, select(touching, geometry.overlap, zero));
  return out;
}

}  // namespace mahlwerk::soft

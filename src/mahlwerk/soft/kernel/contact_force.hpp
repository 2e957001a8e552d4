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
  Vec<Lanes> separation;  ///< [m] from i to j
  Vec<Lanes> relative;    ///< [m/s] velocity of i minus that of j
  Vec<Lanes> vj;          ///< [m/s] velocity of j, for walls only
  Vec<Lanes> wi, wj;      ///< [rad/s] spins
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
  Lanes rate;              ///< [m/s] u.n, rate of the overlap
  Vec<Lanes> slip;         ///< [m/s] tangential part of u
};

/// Centre distance [m] below which a pair is in contact: the sum of the radii, and for a pair
/// already in contact also the pull-off distance.
[[gnu::always_inline]] inline Lanes touch_distance(const PairParameters& p, LaneMask touching) {
  return p.radius_i + p.radius_j + select(touching, p.pull_off_distance, Lanes{});
}

[[gnu::always_inline]] inline ContactGeometry contact_geometry(const PairParameters& p,
                                                               const PairMotion& b, Lanes squared) {
  ContactGeometry m;
  const Lanes distance = sqrt(squared);
  m.n = (1.0 / max(distance, Lanes{} + 1e-300)) * b.separation;  // 0 in free lanes
  m.overlap = p.radius_i + p.radius_j - distance;
  m.lever_i = p.radius_i - p.share * m.overlap;
  m.lever_j = distance - m.lever_i;
  m.u = b.relative + cross(m.lever_i * b.wi + m.lever_j * b.wj, m.n);
  m.rate = dot(m.u, m.n);
  m.slip = m.u - m.rate * m.n;
  return m;
}

/// Rotates a vector into the tangent plane of the normal n, with its length kept (dem.18). Uses the
/// series of 1/sqrt(1 - q), q the squared sine of the angle of rotation.
[[gnu::always_inline]] inline Vec<Lanes> rotate_to_tangent_plane(const Vec<Lanes>& a,
                                                                 const Vec<Lanes>& n) {
  const Lanes along = dot(a, n);
  const Lanes q = along * along / max(dot(a, a), Lanes{} + 1e-300);
  const Lanes longer = 1.0 + q * (0.5 + 0.375 * q);
  return longer * (a - along * n);
}

/// Friction force on i [N]: tangential spring and dashpot, cut off at the Coulomb limit (dem.18 to
/// dem.21, dem.37). The stored spring is half a step ahead: each step adds half its slip before the
/// force and half after it (trapezoidal rule). `turned`: lanes whose load has changed sign since
/// the last step, so that the Coulomb limit passed through 0.
[[gnu::always_inline]] inline Vec<Lanes> tangential_force(const PairParameters& parameters,
                                                          History& p, ContactWork& work,
                                                          const StepConstants& constants,
                                                          const ContactGeometry& m,
                                                          const contact::LawForce<Lanes>& law_force,
                                                          LaneMask touching, LaneMask turned) {
  if (constants.rescaled) {
    const Lanes kept = law_force.stiffness / p.stiffness;
    p.spring = select(less(law_force.stiffness, p.stiffness), kept, Lanes{} + 1.0) * p.spring;
  }
  const Lanes none{}, one = none + 1.0;
  const Lanes stiffness = law_force.stiffness * (1.0 - parameters.lag * law_force.stiffness);
  const Vec<Lanes> half = (0.5 * constants.dt) * m.slip;
  Vec<Lanes> spring = rotate_to_tangent_plane(p.spring, m.n);
  const auto against = [&] { return max(-(law_force.damping * dot(m.slip, spring)), none); };
  if (any(turned)) {  // the limit was 0 about half a step ago
    const Lanes kept = against() / max(stiffness * dot(spring, spring), none + 1e-150);
    spring = select(turned, min(kept, one), one) * spring;
  }
  spring = spring + half;
  Vec<Lanes> force = -(stiffness * spring) - law_force.damping * m.slip;
  const Lanes most = parameters.friction * law_force.load, squared = dot(force, force);
  const LaneMask slides = touching & less(most * most, squared);
  if (any(slides)) {
    // Shortens the spring so that its force is the Coulomb limit plus the force of a dashpot that
    // acts against it (dem.20).
    const Lanes size = sqrt(squared), square = dot(spring, spring);
    const Lanes pull = max(stiffness * square, none + 1e-150);
    const Lanes held = most * sqrt(square) + against(), both = 1.0 / (size * pull);
    force = select(slides, most * (pull * both), one) * force;
    const Vec<Lanes> left = select(slides & less(held, pull), held * (size * both), one) * spring;
    const Lanes slid = dot(force, left - spring);
    work.sliding += select(slides, slid, none);
    spring = left;
  }
  p.spring = select<Lanes>(touching, spring + half, Vec<Lanes>{});
  return select<Lanes>(touching, force, Vec<Lanes>{});
}

/// Rolling resistance: the torque on i [N m], its negative on j (dem.22 to dem.25).
[[gnu::always_inline]] inline Vec<Lanes> rolling_torque(
    const PairParameters& p, History& past, ContactWork& work, const StepConstants& constants,
    const ContactGeometry& m, const PairMotion& b, const contact::LawForce<Lanes>& law_force,
    LaneMask touching) {
  Vec<Lanes> turning = b.wi - b.wj;
  turning = turning - dot(turning, m.n) * m.n;  // no resistance to twist
  const Lanes none{}, most = p.rolling * law_force.load;
  // Limits the torque to one that stops the rolling in sixteen steps. Spins are predicted from the
  // torque of the last step, and a ball may have a dozen contacts that all resist: without the
  // limit, they would reverse its rotation and make it oscillate.
  const auto limited = [&](const Lanes& size) {
    return min(size, (0.0625 * constants.inverse_dt) * p.inertia);
  };
  Vec<Lanes> torque;
  if (constants.rolling == contact::Rolling::cdt) {
    const Lanes speed = sqrt(dot(turning, turning));
    const Lanes whole = most / max(speed, none + 1e-300);
    torque = -(limited(whole) * turning);
  } else if (constants.rolling == contact::Rolling::viscous) {
    const Vec<Lanes> surface = cross(m.lever_i * b.wi + m.lever_j * b.wj, m.n);
    const Lanes ratio = dot(surface, surface) / max(dot(turning, turning), none + 1e-300);
    torque = -(limited(most * sqrt(ratio)) * turning);
  } else {
    const Lanes stiffness = p.roll_spring * law_force.stiffness;
    Vec<Lanes> spring =
        rotate_to_tangent_plane(past.roll, m.n) - (constants.dt * stiffness) * turning;
    const Lanes squared = dot(spring, spring);
    const LaneMask slips = less(most * most, squared);
    if (any(slips)) {
      const Lanes factor = most / sqrt(max(squared, none + 1e-300));
      spring = select<Lanes>(slips, factor * spring, spring);
    }
    // Each ball rolls about the contact, with the inertia (7/5) m R^2 = 7/2 of that about its
    // centre.
    const Lanes damping =
        limited(2.0 * constants.rolling_damping * sqrt(3.5 * p.inertia * stiffness));
    torque = spring - select(slips, none, damping) * turning;
    past.roll = select<Lanes>(touching, spring, Vec<Lanes>{});
  }
  work.rolling -= select(touching, constants.dt * dot(torque, turning), none);
  return select<Lanes>(touching, torque, Vec<Lanes>{});
}

/// Forces and torques of a packet in a step. Updates its history `past` and its work `d`.
/// `transitions` is null if no contact begins or ends; `walls` is true if there may be walls.
template <class Law>
[[gnu::always_inline]] inline ContactForce contact_force(
    const PairParameters& p, History& past, ContactWork& d, const StepConstants& constants,
    const PairMotion& b, const ContactGeometry& m, LaneMask touching,
    const ContactTransitions* transitions, bool walls) {
  const Lanes none{};
  contact::LawForce<Lanes> f = Law::template evaluate<Lanes>(p.coefficients, past.law_history,
                                                             select(touching, m.overlap, none),
                                                             select(touching, m.rate, none));
  const LaneMask pulls = less(f.load, none) & touching;
  const LaneMask turned = (pulls ^ past.pulls) & touching;
  past.pulls = pulls;
  const Lanes stiffness = f.stiffness;
  LaneMask live = touching;
  TransitionCorrection correction;
  if (transitions != nullptr) {
    correction =
        correct_transitions<Law>(p, past, *transitions, m.overlap, m.rate, constants.dt, f);
    live |= correction.counts;
    past.spring = select<Lanes>(transitions->begun, correction.lead * m.slip, past.spring);
  }
  f.force = select(live, f.force, none);
  f.load = abs(f.load);
  const Vec<Lanes> friction = tangential_force(p, past, d, constants, m, f, live, turned);
  past.stiffness = stiffness;
  ContactForce out;
  out.force = friction - f.force * m.n;
  const Vec<Lanes> arm = cross(m.n, friction);
  out.torque_i = m.lever_i * arm;
  out.torque_j = m.lever_j * arm;
  Lanes by_wall{};
  if (walls) by_wall = dot(out.force, b.vj + constants.jar_velocity);
  if (constants.rolling != contact::Rolling::none) {
    const Vec<Lanes> torque = rolling_torque(p, past, d, constants, m, b, f, touching);
    out.torque_i = out.torque_i + torque;
    out.torque_j = out.torque_j - torque;
    if (walls) by_wall += dot(torque, b.wj);
  }
  Lanes rate = m.rate;
  Vec<Lanes> slip = m.slip;
  if (transitions != nullptr) {  // the velocities were predicted from the force of the last step
    const Lanes half = (3.0 / 7.0 * constants.inverse_dt) * p.lag;  // half a step over the mass
    rate -= select(correction.counts, half * (f.force - correction.before), none);
    slip = slip + select(correction.counts & transitions->begun, 3.5 * half, none) * friction;
  }
  d.impulse += constants.dt * f.force;
  d.normal += constants.dt * (f.force * rate);
  d.tangential -= constants.dt * dot(friction, slip);
  if (walls) d.wall += select(p.wall, constants.dt * by_wall, none);
  d.deepest = max(d.deepest, select(touching, m.overlap, none));
  return out;
}

}  // namespace mahlwerk::soft

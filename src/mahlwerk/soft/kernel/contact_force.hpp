// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/rolling.hpp"
#include "mahlwerk/soft/kernel/edges.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"

// What two bodies that touch do to each other, eight pairs at a time (docs/theory/soft.md).
namespace mahlwerk::soft {

/// What is the same for all packets of a step.
struct alignas(64) Frame {
  double step = 0, per_step = 0;  ///< [s], [1/s]
  Vec<Lanes> jar_speed{};
  contact::Rolling rolling = contact::Rolling::none;
  double rolling_damping = 0;
  bool rescaled = false;  ///< the tangential spring gives way as the contact unloads
  bool periodic = false;
  Vec<Lanes> periods{};
};

/// The bodies of a packet's lanes.
struct alignas(64) Bodies {
  Vec<Lanes> apart;     ///< [m] from i to j
  Vec<Lanes> relative;  ///< [m/s] velocity of i less that of j
  Vec<Lanes> vj;        ///< [m/s] needed of walls only
  Vec<Lanes> wi, wj;    ///< [rad/s]
};

/// Force [N] on i, its opposite on j; torques [N m] on both.
struct alignas(64) ContactForce {
  Vec<Lanes> force, torque_i, torque_j;
};

/// Two bodies as they meet, before any force is known.
struct alignas(64) ContactGeometry {
  Vec<Lanes> n;            ///< from i to j
  Lanes overlap;           ///< [m]
  Lanes lever_i, lever_j;  ///< [m] from the centres to the contact
  Vec<Lanes> u;            ///< [m/s] relative velocity there (dem.1)
  Lanes rate;              ///< [m/s] u.n, of the overlap
  Vec<Lanes> slip;         ///< [m/s] u across n
};

/// Shorter or equal to which the distance of two centres is a touch.
[[gnu::always_inline]] inline Lanes touch_distance(const PairParameters& p, LaneMask touching) {
  return p.radius_i + p.radius_j + choose(touching, p.reach, Lanes{});
}

[[gnu::always_inline]] inline ContactGeometry contact_geometry(const PairParameters& p,
                                                               const Bodies& b, Lanes squared) {
  ContactGeometry m;
  const Lanes distance = root(squared);
  m.n = (1.0 / larger(distance, Lanes{} + 1e-300)) * b.apart;  // 0 in free lanes
  m.overlap = p.radius_i + p.radius_j - distance;
  m.lever_i = p.radius_i - p.share * m.overlap;
  m.lever_j = distance - m.lever_i;
  m.u = b.relative + cross(m.lever_i * b.wi + m.lever_j * b.wj, m.n);
  m.rate = dot(m.u, m.n);
  m.slip = m.u - m.rate * m.n;
  return m;
}

/// A vector across the last normal laid across this one, its length kept (dem.18): by the series of
/// 1/sqrt(1 - q), q the square of the sine of what it turns by.
[[gnu::always_inline]] inline Vec<Lanes> rotate_to_tangent_plane(const Vec<Lanes>& a,
                                                                 const Vec<Lanes>& n) {
  const Lanes along = dot(a, n);
  const Lanes q = along * along / larger(dot(a, a), Lanes{} + 1e-300);
  const Lanes longer = 1.0 + q * (0.5 + 0.375 * q);
  return longer * (a - along * n);
}

/// Friction: a spring and a dashpot across the normal, cut off at Coulomb's limit (dem.18 to
/// dem.21, dem.37). The spring is kept half a step ahead, so that it grows by the mean of the slip
/// of two steps; where the load changes its sign it was at the limit of 0. Returns the force on i.
[[gnu::always_inline]] inline Vec<Lanes> tangential_force(const PairParameters& parameters,
                                                          History& p, ContactWork& work,
                                                          const Frame& frame,
                                                          const ContactGeometry& m,
                                                          const contact::Push<Lanes>& push,
                                                          LaneMask touching, LaneMask turned) {
  if (frame.rescaled) {
    const Lanes kept = push.stiffness / p.stiffness;
    p.spring = choose(less(push.stiffness, p.stiffness), kept, Lanes{} + 1.0) * p.spring;
  }
  const Lanes none{}, one = none + 1.0;
  const Lanes stiffness = push.stiffness * (1.0 - parameters.lag * push.stiffness);
  const Vec<Lanes> half = (0.5 * frame.step) * m.slip;
  Vec<Lanes> spring = rotate_to_tangent_plane(p.spring, m.n);
  const auto against = [&] { return larger(-(push.damping * dot(m.slip, spring)), none); };
  if (any(turned)) {  // the limit was 0 about half a step ago
    const Lanes kept = against() / larger(stiffness * dot(spring, spring), none + 1e-150);
    spring = choose(turned, smaller(kept, one), one) * spring;
  }
  spring = spring + half;
  Vec<Lanes> force = -(stiffness * spring) - push.damping * m.slip;
  const Lanes most = parameters.friction * push.load, squared = dot(force, force);
  const LaneMask slides = touching & less(most * most, squared);
  if (any(slides)) {
    // The spring keeps what it can hold by itself, and what a dashpot against it holds besides.
    const Lanes size = root(squared), square = dot(spring, spring);
    const Lanes pull = larger(stiffness * square, none + 1e-150);
    const Lanes held = most * root(square) + against(), both = 1.0 / (size * pull);
    force = choose(slides, most * (pull * both), one) * force;
    const Vec<Lanes> left = choose(slides & less(held, pull), held * (size * both), one) * spring;
    const Lanes slid = dot(force, left - spring);
    work.sliding += choose(slides, slid, none);
    spring = left;
  }
  p.spring = choose<Lanes>(touching, spring + half, Vec<Lanes>{});
  return choose<Lanes>(touching, force, Vec<Lanes>{});
}

/// Rolling resistance: the torque on i, its opposite on j (dem.22 to dem.25).
[[gnu::always_inline]] inline Vec<Lanes> rolling_torque(const PairParameters& p, History& past,
                                                        ContactWork& work, const Frame& frame,
                                                        const ContactGeometry& m, const Bodies& b,
                                                        const contact::Push<Lanes>& push,
                                                        LaneMask touching) {
  Vec<Lanes> turning = b.wi - b.wj;
  turning = turning - dot(turning, m.n) * m.n;  // twist is not resisted
  const Lanes none{}, most = p.rolling * push.load;
  // What stops it within sixteen steps: speeds are predicted from the last step's torque, a ball
  // has a dozen neighbours that all resist, and together they must not turn it back.
  const auto limited = [&](const Lanes& size) {
    return smaller(size, (0.0625 * frame.per_step) * p.inertia);
  };
  Vec<Lanes> torque;
  if (frame.rolling == contact::Rolling::cdt) {
    const Lanes speed = root(dot(turning, turning));
    const Lanes whole = most / larger(speed, none + 1e-300);
    torque = -(limited(whole) * turning);
  } else if (frame.rolling == contact::Rolling::viscous) {
    const Vec<Lanes> surface = cross(m.lever_i * b.wi + m.lever_j * b.wj, m.n);
    const Lanes ratio = dot(surface, surface) / larger(dot(turning, turning), none + 1e-300);
    torque = -(limited(most * root(ratio)) * turning);
  } else {
    const Lanes stiffness = p.roll_spring * push.stiffness;
    Vec<Lanes> spring =
        rotate_to_tangent_plane(past.roll, m.n) - (frame.step * stiffness) * turning;
    const Lanes squared = dot(spring, spring);
    const LaneMask slips = less(most * most, squared);
    if (any(slips)) {
      const Lanes factor = most / root(larger(squared, none + 1e-300));
      spring = choose<Lanes>(slips, factor * spring, spring);
    }
    // Each ball rolls about the contact, with (7/5) m R^2 = 7/2 of its own inertia.
    const Lanes damping = limited(2.0 * frame.rolling_damping * root(3.5 * p.inertia * stiffness));
    torque = spring - choose(slips, none, damping) * turning;
    past.roll = choose<Lanes>(touching, spring, Vec<Lanes>{});
  }
  work.rolling -= choose(touching, frame.step * dot(torque, turning), none);
  return choose<Lanes>(touching, torque, Vec<Lanes>{});
}

/// All that the pairs of a packet do to each other in a step; `edges` where contacts begin or end;
/// `walls`: some may be at a wall.
template <class Law>
[[gnu::always_inline]] inline ContactForce contact_force(const PairParameters& p, History& past,
                                                         ContactWork& d, const Frame& frame,
                                                         const Bodies& b, const ContactGeometry& m,
                                                         LaneMask touching, const Edges* edges,
                                                         bool walls) {
  const Lanes none{};
  contact::Push<Lanes> f = Law::template push<Lanes>(
      p.numbers, past.memory, choose(touching, m.overlap, none), choose(touching, m.rate, none));
  const LaneMask pulls = less(f.load, none) & touching;
  const LaneMask turned = (pulls ^ past.pulls) & touching;
  past.pulls = pulls;
  const Lanes stiffness = f.stiffness;
  LaneMask live = touching;
  AtEdges odd;
  if (edges != nullptr) {
    odd = at_the_edges<Law>(p, past, *edges, m.overlap, m.rate, frame.step, f);
    live |= odd.counts;
    past.spring = choose<Lanes>(edges->begun, odd.lead * m.slip, past.spring);
  }
  f.force = choose(live, f.force, none);
  f.load = size_of(f.load);
  const Vec<Lanes> friction = tangential_force(p, past, d, frame, m, f, live, turned);
  past.stiffness = stiffness;
  ContactForce out;
  out.force = friction - f.force * m.n;
  const Vec<Lanes> arm = cross(m.n, friction);
  out.torque_i = m.lever_i * arm;
  out.torque_j = m.lever_j * arm;
  Lanes by_wall{};
  if (walls) by_wall = dot(out.force, b.vj + frame.jar_speed);
  if (frame.rolling != contact::Rolling::none) {
    const Vec<Lanes> torque = rolling_torque(p, past, d, frame, m, b, f, touching);
    out.torque_i = out.torque_i + torque;
    out.torque_j = out.torque_j - torque;
    if (walls) by_wall += dot(torque, b.wj);
  }
  Lanes rate = m.rate;
  Vec<Lanes> slip = m.slip;
  if (edges != nullptr) {  // speeds were predicted from the force a step ago, which this is not
    const Lanes half = (3.0 / 7.0 * frame.per_step) * p.lag;  // of a step over the mass
    rate -= choose(odd.counts, half * (f.force - odd.before), none);
    slip = slip + choose(odd.counts & edges->begun, 3.5 * half, none) * friction;
  }
  d.impulse += frame.step * f.force;
  d.normal += frame.step * (f.force * rate);
  d.tangential -= frame.step * dot(friction, slip);
  if (walls) d.wall += choose(p.wall, frame.step * by_wall, none);
  d.deepest = larger(d.deepest, choose(touching, m.overlap, none));
  return out;
}

}  // namespace mahlwerk::soft

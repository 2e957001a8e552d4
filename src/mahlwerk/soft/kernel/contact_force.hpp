// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/partial_slip.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"
#include "mahlwerk/soft/kernel/step_correction.hpp"
#include "mahlwerk/soft/kernel/twisting_torque.hpp"

// Contact forces and torques of a group of pairs (docs/theory/soft.md).
namespace mahlwerk::soft {

/// Work [J] that the predicted slip of a step adds to the work against friction (dem.46): that of
/// the stabilising dashpot, or of a sliding contact whose load changes.
template <class V>
[[gnu::always_inline]] inline V predicted_work(const LaneGroup<V>& group,
                                               const PairParameters& pair, double dt,
                                               const ContactGeometry<V>& geometry,
                                               const contact::LawForce<V>& law_force,
                                               const TangentialSpring<V>& spring,
                                               const MaskOf<V>& sliding) {
  const V change = (dt * group(pair.friction)) * law_force.slope * geometry.overlap_rate;
  return select<V>(sliding, 0.25 * group(pair.phase_squared_per_stiffness) * change * change,
                   dt * dot(geometry.slip, geometry.slip) * spring.stabilising);
}

/// Friction force on i [N]: tangential spring and dashpot, cut off at the Coulomb limit (dem.18 to
/// dem.21, dem.37). The stored spring is half a step ahead: each step adds half its slip before the
/// force and half after it (trapezoidal rule). `load_reversed`: lanes whose load has changed sign
/// since the last step, so that the Coulomb limit passed through 0.
template <class V>
[[gnu::always_inline]] inline Vec<V> tangential_force(
    const LaneGroup<V>& group, const PairParameters& pair, GroupHistory<V>& history,
    WorkOfStep<V>& work, const StepConstants& constants, const ContactGeometry<V>& geometry,
    const contact::LawForce<V>& law_force, const MaskOf<V>& touching,
    const MaskOf<V>& load_reversed) {
  if (constants.rescaled) {
    const V ratio = law_force.stiffness / history.stiffness;
    history.spring =
        select(less(law_force.stiffness, history.stiffness), ratio, V{} + 1.0) * history.spring;
  }
  const V zero{}, one = zero + 1.0;
  const TangentialSpring<V> full = tangential_spring<V>(group, pair, law_force, constants.dt);
  const Vec<V> half_slip = (0.5 * constants.dt) * geometry.slip;
  PartialSlip<V> partial;
  Vec<V> spring;  // with partial slip its force, as a spring of stiffness 1
  if (constants.partial_slip)
    partial = load_tangentially<V>(group, pair, history, geometry.n, half_slip, full.stiffness,
                                   law_force.load, spring);
  else
    spring = rotate_to_tangent_plane(history.spring, geometry.n);
  const V stiffness = constants.partial_slip ? one : full.stiffness;
  const auto opposing_damping = [&] {
    return max(-(full.damping * dot(geometry.slip, spring)), zero);
  };
  if (any(load_reversed)) {  // the limit was 0 about half a step ago
    const V ratio = opposing_damping() / max(stiffness * dot(spring, spring), zero + 1e-150);
    spring = select(load_reversed, min(ratio, one), one) * spring;
  }
  if (!constants.partial_slip) spring = spring + half_slip;
  Vec<V> force = -(stiffness * spring) - full.damping * geometry.slip;
  const V limit = group(pair.friction) * law_force.load, squared = dot(force, force);
  const MaskOf<V> sliding = touching & less(limit * limit, squared);
  work.tangential = -where<V>(
      touching, predicted_work<V>(group, pair, constants.dt, geometry, law_force, full, sliding));
  if (any(sliding)) {
    // Shortens the spring so that its force is the Coulomb limit plus the force of a dashpot that
    // acts against it (dem.20).
    const V size = sqrt(squared), square = dot(spring, spring);
    const V spring_energy = max(stiffness * square, zero + 1e-150);
    const V limited_energy = limit * sqrt(square) + opposing_damping(),
            inverse_product = 1.0 / max(size * spring_energy, zero + 1e-300);
    force = select(sliding, limit * (spring_energy * inverse_product), one) * force;
    const Vec<V> limited_spring = select(sliding & less(limited_energy, spring_energy),
                                         limited_energy * (size * inverse_product), one) *
                                  spring;
    // With partial slip the spring is a force, and its length that over the stiffness. A contact
    // that has ended has none.
    V length = one;
    if (constants.partial_slip)
      length = where<V>(less(zero, history.stiffness), one / max(history.stiffness, zero + 1e-300));
    const V work_done = length * dot(force, limited_spring - spring);
    work.sliding = where<V>(sliding, work_done);
    spring = limited_spring;
  }
  // A contact without stiffness, as a liquid bridge across a gap, stores nothing.
  history.spring =
      where<V>(touching & less(zero, law_force.stiffness),
               spring + (constants.partial_slip ? partial.force_change(half_slip) : half_slip));
  return where<V>(touching, force);
}

/// Rolling resistance: the torque on i [N m], its negative on j (dem.22 to dem.25).
template <class V>
[[gnu::always_inline]] inline Vec<V> rolling_torque(
    const LaneGroup<V>& group, const PairParameters& pair, GroupHistory<V>& history,
    WorkOfStep<V>& work, const StepConstants& constants, const ContactGeometry<V>& geometry,
    const PairMotion<V>& motion, const contact::LawForce<V>& law_force, const MaskOf<V>& touching) {
  Vec<V> rolling_velocity = motion.wi - motion.wj;
  rolling_velocity =
      rolling_velocity - dot(rolling_velocity, geometry.n) * geometry.n;  // no resistance to twist
  const V zero{}, limit = group(pair.rolling_coefficient) * law_force.load,
                  inertia = group(pair.inertia);
  // Limits the torque to one that stops the rolling in sixteen steps. Spins are predicted from the
  // torque of the last step, and a ball may have a dozen contacts that all resist: without the
  // limit, they would reverse its rotation and make it oscillate.
  const auto limited = [&](const V& size) {
    return min(size, (0.0625 * constants.inverse_dt) * inertia);
  };
  Vec<V> torque;
  if (constants.rolling == contact::Rolling::cdt) {
    const V speed = sqrt(dot(rolling_velocity, rolling_velocity));
    const V coefficient = limit / max(speed, zero + 1e-300);
    torque = -(limited(coefficient) * rolling_velocity);
  } else if (constants.rolling == contact::Rolling::viscous) {
    const Vec<V> surface =
        cross(geometry.lever_i * motion.wi + geometry.lever_j * motion.wj, geometry.n);
    const V ratio =
        dot(surface, surface) / max(dot(rolling_velocity, rolling_velocity), zero + 1e-300);
    torque = -(limited(limit * sqrt(ratio)) * rolling_velocity);
  } else {
    const V stiffness = group(pair.rolling_stiffness_ratio) * law_force.stiffness;
    Vec<V> spring_torque = rotate_to_tangent_plane(history.rolling_spring_torque, geometry.n) -
                           (constants.dt * stiffness) * rolling_velocity;
    const V squared = dot(spring_torque, spring_torque);
    const MaskOf<V> at_limit = less(limit * limit, squared);
    if (any(at_limit)) {
      const V factor = limit / sqrt(max(squared, zero + 1e-300));
      spring_torque = select<V>(at_limit, factor * spring_torque, spring_torque);
    }
    // Each ball rolls about the contact, with the inertia about its centre times the slip factor:
    // (7/5) m R^2 for a solid ball.
    const V damping = limited(2.0 * constants.rolling_damping *
                              sqrt(group(pair.slip_factor) * inertia * stiffness));
    torque = spring_torque - select<V>(at_limit, zero, damping) * rolling_velocity;
    history.rolling_spring_torque = where<V>(touching, spring_torque);
  }
  work.rolling = -where<V>(touching, constants.dt * dot(torque, rolling_velocity));
  return where<V>(touching, torque);
}

/// Rolling resistance of each body against its own spin in the laboratory (dem.38). A wall has no
/// radius, so it has no torque: what a ball loses at a wall is dissipated.
template <class V>
[[gnu::always_inline]] inline void add_own_spin_torques(
    const LaneGroup<V>& group, const PairParameters& pair, WorkOfStep<V>& work,
    const StepConstants& constants, const PairMotion<V>& motion,
    const contact::LawForce<V>& law_force, const MaskOf<V>& touching, ContactForce<V>& out) {
  const V limit = group(pair.rolling_coefficient) * law_force.load;
  // As in rolling_torque(): no contact stops a spin within sixteen steps.
  const V stopping = (0.0625 * constants.inverse_dt) * group(pair.inertia);
  const auto torque_on = [&](const V& radius, const Vec<V>& spin) {
    const V speed = sqrt(dot(spin, spin));
    const V size = min(limit * radius / max(speed, V{} + 1e-300), stopping);
    return where<V>(touching, -(size * spin));
  };
  const Vec<V> torque_i = torque_on(group(pair.radius_i), motion.wi),
               torque_j = torque_on(group(pair.radius_j), motion.wj);
  work.rolling = -(constants.dt * (dot(torque_i, motion.wi) + dot(torque_j, motion.wj)));
  out.torque_i = out.torque_i + torque_i;
  out.torque_j = out.torque_j + torque_j;
}

/// Plastic energy [J] of the contacts of a group, by a law that has one.
template <class Law, class V>
[[gnu::always_inline]] inline V plastic_energy(
    const std::array<V, contact::law_coefficient_count>& coefficients,
    const GroupHistory<V>& history) {
  if constexpr (requires { Law::plastic_energy(coefficients.data(), history.law_history); })
    return Law::plastic_energy(coefficients.data(), history.law_history);
  else
    return V{};
}

/// Forces and torques of a group in a step. Updates its history; `work` is what this step adds.
/// `transitions` is null if no contact begins or ends; `walls` is true if there may be walls.
template <class Law, class V>
[[gnu::always_inline]] inline ContactForce<V> contact_force(
    const LaneGroup<V>& group, const PairParameters& pair, GroupHistory<V>& history,
    WorkOfStep<V>& work, const StepConstants& constants, const PairMotion<V>& motion,
    const ContactGeometry<V>& geometry, const MaskOf<V>& touching,
    const ContactTransitions<V>* transitions, bool walls) {
  using Mask = MaskOf<V>;
  const V zero{};
  work = WorkOfStep<V>{};
  const auto coefficients = load_coefficients<V>(group, pair);
  const V plastic_before = plastic_energy<Law>(coefficients, history);
  contact::LawForce<V> law_force = Law::template evaluate<V>(
      coefficients.data(), history.law_history, where<V>(touching, geometry.overlap),
      where<V>(touching, geometry.overlap_rate));
  correct_damper(group(pair.half_step_squared_over_mass), law_force);
  const Mask tensile = less(law_force.load, zero) & touching;
  const Mask load_reversed = (tensile ^ history.tensile) & touching;
  history.tensile = tensile;
  const V stiffness = law_force.stiffness;
  Mask active = touching;
  TransitionCorrection<V> correction;
  if (transitions != nullptr) {
    correction = correct_transitions<Law, V>(group, pair, history, *transitions, geometry.overlap,
                                             geometry.overlap_rate, constants.dt, law_force);
    active |= correction.corrected;
    const V unit = constants.partial_slip ? law_force.stiffness : zero + 1.0;
    history.spring = select<V>(
        transitions->begun, (correction.initial_slip_time * unit) * geometry.slip, history.spring);
  }
  if (constants.partial_slip) history.stiffness = stiffness;
  law_force.force = where<V>(active, law_force.force);
  const V damper = where<V>(active, law_force.damper);
  law_force.load = abs(law_force.load);
  const Vec<V> friction = tangential_force<V>(group, pair, history, work, constants, geometry,
                                              law_force, active, load_reversed);
  history.stiffness = stiffness;
  ContactForce<V> out;
  out.force = friction - law_force.force * geometry.n;
  const Vec<V> arm = cross(geometry.n, friction);
  out.torque_i = geometry.lever_i * arm;
  out.torque_j = geometry.lever_j * arm;
  V wall_power{};
  if (walls) wall_power = dot(out.force, motion.vj + in_all_lanes<V>(constants.jar_velocity));
  if (constants.rolling == contact::Rolling::own_spin) {
    add_own_spin_torques<V>(group, pair, work, constants, motion, law_force, touching, out);
  } else if (constants.rolling != contact::Rolling::none) {
    const Vec<V> torque = rolling_torque<V>(group, pair, history, work, constants, geometry, motion,
                                            law_force, touching);
    out.torque_i = out.torque_i + torque;
    out.torque_j = out.torque_j - torque;
    if (walls) wall_power += dot(torque, motion.wj);
  }
  if (constants.twisting == contact::Twisting::marshall) {
    const Vec<V> torque = twisting_torque<V>(group, pair, history, work, constants, geometry,
                                             motion, law_force, touching) *
                          geometry.n;
    out.torque_i = out.torque_i + torque;
    out.torque_j = out.torque_j - torque;
    if (walls) wall_power += dot(torque, motion.wj);
  }
  // Rates were predicted from the force of the last step. The elastic force has grown since; the
  // first force of a contact is all new.
  const V half_kick = constants.inverse_dt * group(pair.half_step_squared_over_mass);
  const V lag = (2.0 / 3) * group(pair.half_step_squared_over_mass) * law_force.slope;  // (dem.39)
  V rate = (1.0 - lag) * geometry.overlap_rate;
  Vec<V> slip = geometry.slip;
  if (transitions != nullptr) {
    const Mask first = correction.corrected & transitions->begun;
    rate = select<V>(first, geometry.overlap_rate - half_kick * law_force.force, rate);
    slip = slip + where<V>(first, group(pair.slip_factor) * half_kick) * friction;
  }
  work.impulse = constants.dt * law_force.force;
  work.normal = constants.dt * (damper * rate) +
                (plastic_energy<Law>(coefficients, history) - plastic_before);  // (dem.39)
  work.tangential -= constants.dt * dot(friction, slip);
  if (walls) work.wall = where<V>(group(pair.wall), constants.dt * wall_power);
  work.overlap = where<V>(touching, geometry.overlap);
  work.elastic = law_force.force - damper;
  return out;
}

/// Speeds of the contacts that begin.
template <class V>
[[gnu::always_inline]] inline void put_onset_speeds(const LaneGroup<V>& group,
                                                    const ContactGeometry<V>& geometry,
                                                    const PairMotion<V>& motion,
                                                    OnsetSpeeds& speeds) {
  const Vec<V> glide =
      motion.relative_velocity - dot(motion.relative_velocity, geometry.n) * geometry.n;
  group.put(speeds.approach, geometry.overlap_rate);
  group.put(speeds.slip, sqrt(dot(geometry.slip, geometry.slip)));
  group.put(speeds.glide, sqrt(dot(glide, glide)));
}

}  // namespace mahlwerk::soft

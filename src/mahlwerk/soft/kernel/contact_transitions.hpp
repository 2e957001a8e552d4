// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/soft/kernel/contact_data.hpp"

// Contacts begin and end between two steps. The first and last force of a contact are corrected,
// because they do not act for a whole step (dem.35, dem.36).
namespace mahlwerk::soft {

/// Lanes whose contact begins in this step, or ended since the last step.
struct alignas(64) ContactTransitions {
  LaneMask begun{}, ended{};
};

/// Weight of the first force of a contact, times step_fraction^(1/4), for a force that grows as the
/// fourth root of the time since touch, as damping proportional to overlap^(1/4) does (Tsuji's
/// law). With this weight, the sum over the steps equals the integral (Euler-Maclaurin end
/// correction, dem.35). `step_fraction` is the time from touch to the first step, in steps.
/// Polynomial fit of Hurwitz's -zeta(-1/4, 1 + step_fraction), to 1.1e-4.
[[gnu::always_inline]] inline Lanes fourth_root_weight(const Lanes& step_fraction) {
  return 0.31709151755564424 +
         step_fraction *
             (0.8639717633735045 +
              step_fraction * (0.16417356305177494 - step_fraction * 0.028025128008455826));
}

/// Sum of the part of the force that is there at touch and the part that grows as a fourth root,
/// each with its weight.
[[gnu::always_inline]] inline Lanes weighted_force(const Lanes& full_force, const Lanes& jump_force,
                                                   const Lanes& root_weight,
                                                   const Lanes& jump_weight) {
  return root_weight * full_force + (jump_weight - root_weight) * jump_force;
}

/// Result of correct_transitions.
struct alignas(64) TransitionCorrection {
  LaneMask corrected{};       ///< lanes whose force is corrected
  Lanes initial_slip_time{};  ///< [s] where begun: initial tangential spring / slip velocity
  Lanes previous_force{};     ///< [N] normal force of the last step, where ended
};

/// Weights the first force of a contact so that the sum over the steps equals its integral
/// (dem.35). Where a contact has ended, `f` becomes the correction of its last force, which counted
/// for a whole step (dem.36).
template <class Law>
[[gnu::always_inline]] inline TransitionCorrection correct_transitions(
    const PairParameters& pair, const History& history, const ContactTransitions& transitions,
    const Lanes& overlap, const Lanes& rate, double time_step, contact::LawForce<Lanes>& f) {
  const Lanes zero{}, one = zero + 1.0,
                      overlap_change = time_step * select(transitions.ended, -rate, rate);
  const LaneMask overlap_changes = less(zero, overlap_change);
  const Lanes inverse_overlap_change = 1.0 / select(overlap_changes, overlap_change, one);
  // The onset overlap counts only where this step passes over it.
  Lanes onset_overlap = Law::template onset_overlap<Lanes>(history.law_history);
  onset_overlap =
      select(transitions.begun & less(onset_overlap, overlap_change), onset_overlap, zero);
  const Lanes edge_overlap = select(transitions.ended, -pair.pull_off_distance, onset_overlap);
  const Lanes steps_in_contact =
      inverse_overlap_change *
      select(transitions.ended, overlap + pair.pull_off_distance + overlap_change, overlap);
  const LaneMask partial_step = (transitions.begun & less(steps_in_contact, zero + 1.5)) |
                                (transitions.ended & less(zero - 0.5, steps_in_contact));
  const LaneMask corrected = partial_step & overlap_changes;
  const Lanes step_fraction =
      min(max(steps_in_contact, zero + 1e-9), one);  // in steps, from touch or to the end
  const Lanes force_overlap =
      select(transitions.ended, step_fraction * overlap_change - pair.pull_off_distance,
             max(overlap, onset_overlap));
  const auto evaluate_at = [&](const Lanes& where) {
    Lanes law_history[contact::law_history_size];
    for (int i = 0; i < contact::law_history_size; ++i) law_history[i] = history.law_history[i];
    return Law::template evaluate<Lanes>(pair.coefficients, law_history,
                                         select(corrected, where, zero),
                                         select(corrected, rate, zero));
  };
  const contact::LawForce<Lanes> full_force = evaluate_at(force_overlap),
                                 jump_force = evaluate_at(edge_overlap);
  const Lanes already_counted = select(transitions.ended, one, zero);  // whole step already counted
  const Lanes root_weight =
      fourth_root_weight(step_fraction) / sqrt(sqrt(step_fraction)) - already_counted;
  const Lanes jump_weight =
      0.5 + step_fraction - 0.5 * onset_overlap * inverse_overlap_change - already_counted;
  const auto correct = [&](const Lanes& a, const Lanes& b, Lanes& out) {
    out = select(corrected, weighted_force(a, b, root_weight, jump_weight), out);
  };
  correct(full_force.force, jump_force.force, f.force);
  correct(full_force.stiffness, jump_force.stiffness, f.stiffness);
  correct(full_force.damping, jump_force.damping, f.damping);
  correct(full_force.load, jump_force.load, f.load);
  return {corrected, select(corrected & transitions.begun, time_step * (step_fraction - 0.5), zero),
          select(corrected & transitions.ended, full_force.force, zero)};
}

}  // namespace mahlwerk::soft

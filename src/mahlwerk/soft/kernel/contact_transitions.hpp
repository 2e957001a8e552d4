// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/soft/kernel/contact_data.hpp"

// Contacts begin and end between two steps. The first and last force of a contact are corrected,
// because they do not act for a whole step (dem.35, dem.36).
namespace mahlwerk::soft {

/// Lanes whose contact begins in this step, or ended since the last step.
template <class V>
struct ContactTransitions {
  MaskOf<V> begun, ended;
};

/// Weight of the first force of a contact, times step_fraction^(1/4), for a force that grows as the
/// fourth root of the time since touch, as damping proportional to overlap^(1/4) does (Tsuji's
/// law). With this weight, the sum over the steps equals the integral (Euler-Maclaurin end
/// correction, dem.35). `step_fraction` is the time from touch to the first step, in steps.
/// Polynomial fit of Hurwitz's -zeta(-1/4, 1 + step_fraction), to 1.1e-4.
template <class V>
[[gnu::always_inline]] inline V fourth_root_weight(const V& step_fraction) {
  return 0.31709151755564424 +
         step_fraction *
             (0.8639717633735045 +
              step_fraction * (0.16417356305177494 - step_fraction * 0.028025128008455826));
}

/// The same weight for an elastic force, which grows with the overlap as t or t^(3/2) (dem.35). The
/// adhesive force of lanes that adhere grows as t, but at once next to its pull-off (JKR), where
/// the weight is bounded. Exact for t; for t^(3/2) a polynomial fit of Hurwitz's -zeta(-3/2, 1 +
/// step_fraction), to 9e-6.
template <class Law, class V>
[[gnu::always_inline]] inline V elastic_weight(const V& step_fraction, const MaskOf<V>& adheres) {
  const V s = select<V>(adheres, max(step_fraction, V{} + 0.02), step_fraction);
  const V linear = (0.5 * s * (s + 1.0) + 1.0 / 12) / s;
  if constexpr (Law::touch_exponent == contact::TouchExponent::one) {
    return linear;
  } else {
    const V polynomial =
        0.0254941970299688 +
        s * (0.3113754078497435 +
             s * (0.5514419661692912 + s * (0.15141145787596966 - s * 0.014244103851504217)));
    return select<V>(adheres, linear, polynomial / (s * sqrt(s)));
  }
}

/// Sum of the part of a force that is there at touch and the part that grows from there, each with
/// its weight.
template <class V>
[[gnu::always_inline]] inline V weighted_force(const V& full_force, const V& jump_force,
                                               const V& growth_weight, const V& jump_weight) {
  return growth_weight * full_force + (jump_weight - growth_weight) * jump_force;
}

/// Loads the coefficients of a group.
template <class V>
[[gnu::always_inline]] inline std::array<V, contact::law_coefficient_count> load_coefficients(
    const LaneGroup<V>& group, const PairParameters& pair) {
  static_assert(contact::law_coefficient_count == 8);
  const auto& k = pair.coefficients;
  return {group(k[0]), group(k[1]), group(k[2]), group(k[3]),
          group(k[4]), group(k[5]), group(k[6]), group(k[7])};
}

/// Result of correct_transitions.
template <class V>
struct TransitionCorrection {
  MaskOf<V> corrected{};  ///< lanes whose force is corrected
  V initial_slip_time{};  ///< [s] where begun: initial tangential spring / slip velocity
};

/// Weights the first force of a contact so that the sum over the steps equals its integral
/// (dem.35). Where a contact has ended, `f` becomes the correction of its last force, which counted
/// for a whole step (dem.36).
template <class Law, class V>
[[gnu::always_inline]] inline TransitionCorrection<V> correct_transitions(
    const LaneGroup<V>& group, const PairParameters& pair, const GroupHistory<V>& history,
    const ContactTransitions<V>& transitions, const V& overlap, const V& rate, double time_step,
    contact::LawForce<V>& f) {
  using Mask = MaskOf<V>;
  const V zero{}, one = zero + 1.0;
  const V overlap_change = time_step * select<V>(transitions.ended, -rate, rate);
  const V pull_off_distance = group(pair.pull_off_distance);
  const Mask overlap_changes = less(zero, overlap_change);
  const V inverse_overlap_change = 1.0 / select(overlap_changes, overlap_change, one);
  const auto k = load_coefficients<V>(group, pair);
  // The onset overlap counts only where this step passes over it.
  V onset_overlap = Law::template onset_overlap<V>(history.law_history);
  onset_overlap = where<V>(transitions.begun & less(onset_overlap, overlap_change), onset_overlap);
  const V edge_overlap = select<V>(transitions.ended, -pull_off_distance, onset_overlap);
  const V steps_in_contact =
      inverse_overlap_change *
      select<V>(transitions.ended, overlap + pull_off_distance + overlap_change, overlap);
  const Mask just_begun = both(transitions.begun, less(steps_in_contact, zero + 1.5)),
             just_ended = both(transitions.ended, less(zero - 0.5, steps_in_contact)),
             partial_step = just_begun | just_ended;
  const Mask corrected = partial_step & overlap_changes;
  const V step_fraction =
      min(max(steps_in_contact, zero + 1e-9), one);  // in steps, from touch or to the end
  const V overlap_now =
      select<V>(transitions.ended, step_fraction * overlap_change - pull_off_distance,
                max(overlap, step_fraction * overlap_change));
  const auto evaluate_at = [&](const V& at, const V& speed) {
    V own_history[contact::law_history_size]{history.law_history[0], history.law_history[1]};
    return Law::template evaluate<V>(k.data(), own_history, where<V>(corrected, at),
                                     where<V>(corrected, speed));
  };
  const contact::LawForce<V> full_force = evaluate_at(select<V>(transitions.ended, overlap_now,
                                                                max(overlap_now, onset_overlap)),
                                                      rate),
                             jump_force = evaluate_at(edge_overlap, rate);
  const V already_counted = where<V>(transitions.ended, one);  // whole step already counted
  const V root_weight =
      fourth_root_weight(step_fraction) / sqrt(sqrt(step_fraction)) - already_counted;
  const V jump_weight =
      0.5 + step_fraction - 0.5 * onset_overlap * inverse_overlap_change - already_counted;
  const auto correct = [&](const V& a, const V& b, V& out) {
    out = select<V>(corrected, weighted_force(a, b, root_weight, jump_weight), out);
  };
  // The elastic force is there without a rate, and has its own weight. A law without tension has
  // none where its damper has taken all of it.
  const Mask acts = less(zero, abs(full_force.force));
  const Mask adheres = less(zero, pull_off_distance);
  const V elastic = weighted_force(
      evaluate_at(overlap_now, zero).force,
      evaluate_at(select<V>(transitions.ended, -pull_off_distance, zero), zero).force,
      elastic_weight<Law>(step_fraction, adheres) - already_counted,
      0.5 + step_fraction - already_counted);
  correct(full_force.damper, jump_force.damper, f.damper);
  f.damper = select<V>(corrected, where<V>(acts, f.damper), f.damper);
  const V load_over_force = full_force.load - full_force.force;
  f.force = select<V>(corrected, where<V>(acts, elastic + f.damper), f.force);
  f.load = select<V>(corrected, f.force + jump_weight * load_over_force, f.load);
  correct(full_force.stiffness, jump_force.stiffness, f.stiffness);
  // At touch the tangential force grows as the elastic one, as its spring is loaded from there on.
  // Early in a step, where this force is none, the weight is bounded.
  f.stiffness = select<V>(
      corrected & transitions.begun,
      elastic_weight<Law>(max(step_fraction, zero + 0.02), adheres) * full_force.stiffness,
      f.stiffness);
  correct(full_force.damping, jump_force.damping, f.damping);
  return {corrected, where<V>(corrected & transitions.begun, time_step * (step_fraction - 0.5))};
}

}  // namespace mahlwerk::soft

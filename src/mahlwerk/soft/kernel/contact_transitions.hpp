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

/// -zeta(-1/4, 1 + since), Hurwitz's zeta, to 1.1e-4: the end correction of the Euler-Maclaurin sum
/// for a force that grows as the fourth root of the time since touch. `since` is the time from
/// touch to the first step, in steps. Divided by since^(1/4), it is the weight of the first force.
[[gnu::always_inline]] inline Lanes rooted_share(const Lanes& since) {
  return 0.31709151755564424 +
         since *
             (0.8639717633735045 + since * (0.16417356305177494 - since * 0.028025128008455826));
}

/// Weighted sum of the part that jumps at touch (`jump`, weight `jumped`) and the part that grows
/// as a fourth root (`whole` - `jump`, weight `rooted`).
[[gnu::always_inline]] inline Lanes mixed(const Lanes& whole, const Lanes& jump,
                                          const Lanes& rooted, const Lanes& jumped) {
  return rooted * whole + (jumped - rooted) * jump;
}

/// Result of correct_transitions.
struct alignas(64) TransitionCorrection {
  LaneMask counts{};  ///< lanes whose force is corrected
  Lanes lead{};       ///< [s] initial tangential spring over slip, where begun
  Lanes before{};     ///< [N] normal force of the last step, where ended
};

/// Replaces the forces `f` of contacts that begin or end by the force times its weight in steps.
template <class Law>
[[gnu::always_inline]] inline TransitionCorrection correct_transitions(
    const PairParameters& p, const History& past, const ContactTransitions& transitions,
    const Lanes& overlap, const Lanes& rate, double step, contact::LawForce<Lanes>& f) {
  const Lanes none{}, one = none + 1.0, way = step * select(transitions.ended, -rate, rate);
  const LaneMask moves = less(none, way);
  const Lanes per_way = 1.0 / select(moves, way, one);
  // The onset overlap counts only where this step passes over it.
  Lanes onset_overlap = Law::template onset_overlap<Lanes>(past.law_history);
  onset_overlap = select(transitions.begun & less(onset_overlap, way), onset_overlap, none);
  const Lanes edge = select(transitions.ended, -p.pull_off_distance, onset_overlap);
  const Lanes raw =
      per_way * select(transitions.ended, overlap + p.pull_off_distance + way, overlap);
  const LaneMask odd =
      (transitions.begun & less(raw, none + 1.5)) | (transitions.ended & less(none - 0.5, raw));
  const LaneMask counts = odd & moves;
  const Lanes since = min(max(raw, none + 1e-9), one);  // in steps, from touch or to the end
  const Lanes at =
      select(transitions.ended, since * way - p.pull_off_distance, max(overlap, onset_overlap));
  const auto evaluate_at = [&](const Lanes& where) {
    Lanes law_history[contact::law_history_size];
    for (int i = 0; i < contact::law_history_size; ++i) law_history[i] = past.law_history[i];
    return Law::template evaluate<Lanes>(p.coefficients, law_history, select(counts, where, none),
                                         select(counts, rate, none));
  };
  const contact::LawForce<Lanes> whole = evaluate_at(at), jump = evaluate_at(edge);
  const Lanes taken = select(transitions.ended, one, none);  // whole step already counted
  const Lanes rooted = rooted_share(since) / sqrt(sqrt(since)) - taken;
  const Lanes jumped = 0.5 + since - 0.5 * onset_overlap * per_way - taken;
  const auto mix = [&](const Lanes& a, const Lanes& b, Lanes& out) {
    out = select(counts, mixed(a, b, rooted, jumped), out);
  };
  mix(whole.force, jump.force, f.force);
  mix(whole.stiffness, jump.stiffness, f.stiffness);
  mix(whole.damping, jump.damping, f.damping);
  mix(whole.load, jump.load, f.load);
  return {counts, select(counts & transitions.begun, step * (since - 0.5), none),
          select(counts & transitions.ended, whole.force, none)};
}

}  // namespace mahlwerk::soft

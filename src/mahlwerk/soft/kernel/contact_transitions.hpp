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

/// since^(1/4) times the weight of the first force of a contact, for a force that grows as the
/// fourth root of time, as damping proportional to overlap^(1/4) does (Tsuji's law). With this
/// weight, the sum over the steps equals the integral (Euler-Maclaurin end correction, dem.35).
/// Polynomial fit of -zeta(-1/4, 1 + since), Hurwitz's zeta, to 1.1e-4; `since` is the time from
/// touch to the first step, in steps.
[[gnu::always_inline]] inline Lanes rooted_share(const Lanes& since) {
  return 0.31709151755564424 +
         since *
             (0.8639717633735045 + since * (0.16417356305177494 - since * 0.028025128008455826));
}

/// jumped * jump + rooted * (whole - jump): the part of the force that is there at touch, and the
/// part that grows as a fourth root.
[[gnu::always_inline]] inline Lanes mixed(const Lanes& whole, const Lanes& jump,
                                          const Lanes& rooted, const Lanes& jumped) {
  return rooted * whole + (jumped - rooted) * jump;
}

/// Result of correct_transitions.
struct alignas(64) TransitionCorrection {
  LaneMask counts{};  ///< lanes whose force is corrected
  Lanes lead{};       ///< [s] where begun: initial tangential spring / slip velocity
  Lanes before{};     ///< [N] normal force of the last step, where ended
};

/// Scales the first force of a contact by the number of steps for which it acts (dem.35). Where a
/// contact has ended, `f` becomes the correction of its last force, which counted for a whole step
/// (dem.36).
template <class Law>
[[gnu::always_inline]] inline TransitionCorrection correct_transitions(
    const PairParameters& p, const History& past, const ContactTransitions& transitions,
    const Lanes& overlap, const Lanes& rate, double step, contact::LawForce<Lanes>& f) {
  const Lanes none{}, one = none + 1.0, way = step * select(transitions.ended, -rate, rate);
  const LaneMask moves = less(none, way);
  const Lanes inverse_overlap_change = 1.0 / select(moves, way, one);
  // The onset overlap counts only where this step passes over it.
  Lanes onset_overlap = Law::template onset_overlap<Lanes>(past.law_history);
  onset_overlap = select(transitions.begun & less(onset_overlap, way), onset_overlap, none);
  const Lanes edge = select(transitions.ended, -p.pull_off_distance, onset_overlap);
  const Lanes raw = inverse_overlap_change *
                    select(transitions.ended, overlap + p.pull_off_distance + way, overlap);
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
  const Lanes jumped = 0.5 + since - 0.5 * onset_overlap * inverse_overlap_change - taken;
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

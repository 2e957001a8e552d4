// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/contact/damping.hpp"
#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Hertz's spring with the damper of Tsuji, Tanaka and Ishida (1992), the same along and across the
/// normal (dem.10). The bodies never pull: the contact ends when the force does, and the damping
/// is solved for that end, so that e is exact.
struct HertzTsuji : HertzSpring {
  static constexpr std::string_view name = "hertz-tsuji";
  static constexpr std::string_view about =
      "Hertz's spring with Tsuji's damper along and across, never pulls";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{0.3, 0.15, 0.45},
                                           {0.3, 0.38, 1.3},
                                           {0.3, 0.22, 0.7},
                                           {0.25, 0.18, 0.6},
                                           {0.15, 0.22, 0.75},
                                           {0.08, 0.2, 0.65},
                                           {0.06, 0.1, 0.35}}};
  static constexpr auto fields() { return std::array<LawField<HertzTsuji>, 0>{}; }

  double damping(double e) const { return tensionless_damping(std::max(e, least_restitution)); }
  /// The dimensionless damper is in units of sqrt(m* k).
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double k = hertz_stiffness(t);
    return {k, damping * std::sqrt(t.mass * k), mindlin_stiffness(t)};
  }

  double largest_overlap(const EffectivePair& t, double speed) const {
    return hertz_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  /// Across the normal, where the bodies turn, too: 2/7 of the mass.
  double damper_time(const EffectivePair& t, double damping, double speed) const {
    const double k = hertz_stiffness(t), quarter = std::pow(hertz_overlap(t, speed), 0.25);
    return damping > 0 ? 2.0 / 7.0 * std::sqrt(t.mass / k) / (damping * quarter) : unbounded_time;
  }

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V*, V overlap, V rate) {
    const V half = sqrt(overlap), damping = k[1] * sqrt(half);
    const V force = max(k[0] * overlap * half + damping * rate, V{});
    const auto pushes = less(V{}, force);  // in the tail without force nothing rubs either
    return {force, select(pushes, k[2] * half, V{}), select(pushes, damping, V{}), force};
  }
  bool operator==(const HertzTsuji&) const = default;
};

}  // namespace mahlwerk::contact

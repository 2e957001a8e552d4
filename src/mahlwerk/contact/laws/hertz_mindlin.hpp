// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Hertz-Mindlin (no-slip) law, damped so that the restitution does not depend on speed: Mhadhbi
/// 2021 eqs. 3 to 10 as corrected (dem.5 to dem.7; Tsuji 1992, LIGGGHTS, EDEM). The contact ends at
/// zero overlap. Shortly before, the force is attractive; with that tail e is exact.
struct HertzMindlin : HertzSpring {
  static constexpr std::string_view name = "hertz-mindlin";
  static constexpr std::string_view about =
      "elastic spheres with sticking and sliding friction; one restitution at all speeds";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{0.98, 0.09, 0.3, 1.44},
                                           {0.33, 0.12, 0.4, 0.81},
                                           {0.14, 0.21, 0.71, 1.25},
                                           {0.05, 0.16, 0.54, 1.26},
                                           {0.06, 0.14, 0.47, 1.99},
                                           {0.02, 0.18, 0.63, 2.18},
                                           {0.01, 0.22, 0.77, 1.53}}};
  static constexpr auto fields() { return std::array<LawField<HertzMindlin>, 0>{}; }

  double damping(double e) const { return -2 * std::sqrt(5.0 / 6.0) * damping_ratio(e); }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double tangential = mindlin_stiffness(t);
    return {hertz_stiffness(t),
            damping * std::sqrt(2 * t.pair.modulus * std::sqrt(t.radius) * t.mass), tangential,
            damping * std::sqrt(tangential * t.mass)};
  }

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V*, V overlap, V rate) {
    const V half = sqrt(overlap), quarter = sqrt(half);
    const V damper = k[1] * quarter * rate, force = k[0] * overlap * half + damper;
    return {force, k[2] * half, k[3] * quarter, force, damper, 1.5 * k[0] * half};
  }

  double largest_overlap(const EffectivePair& t, double speed) const {
    return hertz_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  bool operator==(const HertzMindlin&) const = default;
};

}  // namespace mahlwerk::contact

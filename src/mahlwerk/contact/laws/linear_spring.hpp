// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/spring.hpp"

namespace mahlwerk::contact {

/// Linear spring and dashpot, normal and tangential (Cundall and Strack 1979). The contact ends at
/// zero overlap. Shortly before, the force is attractive; with that tail e is exact.
struct LinearSpring : Spring {
  static constexpr std::string_view name = "linear-spring";
  static constexpr std::string_view about = "linear spring and dashpot along and across the normal";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{1.07, 0.09, 0.4, 1.2},
                                           {0.23, 0.09, 0.31, 1.13},
                                           {0.21, 0.12, 0.39, 1.51},
                                           {0.36, 0.14, 0.47, 1.71},
                                           {0.29, 0.17, 0.59, 1.46},
                                           {0.01, 0.03, 0.08, 0.67},
                                           {0.01, 0.05, 0.16, 0.67}}};
  static constexpr auto fields() { return spring_fields<LinearSpring>(); }

  double damping(double e) const { return -2 * damping_ratio(e); }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double k = stiffness_of(t), c = damping * std::sqrt(t.mass * k);
    return {k, c, tangential_stiffness_ratio * k, tangential_stiffness_ratio * c};
  }
  void begin(const LawCoefficients&, double*, double) const {}

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V*, V overlap, V rate) {
    const V damper = k[1] * rate, force = k[0] * overlap + damper;
    return {force, k[2], k[3], force, damper, k[0]};
  }

  double elastic_energy(const LawCoefficients& k, const double*, double overlap) const {
    return overlap > 0 ? 0.5 * k[0] * overlap * overlap : 0;
  }
  double largest_overlap(const EffectivePair& t, double speed) const {
    return undamped_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double) const {
    return std::numbers::pi * std::sqrt(t.mass / stiffness_of(t));
  }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  bool operator==(const LinearSpring&) const = default;
};

}  // namespace mahlwerk::contact

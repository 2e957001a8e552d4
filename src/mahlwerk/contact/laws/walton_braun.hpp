// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/contact/spring.hpp"

namespace mahlwerk::contact {

/// Walton and Braun (1986): hysteretic spring. Loading along k1, unloading along the stiffer
/// k2 = k1 / e^2 (dem.13); the area of the loop is the dissipated energy. The contact ends at zero
/// force, where the plastic overlap is > 0. The law discards the plastic overlap when the bodies
/// separate.
struct WaltonBraun : Spring {
  static constexpr std::string_view name = "walton-braun";
  static constexpr std::string_view about =
      "linear spring, stiffer on unloading: the hysteresis loop dissipates plastic work";
  static constexpr std::string_view shortest_time_name =
      "a collision along the stiff line of unloading";
  static constexpr StepErrors step_errors{{{0.01, 0.01, 0.02, 0.32},
                                           {0.01, 0.01, 0.03, 0.59},
                                           {0.01, 0.02, 0.05, 0.89},
                                           {0.01, 0.03, 0.08, 1.54},
                                           {0.01, 0.03, 0.11, 1.73},
                                           {0.01, 0.03, 0.09, 0.97},
                                           {0.01, 0.04, 0.12, 0.36}}};
  static constexpr bool has_history = true;
  static constexpr auto fields() { return spring_fields<WaltonBraun>(); }

  double damping(double e) const {
    const double least = std::max(e, min_restitution);
    return 1 / (least * least);
  }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double k = stiffness_of(t);
    return {k, k * damping, 1 - 1 / damping, tangential_stiffness_ratio * k};
  }
  void begin(const LawCoefficients&, double* m, double) const { m[0] = 0; }  // [m] largest overlap

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V* m, V overlap, V) {
    m[0] = max(m[0], overlap);
    const V force = max(min(k[0] * overlap, k[1] * (overlap - k[2] * m[0])), V{});
    return {force, select(less(V{}, force), k[3], V{}), V{}, force};
  }

  /// Area of the loop of loading and unloading (dem.13).
  template <class V>
  [[gnu::always_inline]] static V plastic_energy(const V* k, const V* m) {
    return 0.5 * k[0] * k[2] * m[0] * m[0];
  }
  double elastic_energy(const LawCoefficients& k, const double* m, double overlap) const {
    const double left = overlap - k[2] * m[0];
    return left > 0 ? 0.5 * k[1] * left * left : 0;
  }
  double largest_overlap(const EffectivePair& t, double speed) const {
    return undamped_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double) const {
    const double stiffest = stiffness_of(t) * damping(t.pair.restitution);
    return std::numbers::pi * std::sqrt(t.mass / stiffest);
  }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  bool operator==(const WaltonBraun&) const = default;
};

}  // namespace mahlwerk::contact

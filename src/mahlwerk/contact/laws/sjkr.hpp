// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"

namespace mahlwerk::contact {

/// Hertz-Mindlin with a simplified cohesion proportional to the contact area 2 pi overlap times
/// 2 R* (SJKR2 of LIGGGHTS; dem.17). The load of friction excludes the cohesion.
struct Sjkr : HertzSpring {
  static constexpr std::string_view name = "sjkr";
  static constexpr std::string_view about =
      "Hertz-Mindlin with a cohesion proportional to the contact area";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors = HertzMindlin::step_errors;  // same dampers and friction
  /// Cohesion grows in proportion to the overlap.
  static constexpr TouchExponent touch_exponent = TouchExponent::one;
  static constexpr std::array adhesion{cohesion};
  static constexpr auto fields() { return std::array<LawField<Sjkr>, 0>{}; }

  double damping(double e) const { return HertzMindlin().damping(e); }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    LawCoefficients k = HertzMindlin().coefficients(t, damping);
    k[4] = cohesion_stiffness(t);
    return k;
  }
  /// Cohesive force over overlap [N/m].
  static double cohesion_stiffness(const EffectivePair& t) {
    return 4 * std::numbers::pi * t.radius * t.pair.cohesion;
  }

  /// Overlap d of an undamped collision, (2/5) k d^2.5 - k_c d^2/2 = m v^2/2. Solved for the square
  /// root of d by Newton iteration from above, where the left side is convex.
  double largest_overlap(const EffectivePair& t, double speed) const {
    const double hertz = std::sqrt(hertz_overlap(t, speed));
    const double wider = 1.25 * cohesion_stiffness(t) / hertz_stiffness(t);
    double root = hertz + wider;
    for (int i = 0; i < 40 && root > 0; ++i) {
      const double cubed = root * root * root;
      const double off = root * cubed * (root - wider) - math::pow(hertz, 5);
      root -= off / (cubed * (5 * root - 4 * wider));
    }
    return root * root;
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V* m, V overlap, V rate) {
    LawForce<V> p = HertzMindlin::evaluate(k, m, overlap, rate);
    p.force = p.force - k[4] * overlap;
    return p;
  }

  double elastic_energy(const LawCoefficients& k, const double*, double overlap) const {
    if (!(overlap > 0)) return 0;
    return hertz_energy(k[0], overlap) - 0.5 * k[4] * overlap * overlap;
  }
  bool operator==(const Sjkr&) const = default;
};

}  // namespace mahlwerk::contact

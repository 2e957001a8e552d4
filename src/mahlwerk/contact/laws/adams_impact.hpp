// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/damping.hpp"
#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Impact function of MSC Adams, Mhadhbi 2021 eqs. 17 to 23 as corrected (dem.14, dem.15): a Hertz
/// spring, and a damper that rises from 0 to c_m over the depth d. The force is never attractive.
/// c_m depends on the speed at touch. c_m is either solved for the requested e, or the paper's
/// estimate, which misses e (physics of Mhadhbi 2021, errata S1-17 to S1-23). Tangential: Mindlin's
/// spring, undamped.
struct AdamsImpact : HertzSpring {
  static constexpr std::string_view name = "adams-impact";
  static constexpr std::string_view about =
      "impact function of MSC Adams: Hertz spring, damper that grows with the overlap";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{0.49, 0.48, 1.82, 3.9},
                                           {0.09, 0.54, 1.69, 3.35},
                                           {0.05, 0.21, 0.72, 2.32},
                                           {0.01, 0.14, 0.49, 1.95},
                                           {0.02, 0.21, 0.73, 2.12},
                                           {0.04, 0.22, 0.76, 2.86},
                                           {0.01, 0.21, 0.72, 1.57}}};
  static constexpr bool has_history = true;
  static constexpr double usual_depth = 0.01;  // fraction of the largest overlap
  bool published_damping = false;  ///< the paper's estimate (dem.15) instead of the solution for e
  double damping_depth = 0;        ///< [m] d; 0: usual_depth of the largest overlap
  static constexpr auto switches() {
    return std::array{LawSwitch<AdamsImpact>{
        "damping",
        {"exact", "published"},
        &AdamsImpact::published_damping,
        "gives the requested restitution",
        "how the damper follows from the restitution",
        {"solved for the restitution (dem.14)", "estimate of the paper, misses the restitution"}}};
  }
  static constexpr auto fields() {
    return std::array{LawField<AdamsImpact>{{"damping_depth",
                                             "m",
                                             &AdamsImpact::damping_depth,
                                             positive,
                                             "the overlap at which the damper is fully on",
                                             {},
                                             "a larger depth weakens the damper"},
                                            "",
                                            "a hundredth of the largest overlap"}};
  }

  /// In units of sqrt(m* k*), k* the ratio of largest force and largest overlap (dem.15).
  double damping(double e) const {
    if (published_damping) return -2 * damping_ratio(e);
    return stepped_damping(std::max(e, min_restitution), usual_depth * scale) / root_of_scale;
  }
  double largest_overlap(const EffectivePair& t, double speed) const {
    return hertz_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  double damper_time(const EffectivePair& t, double damping, double speed) const {
    double law_history[law_history_size];
    begin(coefficients(t, damping), law_history, speed);
    return damping > 0 ? t.mass / law_history[0] : unbounded_time;
  }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double k = hertz_stiffness(t);
    return {k, damping * std::sqrt(t.mass * k), mindlin_stiffness(t),
            math::pow(1.25 * t.mass / k, 0.4), damping_depth};
  }
  /// History variables: the damper c_m [N s/m] and 1/d [1/m].
  void begin(const LawCoefficients& k, double* m, double approach) const {
    const double deepest = k[3] * math::pow(std::max(approach, 1e-12), 0.8);
    m[0] = k[1] * std::sqrt(std::sqrt(deepest));
    m[1] = 1 / (k[4] > 0 ? k[4] : usual_depth * deepest);
  }

  /// The damper has full strength at the depth d.
  template <class V>
  [[gnu::always_inline]] static V onset_overlap(const V* m) {
    return 1.0 / m[1];
  }
  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V* m, V overlap, V rate) {
    const V half = sqrt(overlap), s = min(overlap * m[1], V{} + 1.0);
    const V elastic = k[0] * overlap * half;
    const V force = max(elastic + m[0] * s * s * (3.0 - 2.0 * s) * rate, V{});
    return {force,
            select(less(V{}, force), k[2] * half, V{}),
            V{},
            force,
            force - elastic,
            1.5 * k[0] * half};
  }
  bool operator==(const AdamsImpact&) const = default;

 private:
  // In units where m = k = v = 1 the largest overlap is (5/4)^(2/5), and k* its square root.
  static constexpr double scale = 1.0933620739432502;          // (5/4)^(2/5)
  static constexpr double root_of_scale = 1.0225651825635728;  // (5/4)^(1/10): sqrt(k*)
};

}  // namespace mahlwerk::contact

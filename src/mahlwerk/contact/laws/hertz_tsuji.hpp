// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/damping.hpp"
#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Hertz spring with the damper of Tsuji, Tanaka and Ishida (1992), with the same normal and
/// tangential damping (dem.10). The force is never attractive: the contact ends at zero force. The
/// damping is solved for that end, so e is exact.
struct HertzTsuji : HertzSpring {
  static constexpr std::string_view name = "hertz-tsuji";
  static constexpr std::string_view about =
      "Hertz spring with Tsuji's damper along and across the normal, never attractive";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{0.36, 0.14, 0.47, 1.02},
                                           {0.2, 0.28, 0.97, 1.83},
                                           {0.12, 0.2, 0.7, 1.28},
                                           {0.05, 0.17, 0.57, 1.34},
                                           {0.03, 0.14, 0.47, 1.67},
                                           {0.04, 0.16, 0.53, 2.8},
                                           {0.01, 0.22, 0.75, 1.42}}};
  static constexpr auto fields() { return std::array<LawField<HertzTsuji>, 0>{}; }

  double damping(double e) const { return tensionless_damping(std::max(e, min_restitution)); }
  /// `damping` has the unit sqrt(m* k).
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const double k = hertz_stiffness(t);
    return {k, damping * std::sqrt(t.mass * k), mindlin_stiffness(t)};
  }

  double largest_overlap(const EffectivePair& t, double speed) const {
    return hertz_overlap(t, speed);
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  /// For tangential motion, which is the faster one: the bodies also spin, so the effective mass is
  /// 2/7, or one over the slip factor.
  double damper_time(const EffectivePair& t, double damping, double speed) const {
    const double k = hertz_stiffness(t), quarter = math::pow(hertz_overlap(t, speed), 0.25);
    return damping > 0 ? 1 / t.slip_factor * std::sqrt(t.mass / k) / (damping * quarter)
                       : unbounded_time;
  }

  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V*, V overlap, V rate) {
    const V half = sqrt(overlap), damping = k[1] * sqrt(half);
    const V elastic = k[0] * overlap * half, force = max(elastic + damping * rate, V{});
    const auto pushes = less(V{}, force);  // no friction in the tail without normal force
    return {force,
            select(pushes, k[2] * half, V{}),
            select(pushes, damping, V{}),
            force,
            force - elastic,
            1.5 * k[0] * half};
  }
  bool operator==(const HertzTsuji&) const = default;
};

}  // namespace mahlwerk::contact

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"

namespace mahlwerk::contact {

/// JKR, Johnson, Kendall and Roberts (1971): adhesive elastic spheres (dem.16), with the dampers of
/// Hertz-Mindlin. A contact begins at touch and ends at the pull-off distance beyond touch. The
/// load of friction is the normal force plus twice the pull-off force.
struct Jkr : HertzSpring {
  static constexpr std::string_view name = "jkr";
  static constexpr std::string_view about =
      "Johnson, Kendall and Roberts: elastic spheres with adhesive surfaces";
  static constexpr std::string_view shortest_time_name = whole_collision;
  static constexpr StepErrors step_errors{{{0.87, 0.09, 0.31, 1.39},
                                           {0.24, 0.12, 0.4, 0.7},
                                           {0.08, 0.2, 0.68, 1.19},
                                           {0.03, 0.15, 0.53, 1.24},
                                           {0.03, 0.13, 0.46, 2.05},
                                           {0.03, 0.19, 0.64, 2.34},
                                           {0.01, 0.23, 0.79, 1.29}}};
  static constexpr std::array adhesion{surface_energy};
  static constexpr auto fields() { return std::array<LawField<Jkr>, 0>{}; }

  double damping(double e) const { return HertzMindlin().damping(e); }
  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    const LawCoefficients h = HertzMindlin().coefficients(t, damping);
    const double root_r = std::sqrt(t.radius);
    const double pull = 2 * std::sqrt(std::numbers::pi * t.pair.surface_energy / t.pair.modulus);
    return {h[0] / root_r,     h[1] / std::sqrt(root_r),
            h[2] / root_r,     h[3] / std::sqrt(root_r),
            t.radius,          pull,
            pull_off_force(t), math::cbrt(t.radius * pull)};
  }

  /// Contact radius [m]: solves l^4 / R* - c l = overlap for its square root l. Newton iteration
  /// from above, where the left side is convex, so that l falls until rounding ends it. A lane that
  /// has ended stays as it is while others go on: its bits do not depend on them. 24 iterations
  /// end it also near pull-off, where they only halve the error.
  template <class V>
  [[gnu::always_inline]] static V contact_radius(const V* k, V overlap) {
    const V least = k[4] * k[5] * 0.25;  // l^3 at pull-off
    V l = sqrt(sqrt(k[4] * max(overlap, V{}))) + k[7] + 1e-300;
    for (int i = 0; i < 24; ++i) {
      const V l3 = l * l * l;
      const V slope = max(4.0 * (l3 - least), 1e-6 * l3);
      const V next = max(l - (l3 * l - k[4] * (k[5] * l + overlap)) / slope, V{});
      if (!any(next < l)) break;
      l = min(l, next);
    }
    return l * l;
  }
  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V*, V overlap, V rate) {
    const V a = contact_radius(k, overlap), half = sqrt(a);
    // F = 4 E* a^3 / (3 R*) - 2 pi a^2 sqrt(4 gamma E* / (pi a)) = (4/3) E* a (a^2/R* - 1.5 c l)
    const V elastic = k[0] * a * (a * a / k[4] - 1.5 * k[5] * half);
    const V damper = k[1] * half * rate, force = elastic + damper;
    // The slope is that without adhesion: 2 E* a.
    return {force, k[2] * a, k[3] * half, force + 2.0 * k[6], damper, 1.5 * k[0] * a};
  }

  /// Adds the overlap of two bodies at rest, where the spring balances the adhesion:
  /// a^3 = 6 pi (2 gamma) R*^2 times 3/(4 E*).
  double largest_overlap(const EffectivePair& t, double speed) const {
    const double a = math::cbrt(9 * std::numbers::pi * t.pair.surface_energy * t.radius * t.radius /
                                t.pair.modulus);
    return hertz_overlap(t, speed) + a * a / (3 * t.radius);
  }
  double shortest_time(const EffectivePair& t, double speed) const { return hertz_time(t, speed); }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  static double pull_off_force(const EffectivePair& t) {
    return 3 * std::numbers::pi * t.pair.surface_energy * t.radius;
  }
  double pull_off_distance(const EffectivePair& t) const {
    const double a = math::cbrt(std::numbers::pi * t.pair.surface_energy * t.radius * t.radius /
                                (4 * t.pair.modulus));
    return 3 * a * a / t.radius;
  }
  /// Work done against the elastic force since touch; 0 at touch.
  double elastic_energy(const LawCoefficients& k, const double*, double overlap) const {
    const auto from_none = [&](double at) {  // integral of F d(overlap) over the contact radius
      const double a = contact_radius(k.data(), at), l = std::sqrt(a), r = k[4], c = k[5];
      const double a5 = a * a * a * a * a;
      return k[0] * (0.4 * a5 / (r * r) - c * a * a * a * l / r + 0.375 * c * c * a * a);
    };
    return from_none(overlap) - from_none(0);
  }
  bool operator==(const Jkr&) const = default;
};

}  // namespace mahlwerk::contact

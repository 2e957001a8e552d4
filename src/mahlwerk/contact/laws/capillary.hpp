// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"

namespace mahlwerk::contact {

/// Hertz-Mindlin with a capillary bridge: Willett et al. (2000), their closed form for small
/// bridges between equal spheres, with Derjaguin's radius for unequal ones (brg.1 to brg.3). A
/// bridge forms at touch and breaks at the rupture distance of Lian et al. (1993) (brg.4). The load
/// of friction excludes the capillary force.
struct Capillary : HertzSpring {
  static constexpr std::string_view name = "capillary";
  static constexpr std::string_view about =
      "Hertz-Mindlin with a liquid bridge that forms at touch and ruptures beyond";
  static constexpr std::string_view shortest_time_name =
      "the shortest collision, or passage of a bridge";
  /// Above those of Hertz-Mindlin: a bridge keeps the contact alive where the damper ends, so that
  /// its end is not corrected (dem.36).
  static constexpr StepErrors step_errors{{{0.99, 0.09, 0.3, 2.67},
                                           {0.38, 0.12, 0.42, 2.07},
                                           {0.15, 0.21, 0.73, 1.38},
                                           {0.05, 0.16, 0.53, 1.3},
                                           {0.06, 0.14, 0.47, 2.7},
                                           {0.02, 0.19, 0.66, 3.42},
                                           {0.01, 0.22, 0.77, 1.25}}};
  static constexpr std::array adhesion{surface_tension};
  double contact_angle = 0;     ///< [rad] of the liquid on both bodies
  double bridge_ratio = 0.001;  ///< [1] volume of a bridge over the cube of 2 R*
  double bridge_volume = 0;     ///< [m3] of every bridge; 0: from bridge_ratio

  static constexpr auto fields() {
    return std::array{
        LawField<Capillary>{{"contact_angle", "rad", &Capillary::contact_angle,
                             Range{.least = 0, .most = 0.5 * std::numbers::pi},
                             "angle between liquid and surface; 0: the liquid wets it", 0.0,
                             "a liquid that wets both bodies"}},
        LawField<Capillary>{{"bridge_ratio", "", &Capillary::bridge_ratio,
                             Range{.least = 0, .most = 0.1, .without_least = true},
                             "volume of a bridge over the cube of 2 R*, the radius of equal balls",
                             0.001, "uncalibrated; pendular bridges 1e-5-0.01"}},
        LawField<Capillary>{
            {"bridge_volume", "m3", &Capillary::bridge_volume, positive, "volume of every bridge"},
            "bridge_ratio"}};
  }

  double damping(double e) const { return HertzMindlin().damping(e); }
  /// Volume of a bridge [m3].
  double volume(const EffectivePair& t) const {
    const double r = 2 * t.radius;
    return bridge_volume > 0 ? bridge_volume : bridge_ratio * r * r * r;
  }
  /// Largest attraction [N], that at touch (brg.1).
  double attraction(const EffectivePair& t) const {
    return 4 * std::numbers::pi * t.radius * t.pair.surface_tension * math::cos(contact_angle);
  }
  double pull_off_distance(const EffectivePair& t) const {
    return attraction(t) > 0 ? (1 + 0.5 * contact_angle) * math::cbrt(volume(t)) : 0;  // (brg.4)
  }

  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    LawCoefficients k = HertzMindlin().coefficients(t, damping);
    k[4] = attraction(t);
    k[5] = std::sqrt(2 * t.radius / volume(t));
    return k;
  }
  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V* m, V overlap, V rate) {
    LawForce<V> p = HertzMindlin::evaluate(k, m, max(overlap, V{}), rate);
    const V gap = k[5] * max(-overlap, V{});  // (brg.3)
    p.force = p.force - k[4] / (1.0 + gap * (linear + square * gap));
    return p;
  }
  /// Work done against spring and bridge since touch (brg.5); 0 at touch.
  double elastic_energy(const LawCoefficients& k, const double*, double overlap) const {
    if (overlap >= 0) return hertz_energy(k[0], overlap) - k[4] * overlap;
    const double root = std::sqrt(4 * square - linear * linear);
    const auto angle = [&](double gap) { return math::atan2(2 * square * gap + linear, root); };
    return 2 * k[4] / (k[5] * root) * (angle(-k[5] * overlap) - angle(0));
  }

  /// Overlap d of an undamped collision, (2/5) k d^2.5 - F_0 d = m v^2/2. Solved for the square
  /// root of d by Newton iteration from above, where the left side is convex.
  double largest_overlap(const EffectivePair& t, double speed) const {
    const double stiffness = 0.4 * hertz_stiffness(t), pull = attraction(t),
                 energy = 0.5 * t.mass * speed * speed;
    double root =
        std::max(math::pow(2 * energy / stiffness, 0.2), math::cbrt(2 * pull / stiffness));
    for (int i = 0; i < 40 && root > 0; ++i) {
      const double squared = root * root;
      const double off = squared * (stiffness * squared * root - pull) - energy;
      root -= off / (root * (5 * stiffness * squared * root - 2 * pull));
    }
    return root * root;
  }
  double shortest_time(const EffectivePair& t, double speed) const {
    const double collision = hertz_time(t, speed), reach = pull_off_distance(t);
    return reach > 0 ? std::min(collision, reach / speed) : collision;
  }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  bool operator==(const Capillary&) const = default;

 private:
  static constexpr double linear = 1.05, square = 2.5;  // of Willett's closed form (brg.2)
};

}  // namespace mahlwerk::contact

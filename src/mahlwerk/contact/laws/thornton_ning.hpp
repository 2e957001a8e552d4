// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/laws/hertz_mindlin.hpp"

namespace mahlwerk::contact {

/// Thornton (1997), Thornton and Ning (1998) without adhesion: elastic-plastic spheres (epl.1 to
/// epl.6). Hertz up to the contact yield pressure p_y; above it the pressure is cut off at p_y and
/// the force grows linearly; unloading and reloading follow a Hertz curve of larger radius, from a
/// plastic overlap on. The law discards the plastic overlap when the bodies separate. Dampers are
/// those of Hertz-Mindlin for the radius of the contact; without them (e = 1) the restitution is
/// (epl.7).
struct ThorntonNing : HertzSpring {
  static constexpr std::string_view name = "thornton-ning";
  static constexpr std::string_view about =
      "elastic-plastic spheres: above a yield speed the restitution falls with the speed";
  static constexpr std::string_view shortest_time_name =
      "a collision along the stiff curve of unloading";
  static constexpr StepErrors step_errors{{{1.12, 0.08, 0.27, 2.69},
                                           {0.49, 0.07, 0.21, 2.09},
                                           {0.28, 0.1, 0.34, 1.73},
                                           {0.19, 0.1, 0.34, 1.5},
                                           {0.12, 0.08, 0.28, 2.54},
                                           {0.05, 0.09, 0.29, 1.68},
                                           {0.01, 0.19, 0.63, 1.21}}};
  static constexpr bool has_history = true;
  double yield_pressure = 0;  ///< [Pa] p_y of all pairs; 0: from the hardness of each pair

  static constexpr auto fields() {
    return std::array{LawField<ThorntonNing>{
        {"yield_pressure",
         "Pa",
         &ThorntonNing::yield_pressure,
         positive,
         "largest pressure in a contact, at which the softer body yields",
         {},
         "first yield at 1.6 times the yield strength, which is the hardness over 2.8 (epl.8)"},
        "",
        "0.57 times the Vickers hardness of the softer body"}};
  }

  double damping(double e) const { return HertzMindlin().damping(e); }
  /// p_y [Pa] (epl.8); infinite for a pair without hardness. Softer moduli need a lower p_y for the
  /// same yield speed (epl.9).
  double yield_pressure_of(const EffectivePair& t) const {
    constexpr double first_yield = 1.6, tabor = 2.8;
    const double given =
        yield_pressure > 0 ? yield_pressure : first_yield / tabor * t.pair.hardness;
    if (!(given > 0)) return std::numeric_limits<double>::infinity();
    return given * math::pow(t.pair.softening, 0.8);
  }
  /// Overlap [m] at first yield (epl.1).
  double yield_overlap(const EffectivePair& t) const {
    const double radius_over_overlap =
        0.5 * std::numbers::pi * yield_pressure_of(t) / t.pair.modulus;
    return radius_over_overlap * radius_over_overlap * t.radius;
  }
  /// Impact speed [m/s] at first yield (epl.2); infinite for a pair that never yields.
  double yield_speed(const EffectivePair& t) const {
    const double d = yield_overlap(t);
    return std::isfinite(d) ? std::sqrt(2 * hertz_energy(hertz_stiffness(t), d) / t.mass) : d;
  }

  LawCoefficients coefficients(const EffectivePair& t, double damping) const {
    LawCoefficients k = HertzMindlin().coefficients(t, damping);
    k[4] = yield_overlap(t);
    return k;
  }
  void begin(const LawCoefficients&, double* m, double) const { m[0] = 0; }  // [m] largest overlap

  /// Flattening q <= 1 of the bodies after a largest overlap (epl.4): R*/q is the radius of the
  /// unloading curve, 1 - q the plastic part of that overlap.
  template <class V>
  [[gnu::always_inline]] static V flattening(const V* k, V largest) {
    const V root = sqrt(min(k[4] / max(largest, V{} + 1e-300), V{} + 1.0));
    return 0.5 * root * (3.0 - root * root);
  }
  template <class V>
  [[gnu::always_inline]] static LawForce<V> evaluate(const V* k, V* m, V overlap, V rate) {
    m[0] = max(m[0], overlap);
    const V q = flattening(k, m[0]);
    const V elastic = max(overlap - (1.0 - q) * m[0], V{});
    const V half = sqrt(elastic / q), quarter = sqrt(half);  // of the contact radius
    const V damper = k[1] * quarter * rate, force = k[0] * elastic * half + damper;
    return {force, k[2] * half, k[3] * quarter, force, damper, 1.5 * k[0] * half};
  }

  /// Work of loading up to the largest overlap, less what unloading gives back: per k d_y^2.5 of
  /// first yield and with u = d_max/d_y > 1, 2/5 + (u - 1) + 3/4 (u - 1)^2 - (2/5) q^2 u^2.5.
  template <class V>
  [[gnu::always_inline]] static V plastic_energy(const V* k, const V* m) {
    const V yield = min(k[4], V{} + 1e3), beyond = max(m[0] - yield, V{});  // [m]
    const V q = flattening(k, m[0]), most = max(m[0], yield), root = sqrt(yield);
    const V loading = yield * (yield * (0.4 * root)) + beyond * root * (yield + 0.75 * beyond);
    const V unloading = 0.4 * q * q * most * most * sqrt(most);
    return where<V>(less(V{}, beyond), k[0] * (loading - unloading));
  }
  double elastic_energy(const LawCoefficients& k, const double* m, double overlap) const {
    const double q = flattening(k.data(), m[0]);
    const double elastic = std::max(overlap - (1 - q) * m[0], 0.0);
    return 0.4 * k[0] * elastic * elastic * std::sqrt(elastic / q);
  }
  double largest_overlap(const EffectivePair& t, double speed) const {
    const double ratio = speed / yield_speed(t);
    if (!(ratio > 1)) return hertz_overlap(t, speed);
    return yield_overlap(t) *
           (1.0 / 3 + std::sqrt(8.0 / 15 * ratio * ratio - 4.0 / 45));  // (epl.5)
  }
  /// Restitution [1] of undamped bodies at `speed` [m/s] (epl.7).
  double restitution(const EffectivePair& t, double speed) const {
    const double ratio = yield_speed(t) / speed;
    if (!(ratio < 1)) return 1;
    const double squared = ratio * ratio;
    const double last = ratio / (ratio + 2 * std::sqrt(1.2 - 0.2 * squared));
    return std::sqrt(1.2 * std::numbers::sqrt3 * (1 - squared / 6) * std::sqrt(last));
  }
  /// Twice the time of unloading: that of a Hertz collision on the curve of unloading (epl.6).
  double shortest_time(const EffectivePair& t, double speed) const {
    const double ratio = speed / yield_speed(t);
    if (!(ratio > 1)) return hertz_time(t, speed);
    const double k[law_coefficient_count]{0, 0, 0, 0, yield_overlap(t)};
    const double most = largest_overlap(t, speed);
    return hertz_duration * flattening(k, most) * most / (restitution(t, speed) * speed);
  }
  double damper_time(const EffectivePair&, double, double) const { return unbounded_time; }
  bool operator==(const ThorntonNing&) const = default;
};

}  // namespace mahlwerk::contact

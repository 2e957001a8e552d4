// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/law.hpp"

// Hertz contact of elastic spheres (Hertz 1881): common parts of the laws built on it.
namespace mahlwerk::contact {

/// Hertz stiffness k [N/m^1.5], F = k overlap^1.5 (dem.5).
inline double hertz_stiffness(const EffectivePair& t) {
  return 4.0 / 3.0 * t.pair.modulus * std::sqrt(t.radius);
}
/// Mindlin coefficient [N/m^1.5]: the tangential stiffness is this times sqrt(overlap) (dem.6).
inline double mindlin_stiffness(const EffectivePair& t) {
  return 8 * t.pair.shear_modulus * std::sqrt(t.radius);
}
/// Normal stiffness F/overlap over tangential stiffness [1].
inline double mindlin_stiffness_ratio(const EffectivePair& t) {
  return t.pair.modulus / (6 * t.pair.shear_modulus);
}
/// Largest overlap of an elastic collision at `speed` [m/s], in m (dem.8).
inline double hertz_overlap(const EffectivePair& t, double speed) {
  return math::pow(1.25 * t.mass * speed * speed / hertz_stiffness(t), 0.4);
}
/// Duration of an elastic collision [1], in terms of largest overlap over speed: 2 sqrt(pi)
/// Gamma(7/5) / Gamma(9/10).
constexpr double hertz_duration = 2.9432751843247047;
/// Duration of an elastic collision [s] (dem.9).
inline double hertz_time(const EffectivePair& t, double speed) {
  return hertz_duration * hertz_overlap(t, speed) / speed;
}
/// Elastic energy [J] at `overlap` [m].
inline double hertz_energy(double stiffness, double overlap) {
  return overlap > 0 ? 0.4 * stiffness * overlap * overlap * std::sqrt(overlap) : 0;
}

/// Base of laws with a Hertz spring. Coefficient 0 of such a law is the Hertz stiffness. Each law
/// defines its own time scales and largest overlap (DefinesOwnScales).
struct HertzSpring {
  static constexpr bool has_history = false;
  static constexpr TouchExponent touch_exponent = TouchExponent::three_halves;
  void begin(const LawCoefficients&, double*, double) const {}
  template <class V>
  [[gnu::always_inline]] static V onset_overlap(const V*) {
    return V{};
  }
  double pull_off_distance(const EffectivePair&) const { return 0; }
  double stiffness_ratio(const EffectivePair& t) const { return mindlin_stiffness_ratio(t); }
  double elastic_energy(const LawCoefficients& k, const double*, double overlap) const {
    return hertz_energy(k[0], overlap);
  }
  bool operator==(const HertzSpring&) const = default;
};

}  // namespace mahlwerk::contact

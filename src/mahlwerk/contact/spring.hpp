// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/hertz.hpp"

// Linear spring: common parts of the laws built on it.
namespace mahlwerk::contact {

/// Tangential over normal stiffness: with 2/7, normal and tangential motion have the same period
/// (dem.12).
constexpr double tangential_stiffness_ratio = 2.0 / 7.0;

/// Base of laws with a linear spring. Each law defines its own time scales and largest overlap
/// (DefinesOwnScales).
struct Spring {
  static constexpr bool has_history = false;
  static constexpr TouchExponent touch_exponent = TouchExponent::one;
  double stiffness_speed = 1;  ///< [m/s] impact speed of equal stored energy
  double stiffness = 0;        ///< [N/m] normal stiffness; 0: from stiffness_speed

  /// Normal stiffness [N/m]: as given, or such that the spring stores the same energy as a Hertz
  /// spring at the largest Hertz overlap of an impact at `stiffness_speed` (dem.11).
  double stiffness_of(const EffectivePair& t) const {
    if (stiffness > 0) return stiffness;
    const double d = hertz_overlap(t, stiffness_speed);
    return 0.8 * hertz_stiffness(t) * std::sqrt(d);  // k d^2 / 2 = (2/5) k_Hertz d^2.5
  }
  /// Largest overlap [m] of an undamped collision at `speed` [m/s].
  double undamped_overlap(const EffectivePair& t, double speed) const {
    return speed * std::sqrt(t.mass / stiffness_of(t));
  }

  template <class V>
  [[gnu::always_inline]] static V onset_overlap(const V*) {
    return V{};
  }
  double pull_off_distance(const EffectivePair&) const { return 0; }
  double stiffness_ratio(const EffectivePair&) const { return 1 / tangential_stiffness_ratio; }
  bool operator==(const Spring&) const = default;
};

/// The parameters of Spring, as fields of the law L.
template <class L>
constexpr auto spring_fields() {
  return std::array{
      LawField<L>{{"stiffness_speed", "m/s", &L::stiffness_speed, positive,
                   "impact speed at which the spring stores as much energy as a Hertz contact", 1.0,
                   "uncalibrated; typical impact speed in a mill"}},
      LawField<L>{{"stiffness", "N/m", &L::stiffness, positive, "stiffness of the spring"},
                  "stiffness_speed"}};
}

}  // namespace mahlwerk::contact

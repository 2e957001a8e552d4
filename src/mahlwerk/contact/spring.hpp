// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/hertz.hpp"

// Linear springs: what the laws built on them share.
namespace mahlwerk::contact {

/// Across the normal, so that both motions of a collision have one period (dem.12).
constexpr double tangential_stiffness_ratio = 2.0 / 7.0;

/// What laws with a linear spring have in common. Their times and overlaps each states for itself.
struct Spring {
  static constexpr bool has_history = false;
  double stiffness_speed = 1;  ///< [m/s] where the spring stores as much as Hertz's
  double stiffness = 0;        ///< [N/m] of the spring itself; 0: from stiffness_speed

  /// Of the spring between these bodies: as given, or such that it stores as much energy as Hertz's
  /// at the same overlap when they meet at a characteristic speed (dem.11) [N/m].
  double stiffness_of(const EffectivePair& t) const {
    if (stiffness > 0) return stiffness;
    const double d = hertz_overlap(t, stiffness_speed);
    return 0.8 * hertz_stiffness(t) * std::sqrt(d);  // k d^2 / 2 = (2/5) k_Hertz d^2.5
  }
  /// [m] of an undamped collision.
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

/// The numbers of a Spring, as those of the law L.
template <class L>
constexpr auto spring_fields() {
  return std::array{
      LawField<L>{{"stiffness_speed", "m/s", &L::stiffness_speed, positive,
                   "the speed of impact at which the spring is as stiff as Hertz's contact", 1.0,
                   "uncalibrated; the order of the impacts in a mill"}},
      LawField<L>{{"stiffness", "N/m", &L::stiffness, positive, "stiffness of the spring"},
                  "stiffness_speed"}};
}

}  // namespace mahlwerk::contact

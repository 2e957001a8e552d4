// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/contact/damping.hpp"
#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Hertz's spring with the damper of Tsuji, Tanaka and Ishida (1992), the same along and across the
/// normal (dem.10). The bodies never pull: the contact ends when the force does, and the damping
/// is solved for that end, so that e is exact.
struct HertzTsuji : HertzSpring {
  static constexpr LawName name = LawName::hertz_tsuji;
  explicit HertzTsuji(const LawChoice&) {}

  double damping(double e) const { return tensionless_damping(std::max(e, least_restitution)); }
  /// The dimensionless damper is in units of sqrt(m* k).
  LawNumbers numbers(const Touching& t, double damping) const {
    const double k = hertz_stiffness(t);
    return {k, damping * std::sqrt(t.mass * k), mindlin_stiffness(t)};
  }

  /// Across the normal, where the bodies turn, too: 2/7 of the mass.
  double damper_time(const Touching& t, double damping, double speed) const {
    const double k = hertz_stiffness(t), quarter = std::pow(hertz_overlap(t, speed), 0.25);
    return damping > 0 ? 2.0 / 7.0 * std::sqrt(t.mass / k) / (damping * quarter) : unbounded_time;
  }

  template <class V>
  [[gnu::always_inline]] static Push<V> push(const V* k, V*, V overlap, V rate) {
    const V half = root(overlap), damping = k[1] * root(half);
    const V force = larger(k[0] * overlap * half + damping * rate, V{});
    const auto pushes = less(V{}, force);  // in the tail without force nothing rubs either
    return {force, choose(pushes, k[2] * half, V{}), choose(pushes, damping, V{}), force};
  }
};

}  // namespace mahlwerk::contact

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// Hertz and Mindlin without slip, damped so that restitution does not depend on speed: paper B
/// eqs. 3 to 10 as corrected (dem.5 to dem.7; Tsuji 1992, LIGGGHTS, EDEM). The contact ends when
/// the overlap does; shortly before it the force pulls, which makes e exact.
struct HertzMindlin : HertzSpring {
  static constexpr LawName name = LawName::hertz_mindlin;
  explicit HertzMindlin(const LawChoice&) {}

  double damping(double e) const { return -2 * std::sqrt(5.0 / 6.0) * damping_ratio(e); }
  LawNumbers numbers(const Touching& t, double damping) const {
    const double across = mindlin_stiffness(t);
    return {hertz_stiffness(t),
            damping * std::sqrt(2 * t.pair.modulus * std::sqrt(t.radius) * t.mass), across,
            damping * std::sqrt(across * t.mass)};
  }

  template <class V>
  [[gnu::always_inline]] static Push<V> push(const V* k, V*, V overlap, V rate) {
    const V half = root(overlap), quarter = root(half);
    const V force = k[0] * overlap * half + k[1] * quarter * rate;
    return {force, k[2] * half, k[3] * quarter, force};
  }
};

}  // namespace mahlwerk::contact

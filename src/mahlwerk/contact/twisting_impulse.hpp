// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/contact/hertz.hpp"

// Twisting friction of hard spheres: that of the soft engine (dem.42 to dem.44), integrated over an
// elastic Hertz impact.
namespace mahlwerk::contact {

/// The integral of F a over an elastic impact, over the normal impulse and the largest contact
/// radius [1]: sqrt(pi) Gamma(6/5) / (2 Gamma(17/10)) (evt.24).
constexpr double hertz_torque_ratio = 0.8955218748694334;

/// Twisting friction of one collision.
struct Twist {
  double impulse = 0;  ///< [N m s] against the relative spin about the normal, with its sign
  double loss = 0;     ///< [J] dissipated
};

/// The twisting friction of two bodies that touch at `approach` [m/s] with the impulse `normal`
/// [N s] and turn at `spin` [rad/s] relative to each other about the normal; `inertia` [kg m2] is
/// the effective one (evt.24 to evt.26). Nothing twists on a smooth wall (evt.15).
inline Twist twist(const EffectivePair& pair, const BounceRule& rule, double inertia,
                   double approach, double normal, double spin) {
  constexpr double touching = 1e-10;  // [m/s] slower is rounding (evt.5)
  if (spin == 0 || approach < touching || rule.tangential_restitution == 1) return {};
  const double overlap = hertz_overlap(pair, approach);
  const double sliding = 2.0 / 3 * rule.friction * hertz_torque_ratio *
                         std::sqrt(pair.radius * overlap) * normal;  // (evt.24)
  const double sticking = 1.5 * pair.pair.shear_modulus / pair.pair.modulus * pair.radius *
                          hertz_duration * overlap / approach * normal *
                          std::abs(spin);  // (evt.25)
  const double ratio = sticking / sliding, square = ratio * ratio;
  const double impulse = std::copysign(
      std::min(sticking / std::sqrt(std::sqrt(1 + square * square)), inertia * std::abs(spin)),
      spin);  // (evt.26)
  return {impulse, impulse * (spin - 0.5 * impulse / inertia)};
}

}  // namespace mahlwerk::contact

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

// Squeeze flow of a liquid between two bodies that approach each other (docs/theory/liquid.md).
namespace mahlwerk::contact {

/// A Newtonian liquid on or around the bodies.
struct Liquid {
  double viscosity = 0;          ///< [Pa s] dynamic, > 0
  double density = 0;            ///< [kg/m3] >= 0; read only if flooded
  bool flooded = false;          ///< the jar is full of liquid; else each body carries a film
  double film = 0;               ///< [m] thickness of the film on each body, > roughness / 2
  double reach = 1;              ///< [1] flooded: initial separation over R*, in (0, 1]
  double roughness = 1e-6;       ///< [m] separation of the mean surfaces of touching bodies, > 0
  bool resists_rebound = false;  ///< the liquid also resists separation: it does not cavitate
  bool drag = true;              ///< flooded: drag, torque and pressure on each ball
  bool operator==(const Liquid&) const = default;

  /// Separation h0 [m] of the mean surfaces at which lubrication begins (liq.2).
  double initial_separation(double effective_radius) const {
    return flooded ? reach * effective_radius : 2 * film;
  }
  /// The gap [m] of the smooth bodies at that separation; bodies touch at the gap 0 (liq.2).
  double gap_reach(double effective_radius) const {
    return std::max(0.0, initial_separation(effective_radius) - roughness);
  }
  /// 6 pi eta R*^2 [N s]: force times separation over speed (liq.1).
  double resistance(double effective_radius) const {
    return 6 * std::numbers::pi * viscosity * effective_radius * effective_radius;
  }
  /// Approach speed [m/s] below which the liquid stops two bodies before they touch: that of the
  /// critical Stokes number (liq.4).
  double critical_speed(double effective_radius, double effective_mass) const {
    const double ratio = initial_separation(effective_radius) / roughness;
    return ratio > 1 ? resistance(effective_radius) / effective_mass * math::log(ratio) : 0.0;
  }
  /// Speed [m/s] at which bodies touch that enter the liquid at the speed `approach` (liq.3).
  double touch_speed(double effective_radius, double effective_mass, double approach) const {
    return std::max(0.0, approach - critical_speed(effective_radius, effective_mass));
  }
};

/// Mean lubrication force [N] over a step of `dt` [s], > 0 repulsive, on bodies with the gap `gap`
/// > 0 that approach at `approach` [m/s]. `resistance` and `reach` are those of the pair
/// (Liquid::resistance(), Liquid::gap_reach()). The separation is taken to change at this speed
/// during the step, from half a step before to half a step after; the first step after the bodies
/// entered the liquid and the last one before they touch cover the rest of the way. The impulses of
/// the steps then add up to (liq.3) for any length of the step. V is a double or a register.
template <class V>
[[gnu::always_inline]] inline V lubrication_force(const Liquid& liquid, const V& resistance,
                                                  const V& reach, const V& gap, const V& approach,
                                                  double dt) {
  const V zero{}, speed = abs(approach);
  const MaskOf<V> acts =
      both(less(gap, reach), less(zero, liquid.resists_rebound ? speed : approach));
  if (!any(acts)) return zero;
  const V half = 0.5 * speed * dt;
  const V wide = select(less(gap + 2.0 * half, reach), gap + half, reach);
  const V narrow = select(less(2.0 * half, gap), gap - half, zero);
  const V ratio = select(acts, (wide + liquid.roughness) / (narrow + liquid.roughness), zero + 1.0);
  const V force = resistance * math::log(ratio) / dt;
  return where<V>(acts, select(less(zero, approach), force, -force));
}

/// Drag of a sphere over Stokes's drag, from the Reynolds number with its diameter: Schiller and
/// Naumann up to 1000, Newton's constant coefficient 0.44 above (liq.6).
template <class V>
[[gnu::always_inline]] inline V drag_correction(const V& reynolds) {
  const V zero{}, newton = zero + 1000.0;
  const V power = math::pow(max(min(reynolds, newton), zero + 1e-200), 0.687);  // 1e-200: as 0
  return select(less(reynolds, newton), 1.0 + 0.15 * power, 0.44 / 24 * reynolds);
}

}  // namespace mahlwerk::contact

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Resistance of spinning bodies to a change of their slip.
namespace mahlwerk::contact {

/// I/(m R^2) of a homogeneous sphere [1].
constexpr double solid_inertia_ratio = 0.4;

/// Slip factor of a body with I/(m R^2) = `inertia_ratio` [1] > 0: an impulse J across changes the
/// slip by this times J/m (hol.3). 7/2 for a solid sphere, 5/2 for a thin shell.
constexpr double slip_factor(double inertia_ratio) {
  return 1 + 1 / inertia_ratio;
}
constexpr double solid_slip_factor = slip_factor(solid_inertia_ratio);
static_assert(solid_slip_factor == 3.5);

/// A body as it resists a change of slip: mass [kg] and inertia ratio [1].
struct SlipBody {
  double mass = 0, inertia_ratio = solid_inertia_ratio;
};
/// Slip factor of two bodies, in terms of their effective mass: J changes the slip by this times
/// J/m_eff (hol.4). Bodies of one inertia ratio have that of a single one, to the last bit.
constexpr double slip_factor(const SlipBody& a, const SlipBody& b) {
  if (a.inertia_ratio == b.inertia_ratio) return slip_factor(a.inertia_ratio);
  return (b.mass * slip_factor(a.inertia_ratio) + a.mass * slip_factor(b.inertia_ratio)) /
         (a.mass + b.mass);
}

}  // namespace mahlwerk::contact

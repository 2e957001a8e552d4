// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::contact {

/// Dimensionless damping that yields a given restitution. The collision is that of a Hertz spring
/// with a damper, x'' = -x^1.5 - damper, with x(0) = 0, x'(0) = 1. Solved numerically, once for
/// each pair; docs/theory/soft.md (dem.10).

/// c of the damper c x^(1/4) x'. The contact ends when the force vanishes: no tension.
double tensionless_damping(double restitution);

/// c of the damper c s^2 (3 - 2 s) x', s = min(x / depth, 1), with the force cut off at 0 (dem.14).
/// `depth` has the unit of x.
double stepped_damping(double restitution, double depth);

}  // namespace mahlwerk::contact

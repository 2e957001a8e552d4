// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::contact {

/// Dimensionless collisions of a Hertz spring x'' = -x^1.5 - damper with x(0) = 0, x'(0) = 1, from
/// which laws find the damping that ends with a wanted restitution. Solved numerically, once for
/// each pair; docs/theory/soft.md (dem.10).

/// Damper c x^(1/4) x'; the contact ends when the force does.
double tensionless_damping(double restitution);

/// Damper c s^2 (3 - 2 s) x', s = min(x / depth, 1), force cut off at 0; `depth` in units of x.
double stepped_damping(double restitution, double depth);

}  // namespace mahlwerk::contact

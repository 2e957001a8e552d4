// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/breakage/tavares.hpp"

#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

// D = (2 gamma x/(2 gamma - 5 D + 5))^(2 gamma/5) is implicit in D. The right side grows with D
// from above 0. The smallest root is the physical one; it is 1 at load 1. Found by bisection.
double Tavares::damage(double load) const {
  if (!(load > 0)) return 0;
  if (load >= 1) return 1;
  // Newton's method from below: the right side of (brk.6) less D is convex, so that no step goes
  // beyond the root. A double root at load 1 costs some 25 steps; elsewhere a few suffice.
  double d = 0;
  for (int i = 0; i < 60; ++i) {
    const double below = 2 * gamma - 5 * d + 5;
    const double right = math::pow(2 * gamma * load / below, 0.4 * gamma);
    const double next = d + (right - d) / (1 - right * 2 * gamma / below);
    if (!(next > d) || next > 1) break;
    d = next;
  }
  return d;
}

}  // namespace mahlwerk::powder

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
  const auto right = [&](double d) {
    return math::pow(2 * gamma * load / (2 * gamma - 5 * d + 5), 0.4 * gamma);
  };
  double low = 0, high = 1;  // right(low) > low; right(high) < 1 = high, as load < 1
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    const double middle = 0.5 * (low + high);
    (right(middle) > middle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace mahlwerk::powder

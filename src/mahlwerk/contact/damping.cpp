// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/damping.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::contact {
namespace {

/// Restitution of x'' = -force(x, x') with x(0) = 0, x'(0) = 1. Runge-Kutta steps of order 4 until
/// the force or the overlap vanishes during the rebound.
template <class Force>
double rebound(const Force& force) {
  constexpr double h = 2e-3;  // the collision takes about 3.2
  double x = 0, v = 1;
  for (int step = 0; step < 100'000; ++step) {
    const auto a = [&](double at, double speed) { return -force(std::max(at, 0.0), speed); };
    const double v1 = v, a1 = a(x, v);
    const double v2 = v + 0.5 * h * a1, a2 = a(x + 0.5 * h * v1, v2);
    const double v3 = v + 0.5 * h * a2, a3 = a(x + 0.5 * h * v2, v3);
    const double v4 = v + h * a3, a4 = a(x + h * v3, v4);
    x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (v < 0 && (x <= 0 || force(x, v) <= 0)) return -v;
  }
  return 0;  // overdamped: no rebound
}

/// The damping at which `rebound` returns `restitution`, by bisection; `rebound` decreases with
/// damping.
template <class Rebound>
double find_damping(double restitution, const Rebound& rebound) {
  if (restitution >= 1) return 0;
  double low = 0, high = 1;
  while (rebound(high) > restitution && high < 1e3) low = high, high *= 2;
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    (rebound(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double tensionless_damping(double restitution) {
  return find_damping(restitution, [](double c) {
    return rebound([c](double x, double v) {
      const double half = std::sqrt(x);
      return x * half + c * std::sqrt(half) * v;
    });
  });
}

double stepped_damping(double restitution, double depth) {
  return find_damping(restitution, [depth](double c) {
    return rebound([c, depth](double x, double v) {
      const double s = std::min(x / depth, 1.0);
      return std::max(x * std::sqrt(x) + c * s * s * (3 - 2 * s) * v, 0.0);
    });
  });
}

}  // namespace mahlwerk::contact

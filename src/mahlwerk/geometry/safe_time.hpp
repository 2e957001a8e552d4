// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/geometry/shape.hpp"

// Times that are certainly free of a touch: lower bounds on the root of a gap whose second
// derivative is bounded. Each is exact when the bound is attained, so stepping by them converges
// like Newton's method but never passes a root.
namespace mahlwerk::geometry {

/// Smallest s > 0 with far - 2 b s - m s^2 = 0 (far, m >= 0).
inline double first_root(double far, double b, double m) {
  const double root = std::sqrt(b * b + m * far);
  if (b > 0) return far / (b + root);
  return m > 0 ? (root - b) / m : never;
}

/// A point `gap` from a plane that nears it at `closing`, pulled by at most `max_acceleration`
/// (geo.4).
inline double plane_safe_time(double gap, double closing, double max_acceleration) {
  return first_root(std::max(gap, 0.0), 0.5 * closing, 0.5 * max_acceleration);
}

/// A point at `e` from the foot on the core of an offset face, `room` [m] the radius it must stay
/// within, `along` = e.u, `speed2` = u.u, all in the directions in which the face is curved
/// (geo.5): |e + u s + a s^2/2| <= room holds while room^2 - e^2 - 2 e.u s - (u^2 + room a) s^2 >=
/// 0.
inline double core_safe_time(double room, double e2, double along, double speed2,
                             double max_acceleration) {
  return first_root(std::max(room * room - e2, 0.0), along, speed2 + room * max_acceleration);
}

/// The gap room - |e| without its root: never more than it, and equal to it as it closes.
inline double gap_within(double room, double e2) {
  return (room * room - e2) / (2 * room);
}

/// How the inward normal -e/|e| of an offset face turns when e grows at `u` [m/s] (geo.2).
inline Vec3 rate_about_core(const Vec3& e, const Vec3& u) {
  const double e2 = squared(e);
  return (dot(u, e) / e2 * e - u) / std::sqrt(e2);
}

/// When a point at `x` moving at `v` next crosses +-`edge`.
inline double until_crossing(double edge, double x, double v) {
  if (v < 0) x = -x;
  const double way = x < -edge ? -edge - x : x < edge ? edge - x : never;
  return v != 0 ? way / std::abs(v) : never;
}

}  // namespace mahlwerk::geometry

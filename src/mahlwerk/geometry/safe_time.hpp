// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/geometry/shape.hpp"

// Safe times for conservative advancement: lower bounds on the root of a gap whose second
// derivative is bounded. Each is exact when the bound is attained, so steps of safe times converge
// like Newton's method but never pass a root.
namespace mahlwerk::geometry {

/// Smallest s > 0 with far - 2 b s - m s^2 = 0 (far, m >= 0).
inline double first_root(double far, double b, double m) {
  const double root = std::sqrt(b * b + m * far);
  if (b > 0) return far / (b + root);
  return m > 0 ? (root - b) / m : never;
}

/// Safe time [s] of a point at `gap` [m] from a plane, approaching at `closing` [m/s] with at most
/// `max_acceleration` [m/s2] (geo.4).
inline double plane_safe_time(double gap, double closing, double max_acceleration) {
  return first_root(std::max(gap, 0.0), 0.5 * closing, 0.5 * max_acceleration);
}

/// Safe time [s] of a point at the vector e from the nearest core point of an offset face, with the
/// velocity u. `room` [m] is the radius in which the point must stay, `e2` = e.e, `along` = e.u,
/// `speed2` = u.u, all in the directions in which the face is curved (geo.5). |e + u s + a s^2/2|
/// <= room holds while room^2 - e^2 - 2 e.u s - (u^2 + room a) s^2 >= 0.
inline double core_safe_time(double room, double e2, double along, double speed2,
                             double max_acceleration) {
  return first_root(std::max(room * room - e2, 0.0), along, speed2 + room * max_acceleration);
}

/// Lower bound of the gap room - |e| [m], without a square root; equal to the gap as it closes.
inline double gap_within(double room, double e2) {
  return (room * room - e2) / (2 * room);
}

/// Rate [1/s] of the inward normal -e/|e| of an offset face when e changes at `u` [m/s] (geo.2).
inline Vec3 rate_about_core(const Vec3& e, const Vec3& u) {
  const double e2 = squared(e);
  return (dot(u, e) / e2 * e - u) / std::sqrt(e2);
}

/// Time [s] until a point at `x` [m] with velocity `v` [m/s] crosses +-`edge`; infinite if never.
inline double until_crossing(double edge, double x, double v) {
  if (v < 0) x = -x;
  const double way = x < -edge ? -edge - x : x < edge ? edge - x : never;
  return v != 0 ? way / std::abs(v) : never;
}

}  // namespace mahlwerk::geometry

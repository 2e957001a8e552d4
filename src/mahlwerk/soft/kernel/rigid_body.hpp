// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/quaternion.hpp"

// The motion of a rigid body about its centre of mass.
namespace mahlwerk::soft {

/// Quaternions and 3-vectors of a body, or of those in the lanes of a register V.
template <class V>
struct OrientationOf {
  V w, x, y, z;
};

/// The turn of a free body about a principal axis by the angle that its angular momentum along the
/// axis makes in a time (bod.10). `rate` [1/(kg m2/s)]: this time over the moment of inertia; `a`,
/// `b`, `c`: momentum along the axis and the next two in turn; `i`, `j`, `k`: the same components
/// of the quaternion, which loses its length.
template <class V>
[[gnu::always_inline]] inline void turn_about_axis(const V& rate, const V& a, V& b, V& c, V& w,
                                                   V& i, V& j, V& k) {
  const V half = 0.5 * rate * a, square = half * half;
  const V t = half * (1.0 + square * (1.0 / 3 + square * (2.0 / 15)));  // tan(half)
  const V scale = 1.0 / (1.0 + t * t), cos = (1.0 - t * t) * scale, sin = 2.0 * t * scale;
  const V b_before = b, w_before = w, j_before = j;
  b = cos * b + sin * c;
  c = cos * c - sin * b_before;
  w = w - t * i, i = i + t * w_before;
  j = j + t * k, k = k - t * j_before;
}

/// The images of the principal axes under a unit quaternion.
template <class V>
[[gnu::always_inline]] inline void axes_of(const OrientationOf<V>& q, Vec<V>& ex, Vec<V>& ey,
                                           Vec<V>& ez) {
  const V xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, yz = q.y * q.z,
          zx = q.z * q.x, wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  ex = {1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (zx - wy)};
  ey = {2.0 * (xy - wz), 1.0 - 2.0 * (zz + xx), 2.0 * (yz + wx)};
  ez = {2.0 * (zx + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)};
}

/// The orientation after a time without torque (bod.10). `momentum` [kg m2/s]: angular momentum in
/// laboratory axes, which stays; `rate`: the time over the principal moments of inertia. Of second
/// order, symplectic and reversible.
template <class V>
[[gnu::always_inline]] inline OrientationOf<V> turned_freely(OrientationOf<V> q,
                                                             const Vec<V>& momentum,
                                                             const Vec<V>& rate) {
  Vec<V> ex, ey, ez;
  axes_of(q, ex, ey, ez);
  V lx = dot(ex, momentum), ly = dot(ey, momentum), lz = dot(ez, momentum);
  turn_about_axis<V>(0.5 * rate.x, lx, ly, lz, q.w, q.x, q.y, q.z);
  turn_about_axis<V>(0.5 * rate.y, ly, lz, lx, q.w, q.y, q.z, q.x);
  turn_about_axis<V>(rate.z, lz, lx, ly, q.w, q.z, q.x, q.y);
  turn_about_axis<V>(0.5 * rate.y, ly, lz, lx, q.w, q.y, q.z, q.x);
  turn_about_axis<V>(0.5 * rate.x, lx, ly, lz, q.w, q.x, q.y, q.z);
  const V scale = 1.0 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// The same for one body.
inline Quaternion after_free_rotation(const Quaternion& q, const Vec3& momentum,
                                      const Vec3& inverse_inertia, double dt) {
  const Vec3 rate = dt * inverse_inertia;
  const auto [w, x, y, z] = turned_freely<double>(
      {q.w, q.x, q.y, q.z}, {momentum.x, momentum.y, momentum.z}, {rate.x, rate.y, rate.z});
  return {w, x, y, z};
}

/// The vector whose components along the axes of a body are those of `a` times `factors`: spin from
/// angular momentum with the inverse moments of inertia (bod.9).
inline Vec3 scaled_along_axes(const Rotation& axes, const Vec3& factors, const Vec3& a) {
  const Vec3 b = axes.apply_inverse(a);
  return axes * Vec3{factors.x * b.x, factors.y * b.y, factors.z * b.z};
}

/// Inverse masses [1/kg] of a body at a point, for an impulse along the normal `n`, and across it,
/// the mean of both directions (bod.12).
struct InverseMass {
  double normal = 0, tangential = 0;
};
/// `arm` [m]: from the centre of mass to the point.
inline InverseMass inverse_mass_at(double mass, const Vec3& inverse_inertia, const Rotation& axes,
                                   const Vec3& arm, const Vec3& n) {
  const Vec3 moment = cross(arm, n);
  const double normal = 1 / mass + dot(moment, scaled_along_axes(axes, inverse_inertia, moment));
  const double trace = inverse_inertia.x + inverse_inertia.y + inverse_inertia.z;
  const double all =
      3 / mass + squared(arm) * trace - dot(arm, scaled_along_axes(axes, inverse_inertia, arm));
  return {normal, 0.5 * (all - normal)};
}

}  // namespace mahlwerk::soft

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/quaternion.hpp"

// The motion of a rigid body about its centre of mass.
namespace mahlwerk::soft {

/// A free rotation: the orientation, and the angular momentum [kg m2/s] along the principal axes.
struct FreeRotation {
  Quaternion q;  ///< not normalised
  Vec3 momentum;

  /// Turn about a principal axis by the angle that the momentum along it makes in a time: `rate`
  /// is that time over the moment of inertia. `a`, `b`, `c`: the axis, and the next two in turn;
  /// `i`, `j`, `k` the same components of the quaternion (bod.10).
  static void turn(double rate, double a, double& b, double& c, Quaternion& q,
                   double Quaternion::*i, double Quaternion::*j, double Quaternion::*k) {
    const double half = 0.5 * rate * a, square = half * half;
    const double t = half * (1 + square * (1.0 / 3 + square * (2.0 / 15)));  // tan(half)
    const double scale = 1 / (1 + t * t), cos = (1 - t * t) * scale, sin = 2 * t * scale;
    const double b_before = b;
    b = cos * b + sin * c;
    c = cos * c - sin * b_before;
    const Quaternion p = q;
    q.w = p.w - t * p.*i, q.*i = p.*i + t * p.w;
    q.*j = p.*j + t * p.*k, q.*k = p.*k - t * p.*j;
  }
  void turn_x(double rate) {
    turn(rate, momentum.x, momentum.y, momentum.z, q, &Quaternion::x, &Quaternion::y,
         &Quaternion::z);
  }
  void turn_y(double rate) {
    turn(rate, momentum.y, momentum.z, momentum.x, q, &Quaternion::y, &Quaternion::z,
         &Quaternion::x);
  }
  void turn_z(double rate) {
    turn(rate, momentum.z, momentum.x, momentum.y, q, &Quaternion::z, &Quaternion::x,
         &Quaternion::y);
  }
};

/// The orientation after the time `dt` [s] of a body without torque (bod.10). `momentum`: angular
/// momentum [kg m2/s] in laboratory axes, which stays; `inverse_inertia`: [1/(kg m2)] principal. Of
/// second order, symplectic and reversible.
inline Quaternion after_free_rotation(const Quaternion& q, const Vec3& momentum,
                                      const Vec3& inverse_inertia, double dt) {
  FreeRotation body{q, rotation_of(q).apply_inverse(momentum)};
  const Vec3 rate = dt * inverse_inertia;
  body.turn_x(0.5 * rate.x);
  body.turn_y(0.5 * rate.y);
  body.turn_z(rate.z);
  body.turn_y(0.5 * rate.y);
  body.turn_x(0.5 * rate.x);
  return normalised(body.q);
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

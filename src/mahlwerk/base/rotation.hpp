// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk {

/// A proper rotation, stored as the images of the three axes.
struct Rotation {
  Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

  constexpr Vec3 operator*(const Vec3& a) const { return a.x * ex + a.y * ey + a.z * ez; }
  constexpr Vec3 apply_inverse(const Vec3& a) const { return {dot(ex, a), dot(ey, a), dot(ez, a)}; }
  constexpr bool operator==(const Rotation&) const = default;
};

constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
  return {a * b.ex, a * b.ey, a * b.ez};
}

/// Rotation by `angle` [rad] about the unit vector `axis`, right-handed (con.3).
inline Rotation rotation_about(const Vec3& axis, double angle) {
  const SinCos of = sin_cos(angle);
  const auto turned = [&](const Vec3& a) {
    return of.cos * a + of.sin * cross(axis, a) + (1 - of.cos) * dot(axis, a) * axis;
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

/// Bounds of the absolute components of a rotated vector whose absolute components are bounded by
/// `most`.
inline Vec3 bound_of_rotated(const Rotation& r, const Vec3& most) {
  return most.x * componentwise_abs(r.ex) + most.y * componentwise_abs(r.ey) +
         most.z * componentwise_abs(r.ez);
}

}  // namespace mahlwerk

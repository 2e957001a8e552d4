// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/rotation.hpp"

namespace mahlwerk {

/// A rotation as a unit quaternion w + x i + y j + z k.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
  constexpr bool operator==(const Quaternion&) const = default;
};

constexpr double squared(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}
inline Quaternion normalised(const Quaternion& q) {
  const double scale = 1 / std::sqrt(squared(q));
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// The product: first the rotation `b`, then `a`.
constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The rotation of a unit quaternion, from the axes of a body to those of the laboratory.
constexpr Rotation rotation_of(const Quaternion& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, yz = q.y * q.z,
               zx = q.z * q.x, wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (zx - wy)},
          {2 * (xy - wz), 1 - 2 * (zz + xx), 2 * (yz + wx)},
          {2 * (zx + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)}};
}

/// The unit quaternion of a rotation.
inline Quaternion quaternion_of(const Rotation& r) {
  const double xx = r.ex.x, yy = r.ey.y, zz = r.ez.z;
  const auto half_root = [](double square) { return 0.5 * std::sqrt(std::max(0.0, 1 + square)); };
  const double w = half_root(xx + yy + zz), x = half_root(xx - yy - zz),
               y = half_root(yy - xx - zz), z = half_root(zz - xx - yy);
  // Uses the largest component as divisor, for accuracy.
  if (w >= x && w >= y && w >= z)
    return {w, (r.ey.z - r.ez.y) / (4 * w), (r.ez.x - r.ex.z) / (4 * w),
            (r.ex.y - r.ey.x) / (4 * w)};
  if (x >= y && x >= z)
    return {(r.ey.z - r.ez.y) / (4 * x), x, (r.ex.y + r.ey.x) / (4 * x),
            (r.ez.x + r.ex.z) / (4 * x)};
  if (y >= z)
    return {(r.ez.x - r.ex.z) / (4 * y), (r.ex.y + r.ey.x) / (4 * y), y,
            (r.ey.z + r.ez.y) / (4 * y)};
  return {(r.ex.y - r.ey.x) / (4 * z), (r.ez.x + r.ex.z) / (4 * z), (r.ey.z + r.ez.y) / (4 * z), z};
}

}  // namespace mahlwerk

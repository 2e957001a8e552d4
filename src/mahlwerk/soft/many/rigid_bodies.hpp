// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/quaternion.hpp"
#include "mahlwerk/soft/body_species.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

/// Centre of mass [m] and orientation of a body.
struct alignas(64) BodyRecord {
  Vec3 centre;
  double zero = 0;  ///< eight numbers, for load_columns()
  Quaternion orientation;

  BodyRecord() = default;
  BodyRecord(const Vec3& c, const Quaternion& q) : centre(c), orientation(q) {}
};
/// Velocity [m/s] and angular momentum [kg m2/s] of a body, in axes of the laboratory: half a step
/// after the present one, and predicted for the next (bod.8).
struct BodyMotion {
  VectorPair half_step, predicted;
};
inline Vec3 first_vector(const VectorPair& a) {
  return {a.x, a.y, a.z};
}
inline Vec3 second_vector(const VectorPair& a) {
  return {a.a, a.b, a.c};
}
inline VectorPair vector_pair(const Vec3& a, const Vec3& b) {
  return {a.x, a.y, a.z, 0, b.x, b.y, b.z, 0};
}
/// The rows of a body's spheres are those from `first` on.
struct BodyRows {
  std::int32_t first = 0, species = 0, ball = 0;
};

/// The bodies of a run, in the order of their rows. Contacts see their spheres, which are rows like
/// those of balls; a body moves as a whole.
struct RigidBodies {
  std::vector<BodyRecord> now, next;  ///< at this step; at the next
  std::vector<BodyMotion> motion;
  std::vector<BodyRows> rows;
  std::vector<std::int32_t> body_of, sphere_of;  ///< body and number of the sphere of each row; < 0

  bool has_members() const { return !rows.empty(); }
  bool is_member(std::size_t row) const { return body_of[row] >= 0; }
  std::size_t body(std::size_t row) const { return static_cast<std::size_t>(body_of[row]); }
  /// First row of the body of a row.
  std::int32_t first_row(std::int32_t row) const {
    return row - sphere_of[static_cast<std::size_t>(row)];
  }
};

}  // namespace mahlwerk::soft

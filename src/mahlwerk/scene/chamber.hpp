// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/scene/machine_part.hpp"

namespace mahlwerk::scene {

/// A jar on its mill: shape, mounting, motion, gravity, and parts in it.
struct Chamber {
  Indirect<geometry::AnyShape> shape;
  Indirect<kinematics::AnyMotion> motion;
  Rotation mount;             ///< from the jar's own axes to the laboratory's, before any rotation
  Vec3 gravity{0, 0, -9.81};  ///< [m/s2]
  std::vector<MachinePart> parts = {};  ///< beside the balls
};

/// Returns the mounting that lays the jar's own z axis along the unit vector `axis`.
inline Rotation mounted_along(const Vec3& axis) {
  const Vec3 up{0, 0, 1};
  const Vec3 across_both = cross(up, axis);
  const double s = norm(across_both);
  if (s == 0) return axis.z > 0 ? Rotation{} : Rotation{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  return rotation_about(across_both / s, math::atan2(s, axis.z));
}

}  // namespace mahlwerk::scene

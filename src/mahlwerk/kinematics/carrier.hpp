// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"

// The carrier of a jar: the disc of a planetary mill. In the frame of the carrier the force field
// on the charge is steady, so the balls keep to a pattern.
namespace mahlwerk::kinematics {

/// Rotation of the carrier since the start, and its angular velocity [rad/s]. The carrier of a mill
/// without one is the laboratory: no rotation.
struct Carrier {
  Rotation rotation;
  Vec3 spin;
};
Carrier carrier(const AnyMotion& motion, double time);

/// Unit normal of the plane in which a mill's motion is best seen.
Vec3 plane_normal(const AnyMotion& motion);

}  // namespace mahlwerk::kinematics

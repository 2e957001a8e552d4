// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"

// What carries a jar: the disc of a planetary mill. Seen from it the force field on the charge is
// steady, so that balls keep to a pattern.
namespace mahlwerk::kinematics {

/// How the carrier has turned since the start, and its angular velocity [rad/s]; none for mills
/// without one: their carrier is the laboratory.
struct Carrier {
  Rotation rotation;
  Vec3 spin;
};
Carrier carrier(const AnyMotion& motion, double time);

/// The unit normal of the plane in which a mill's motion shows.
Vec3 plane_normal(const AnyMotion& motion);

}  // namespace mahlwerk::kinematics

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <typeinfo>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/kinematics/motion.hpp"
#include "mahlwerk/kinematics/speed_program.hpp"

// Type-erased motion of a mill, chosen at run time. kinematics/motions.hpp lists the types it can
// hold; kinematics/chosen_motion.hpp wraps it as a Motion.
namespace mahlwerk::kinematics {

struct AnyMotion;
class Drive;
struct Motor;

/// Position and rotation of a jar at an instant.
struct Pose {
  FrameMotion frame;
  Rotation rotation;          ///< since mounting
  Vec3 spin;                  ///< [rad/s]
  Vec3 angular_acceleration;  ///< [rad/s2]
};

std::string_view name_of(const AnyMotion& motion);  ///< "planetary"
/// The motion of a mill with a speed over time; it has no period.
Indirect<AnyMotion> programmed(const AnyMotion& motion, const SpeedProgram& program);
/// The motion of a mill of `speed` [rad/s] that a motor turns. Copies share the state of its drive,
/// so that each run needs a motion of its own.
Indirect<AnyMotion> driven(const AnyMotion& motion, const Motor& motor, double speed);
Drive* drive_of(const AnyMotion& motion);  ///< null if it is not driven()
Clock clock(const AnyMotion& motion, double t);
double largest_rate(const AnyMotion& motion);  ///< [1] bound of that of its clock, 1 or more
bool speed_varies(const AnyMotion& motion);    ///< programmed() or driven()
Pose pose(const AnyMotion& motion, double t);  ///< the next four in one call
FrameMotion frame_motion(const AnyMotion& motion, double t);
Rotation rotation(const AnyMotion& motion, double t);
Vec3 spin(const AnyMotion& motion, double t);
Vec3 angular_acceleration(const AnyMotion& motion, double t);
Bounds bounds(const AnyMotion& motion);
double period(const AnyMotion& motion);
Vec3 fixed_axis(const AnyMotion& motion);

/// Pointer to the motion held if it is of this type, else null.
const void* held(const AnyMotion& motion, const std::type_info& type);
/// The motion if it is an M, else null.
template <Motion M>
const M* as(const AnyMotion& motion) {
  return static_cast<const M*>(held(motion, typeid(M)));
}
template <Motion M>
const M* as(const AnyMotion&&) = delete;

}  // namespace mahlwerk::kinematics

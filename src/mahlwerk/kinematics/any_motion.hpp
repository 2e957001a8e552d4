// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/kinematics/motion.hpp"

// A mill's motion chosen at run time, for those who do not look into it; kinematics/motions.hpp
// lists what it can be, and kinematics/chosen_motion.hpp has it as a motion.
namespace mahlwerk::kinematics {

struct AnyMotion;

/// Where a jar is at an instant, and how it turns.
struct Pose {
  Ride ride;
  Rotation turn;   ///< since it was mounted
  Vec3 spin;       ///< [rad/s]
  Vec3 spin_rate;  ///< [rad/s2]
};

std::string_view name_of(const AnyMotion& motion);  ///< "planetary"
Pose pose(const AnyMotion& motion, double t);       ///< all of the next four at once
Ride ride(const AnyMotion& motion, double t);
Rotation turn(const AnyMotion& motion, double t);
Vec3 spin(const AnyMotion& motion, double t);
Vec3 spin_rate(const AnyMotion& motion, double t);
Bounds bounds(const AnyMotion& motion);
double period(const AnyMotion& motion);
Vec3 fixed_axis(const AnyMotion& motion);

/// What is held, of the type whose name is name_of().
const void* held(const AnyMotion& motion);
/// The motion if it is one of type M, else null.
template <class M>
const M* as(const AnyMotion& motion) {
  return name_of(motion) == M::name ? static_cast<const M*>(held(motion)) : nullptr;
}

}  // namespace mahlwerk::kinematics

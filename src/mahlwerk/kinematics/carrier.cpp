// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/carrier.hpp"

#include "mahlwerk/kinematics/circular.hpp"
#include "mahlwerk/kinematics/planetary.hpp"

namespace mahlwerk::kinematics {
namespace {

/// Angular speed of the carrier about the vertical [rad/s]; 0 without a carrier. The force field of
/// a circular motion rotates at the speed of the circle, so that motion has a carrier, too.
double speed_of_carrier(const AnyMotion& motion) {
  if (const auto* planetary = as<Planetary>(motion)) return planetary->speed;
  if (const auto* circular = as<Circular>(motion)) return circular->speed;
  return 0;
}

}  // namespace

Carrier carrier(const AnyMotion& motion, double time) {
  const double speed = speed_of_carrier(motion);
  if (speed == 0) return {};
  const Clock at = clock(motion, time);
  return {rotation_about(upright, speed * at.time), {0, 0, speed * at.rate}};
}

Vec3 plane_normal(const AnyMotion& motion) {
  if (as<Planetary>(motion) != nullptr || as<Circular>(motion) != nullptr) return upright;
  const Vec3 axis = fixed_axis(motion);
  return axis == Vec3{} ? Vec3{0, 1, 0} : axis;
}

}  // namespace mahlwerk::kinematics

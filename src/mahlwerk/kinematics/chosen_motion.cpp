// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/chosen_motion.hpp"

#include <utility>

namespace mahlwerk::kinematics {

ChosenMotion::ChosenMotion(AnyMotion motion) : motion_(std::move(motion)) {}

Pose ChosenMotion::pose(double t) const {
  return std::visit(
      [t](const auto& m) {
        return Pose{m.ride(t), m.turn(t), m.spin(t), m.spin_rate(t)};
      },
      motion_);
}
Ride ChosenMotion::ride(double t) const {
  return std::visit([t](const auto& m) { return m.ride(t); }, motion_);
}
Rotation ChosenMotion::turn(double t) const {
  return std::visit([t](const auto& m) -> Rotation { return m.turn(t); }, motion_);
}
Vec3 ChosenMotion::spin(double t) const {
  return std::visit([t](const auto& m) -> Vec3 { return m.spin(t); }, motion_);
}
Vec3 ChosenMotion::spin_rate(double t) const {
  return std::visit([t](const auto& m) -> Vec3 { return m.spin_rate(t); }, motion_);
}
Bounds ChosenMotion::bounds() const {
  return std::visit([](const auto& m) { return m.bounds(); }, motion_);
}
double ChosenMotion::period() const {
  return std::visit([](const auto& m) -> double { return m.period(); }, motion_);
}
Vec3 ChosenMotion::fixed_axis() const {
  return std::visit([](const auto& m) -> Vec3 { return m.fixed_axis(); }, motion_);
}

}  // namespace mahlwerk::kinematics

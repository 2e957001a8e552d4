// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/motions.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::kinematics::AnyMotion>;

namespace mahlwerk::kinematics {

std::string_view name_of(const AnyMotion& motion) {
  return std::visit([](const auto& m) -> std::string_view { return m.name; }, motion);
}
Pose pose(const AnyMotion& motion, double t) {
  return std::visit(
      [t](const auto& m) {
        return Pose{m.frame_motion(t), m.rotation(t), m.spin(t), m.angular_acceleration(t)};
      },
      motion);
}
FrameMotion frame_motion(const AnyMotion& motion, double t) {
  return std::visit([t](const auto& m) { return m.frame_motion(t); }, motion);
}
Rotation rotation(const AnyMotion& motion, double t) {
  return std::visit([t](const auto& m) -> Rotation { return m.rotation(t); }, motion);
}
Vec3 spin(const AnyMotion& motion, double t) {
  return std::visit([t](const auto& m) -> Vec3 { return m.spin(t); }, motion);
}
Vec3 angular_acceleration(const AnyMotion& motion, double t) {
  return std::visit([t](const auto& m) -> Vec3 { return m.angular_acceleration(t); }, motion);
}
Bounds bounds(const AnyMotion& motion) {
  return std::visit([](const auto& m) { return m.bounds(); }, motion);
}
double period(const AnyMotion& motion) {
  return std::visit([](const auto& m) -> double { return m.period(); }, motion);
}
Vec3 fixed_axis(const AnyMotion& motion) {
  return std::visit([](const auto& m) -> Vec3 { return m.fixed_axis(); }, motion);
}

const void* held(const AnyMotion& motion, const std::type_info& type) {
  return std::visit([&](const auto& m) -> const void* { return typeid(m) == type ? &m : nullptr; },
                    motion);
}

}  // namespace mahlwerk::kinematics

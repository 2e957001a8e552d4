// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/reversal.hpp"

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

/// The angular speed that reverses the motion if its sign changes; null if there is none.
double* speed_of(kinematics::AnyMotion& motion) {
  if (auto* planetary = std::get_if<kinematics::Planetary>(&motion)) return &planetary->speed;
  if (auto* drum = std::get_if<kinematics::Tumbling>(&motion)) return &drum->speed;
  if (auto* circular = std::get_if<kinematics::Circular>(&motion)) return &circular->speed;
  return nullptr;
}

double* speed_of_stirrer(geometry::AnyShape& shape) {
  auto* vessel = std::get_if<geometry::Attritor>(&shape);
  return vessel == nullptr ? nullptr : &vessel->rotor_speed;
}

Case reversed(const Case& c) {
  Case made = c;
  for (double* speed : {speed_of(*made.mill.motion), speed_of_stirrer(*made.jar.shape)})
    if (speed != nullptr) *speed = -*speed;
  for (MachinePart& part : made.machine_parts) part.body.motion.speed = -part.body.motion.speed;
  made.milling->reverse = false;
  return made;
}

}  // namespace

bool has_sense_of_rotation(const Case& c) {
  Case copy = c;
  const auto turns = [](const double* speed) { return speed != nullptr && *speed != 0; };
  for (const MachinePart& part : c.machine_parts)
    if (turns(&part.body.motion.speed)) return true;
  return turns(speed_of(*copy.mill.motion)) || turns(speed_of_stirrer(*copy.jar.shape));
}

bool needs_both_senses(const Case& c) {
  if (!c.milling || !c.milling->reverse) return false;
  // All other shapes have the plane of x and z as a plane of symmetry.
  const bool any_jar =
      geometry::as<geometry::Mesh>(*c.jar.shape) != nullptr || !c.machine_parts.empty();
  kinematics::AnyMotion motion = *c.mill.motion;
  const bool shaken =
      speed_of(motion) == nullptr && !std::holds_alternative<kinematics::Still>(motion);
  return any_jar || shaken || c.gravity_vector().y != 0;
}

CaseBySense::CaseBySense(const Case& c) : own_(&c) {
  if (needs_both_senses(c)) reversed_ = reversed(c);
}

}  // namespace mahlwerk::cases

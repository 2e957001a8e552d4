// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "mahlwerk/geometry/shapes.hpp"

// Jars with internal parts, for tests.
namespace mahlwerk::tests {

inline geometry::LifterCylinder lifters(int count = 8,
                                        double face_angle = 70 * std::numbers::pi / 180) {
  geometry::LifterCylinder jar;
  jar.diameter = 0.2, jar.height = 0.1;
  jar.lifters = count, jar.lifter_height = 0.012, jar.lifter_width = 0.02;
  jar.lifter_face_angle = face_angle;
  jar.complete();
  return jar;
}
inline geometry::PeriodicLifterCylinder periodic_lifters() {
  geometry::PeriodicLifterCylinder jar;
  jar.diameter = 0.2, jar.length = 0.1;
  jar.lifters = 8, jar.lifter_height = 0.012, jar.lifter_width = 0.02;
  jar.lifter_face_angle = 70 * std::numbers::pi / 180;
  jar.complete();
  return jar;
}
inline geometry::Attritor stirrer() {
  geometry::Attritor jar;
  jar.diameter = 0.1, jar.height = 0.12, jar.shaft_diameter = 0.02, jar.shaft_clearance = 0.01;
  jar.arms = 4, jar.arm_diameter = 0.008, jar.arm_span = 0.08;
  jar.arm_clearance = 0.02, jar.arm_spacing = 0.02, jar.rotor_speed = 30;
  jar.complete();
  return jar;
}

}  // namespace mahlwerk::tests

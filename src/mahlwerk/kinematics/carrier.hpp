// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/kinematics/motions.hpp"

// What carries a jar: the disc of a planetary mill. Seen from it the force field on the charge is
// steady, so that balls keep to a pattern.
namespace mahlwerk::kinematics {

/// How the carrier has turned since the start, and its angular velocity [rad/s]; none for mills
/// without one: their carrier is the laboratory.
struct Carrier {
  Rotation turn;
  Vec3 spin;
};

template <class M>
Carrier carrier(const M&, double) {
  return {};
}
inline Carrier carrier(const Planetary& m, double t) {
  return {turning(upright, m.speed * t), {0, 0, m.speed}};
}
/// Its force field goes round with the circle.
inline Carrier carrier(const Circular& m, double t) {
  return {turning(upright, m.speed * t), {0, 0, m.speed}};
}

/// The unit normal of the plane in which a mill's motion shows.
template <class M>
Vec3 plane_normal(const M& m) {
  const Vec3 axis = m.fixed_axis();
  return axis == Vec3{} ? Vec3{0, 1, 0} : axis;
}
inline Vec3 plane_normal(const Planetary&) {
  return upright;
}
inline Vec3 plane_normal(const Circular&) {
  return upright;
}

}  // namespace mahlwerk::kinematics

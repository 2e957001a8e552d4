// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/scene/machine_part.hpp"

namespace mahlwerk::soft {

/// Fraction of the radius: range beyond touch in which the wall point is still computed, for
/// contacts that have just ended (dem.36).
constexpr double past_touch = 0.01;

/// The drive (motion of the jar) sampled at one step, in the jar frame.
struct DriveSample {
  Vec3 body_acceleration;  ///< [m/s2] gravity minus the acceleration of the jar's centre
  Vec3 velocity;           ///< [m/s] of the jar's centre
  Vec3 spin;               ///< [rad/s] of the jar
  Vec3 rotor_spin;         ///< [rad/s] of the rotor's faces
};

/// Largest number of different motions of the parts in a jar.
constexpr std::size_t max_part_motions = 8;

/// At an instant, the rotations from the axes of a face's geometry to those of the jar frame.
struct JarAxes {
  Rotation own, rotor;  ///< of the jar's faces, of the rotor's
};
/// The same, and the poses of the motions of parts.
struct WallAxes : JarAxes {
  std::array<scene::PartPose, max_part_motions> parts;
};

}  // namespace mahlwerk::soft

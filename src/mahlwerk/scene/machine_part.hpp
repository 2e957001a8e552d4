// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/kinematics/part_motion.hpp"

namespace mahlwerk::geometry {
struct AnySolid;
}

namespace mahlwerk::scene {

/// A rigid body of the mill in the jar: a stirrer, a baffle, a floor that moves. Its frame is that
/// of the jar's own axes, or the laboratory.
struct MachinePart {
  Indirect<geometry::AnySolid> solid;
  Rotation axes;  ///< from its own axes to those of its frame, before it moves
  Vec3 position;  ///< [m] of its origin in its frame, before it moves
  kinematics::PartMotion motion;
  bool in_laboratory = false;  ///< whether its frame is the laboratory
  /// [m] balls below this diameter pass through it, as through a grate; 0: none
  double opening = 0;
  bool operator==(const MachinePart&) const = default;
};

/// Where a motion has taken its frame, in the jar frame: a point that is at x in the frame before
/// the motion is at origin + axes x, and the material at p moves at velocity + spin x p.
struct PartPose {
  Rotation axes;
  Vec3 origin;    ///< [m]
  Vec3 velocity;  ///< [m/s] of the material at the origin of the jar frame
  Vec3 spin;      ///< [rad/s]

  Vec3 velocity_at(const Vec3& p) const { return velocity + cross(spin, p); }
};

/// The pose at time `t` of a motion in the jar's own axes or the laboratory (kin.22); `jar` and
/// `mount` are those of the chamber. Where the speed of the mill varies, the part has its
/// clock.
inline PartPose part_pose(const kinematics::PartMotion& motion, bool in_laboratory,
                          const kinematics::AnyMotion& jar, const Rotation& mount, double t) {
  const kinematics::Clock clock = kinematics::clock(jar, t);
  const kinematics::Displacement d = motion.at(clock.time);
  const Vec3 spin = clock.rate * d.spin;
  const Vec3 velocity = clock.rate * d.velocity - cross(spin, d.centre);
  const Vec3 origin = d.centre - d.rotation * motion.pivot;
  const kinematics::Pose now = kinematics::pose(jar, t);
  if (in_laboratory) {
    const Vec3& c = now.frame.centre;
    return {d.rotation, origin - c, velocity + cross(spin, c) - now.frame.velocity, spin};
  }
  const Rotation q = now.rotation * mount;
  return {q * d.rotation, q * origin, q * velocity, now.spin + q * spin};
}

}  // namespace mahlwerk::scene

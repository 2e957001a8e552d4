// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "mahlwerk/kinematics/motion.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"

// The motion of a part in the frame that it belongs to: the jar's own axes or the laboratory
// (kin.22).
namespace mahlwerk::kinematics {

/// Rigid displacement of a part at an instant: a point that is at x0 when the part is at rest is at
/// centre + rotation (x0 - pivot).
struct Displacement {
  Rotation rotation;
  Vec3 centre;    ///< [m] where the pivot is
  Vec3 velocity;  ///< [m/s] of the pivot
  Vec3 spin;      ///< [rad/s]
};

struct PartMotion {
  enum class Kind {
    fixed,        ///< at rest in its frame
    turning,      ///< about an axis, at constant speed
    oscillating,  ///< to and fro along a direction
    swinging,     ///< to and fro about an axis
    tabulated     ///< measured: three coordinates and three angles
  };
  Kind kind = Kind::fixed;
  Vec3 pivot;          ///< [m] a point of the axis; of a tabulated motion, the point that the table
                       ///< moves
  Vec3 axis{0, 0, 1};  ///< unit vector: of the rotation, or the direction of the oscillation
  double speed = 0;    ///< [rad/s] of a turning part
  double frequency = 0;  ///< [Hz] of an oscillating or swinging part
  double amplitude = 0;  ///< [m] half the stroke
  double swing = 0;      ///< [rad] largest angle to either side
  double phase = 0;      ///< [rad] of the sine at time 0
  Tabulated path;        ///< tabulated: coordinates, and the angle about z
  Tabulated lean;        ///< tabulated: the angles about x and y as its coordinates x and y

  bool moves() const { return kind != Kind::fixed; }
  bool turns() const { return kind == Kind::turning && speed != 0; }
  bool operator==(const PartMotion&) const = default;

  Displacement at(double t) const {
    const double w = 2 * std::numbers::pi * frequency;
    switch (kind) {
      case Kind::turning:
        return {rotation_about(axis, speed * t), pivot, {}, speed * axis};
      case Kind::oscillating: {
        const SinCos s = sin_cos(w * t + phase);
        return {{}, pivot + amplitude * s.sin * axis, amplitude * w * s.cos * axis, {}};
      }
      case Kind::swinging: {
        const SinCos s = sin_cos(w * t + phase);
        return {rotation_about(axis, swing * s.sin), pivot, {}, swing * w * s.cos * axis};
      }
      case Kind::tabulated:
        return measured(t);
      case Kind::fixed:
        break;
    }
    return {{}, pivot, {}, {}};
  }

  /// Upper bounds of the speed of the pivot [m/s] and of the spin [rad/s].
  double speed_bound() const {
    if (kind == Kind::tabulated) return path.bounds().speed;
    return kind == Kind::oscillating ? std::abs(2 * std::numbers::pi * frequency * amplitude) : 0;
  }
  double spin_bound() const {
    if (kind == Kind::turning) return std::abs(speed);
    if (kind == Kind::swinging) return std::abs(2 * std::numbers::pi * frequency * swing);
    return kind == Kind::tabulated ? path.bounds().spin + 2 * lean.bounds().speed : 0;
  }
  /// [s] of the motion; infinite for a part at rest.
  double period() const {
    if (kind == Kind::tabulated) return path.period();
    if (kind == Kind::turning && speed != 0) return 2 * std::numbers::pi / std::abs(speed);
    return frequency != 0 ? 1 / std::abs(frequency) : no_period;
  }

 private:
  /// Rotated about x, then y, then z, by the angles of the table (kin.23).
  Displacement measured(double t) const {
    const FrameMotion place = path.frame_motion(t), angles = lean.frame_motion(t);
    const Rotation about_z = path.rotation(t), about_y = rotation_about({0, 1, 0}, angles.centre.y),
                   about_x = rotation_about({1, 0, 0}, angles.centre.x);
    const Vec3 spin = path.spin(t) + about_z * Vec3{0, angles.velocity.y, 0} +
                      about_z * (about_y * Vec3{angles.velocity.x, 0, 0});
    return {about_z * (about_y * about_x), pivot + place.centre, place.velocity, spin};
  }
};

}  // namespace mahlwerk::kinematics

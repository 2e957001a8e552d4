// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

#include "mahlwerk/base/quaternion.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::scene {

/// A sphere and its motion, in the jar frame (axes of the laboratory, origin at the jar's centre);
/// or a body of another shape (BodyShape) of its ball set.
struct Ball {
  double radius = 0;      ///< [m]; of a body the radius of the sphere of the same volume
  double density = 0;     ///< [kg/m3] mass over volume of the sphere
  Vec3 position;          ///< [m]
  Vec3 velocity;          ///< [m/s]
  Vec3 spin;              ///< [rad/s]
  std::int32_t kind = 0;  ///< number of its ball set
  double inertia_ratio =
      0.4;               ///< [1] I/(m R^2) (hol.2): 2/5 of a solid sphere, 2/3 of a thin shell
  bool outside = false;  ///< not in the jar: it waits to be fed, or stays where it left
  Quaternion orientation = {};  ///< of a body, from its principal axes to those of the laboratory

  double mass() const { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density; }
  double inertia() const { return inertia_ratio * mass() * radius * radius; }
};

}  // namespace mahlwerk::scene

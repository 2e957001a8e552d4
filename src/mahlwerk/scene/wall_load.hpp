// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::scene {

/// What the jar or a part has done to the balls since the start of a run (obs.22).
struct WallLoad {
  Vec3 impulse;                ///< [N s] on the balls, in the axes of its frame
  double angular_impulse = 0;  ///< [N m s] on the balls, about its axis of motion
  double work = 0;             ///< [J] on the balls
  /// [N m s] on the balls, about the axis of the mill: of the jar, by all that turns with it; of a
  /// jar at rest, by its stirrer
  double about_mill_axis = 0;
};

}  // namespace mahlwerk::scene

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// Largest |g - c''| in a period of the mill [m/s2], or its bound where there is no period. A
/// positive minimum keeps bounces from collapsing where nothing presses bodies together (man.4).
/// `frame_motion(t)` is the motion of the jar's centre, `bound` [m/s2] the bound on the components
/// of its acceleration, `period` [s].
template <class FrameMotionAt>
double strongest_field(const Vec3& gravity, const Vec3& bound, double period,
                       const FrameMotionAt& frame_motion) {
  constexpr double least = 0.1;  // [m/s2]
  constexpr int samples = 256;
  if (!std::isfinite(period)) return std::max(least, norm(bound) + norm(gravity));
  double most = least;
  for (int i = 0; i < samples; ++i)
    most = std::max(most, norm(gravity - frame_motion(period * i / samples).acceleration));
  return most;
}

}  // namespace mahlwerk::kinematics

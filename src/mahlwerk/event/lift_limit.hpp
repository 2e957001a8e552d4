// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "mahlwerk/base/index.hpp"
#include "mahlwerk/event/sustained_contact.hpp"

// How long a step of a sustained contact may be: within it the mill must not lift the ball off its
// wall and press it back, because the normal force is checked at the end of a step only (evt.18).
namespace mahlwerk::event {

/// Whether the acceleration of the jar's centre may pull a face from the ball at `position` [m, jar
/// frame] within `h` [s] of `t`, by samples of the acceleration. Between two samples it falls by
/// half of what the jerk allows, or, in a periodic motion, by a quarter of their second difference:
/// twice the error of linear interpolation.
template <class J>
bool may_be_lifted(const J& jar, const SupportFaces& support, const ContactForces& forces,
                   const Vec3& position, double radius, double t, double h) {
  constexpr int samples = 16;  // in a quarter of a period or less
  std::array<Vec3, samples + 1> at;
  for (int k = 0; k <= samples; ++k)
    at[as_index(k)] = jar.motion().frame_motion(t + h * k / samples).acceleration;
  const bool periodic = std::isfinite(jar.motion().period());
  for (std::size_t i = 0; i < support.count; ++i) {
    const Vec3 n = jar.wall(support.face[i], position, t, radius).inward;
    double least = 0, bend = 0;
    for (int k = 1; k <= samples; ++k) least = std::min(least, dot(n, at[as_index(k)] - at[0]));
    for (int k = 1; k < samples; ++k)
      bend = std::max(
          bend, std::abs(dot(n, at[as_index(k - 1)] - 2 * at[as_index(k)] + at[as_index(k + 1)])));
    double between = 0.5 * jar.motion_bounds().jerk * h / samples;
    if (periodic) between = std::min(between, 0.25 * bend);
    if (forces.normal_force[i] + least < between) return true;
  }
  return false;
}

/// Longest step [s] from `t`, at most `wanted`, in which the acceleration of the jar's centre
/// cannot lift the ball off and press it back. `forces` are those at `t`.
template <class J>
double lift_limit(const J& jar, const SupportFaces& support, const ContactForces& forces,
                  const Vec3& position, double radius, double t, double wanted) {
  constexpr double unseen = 1e-5;  // [s] a shorter flight does not matter
  const double jerk = jar.motion_bounds().jerk;
  if (!(jerk > 0)) return wanted;
  const double certain = unseen + std::max(forces.normal_force[forces.least(support)], 0.0) / jerk;
  if (wanted <= certain) return wanted;
  wanted = std::max(certain, std::min(wanted, jar.motion().period() / 4));
  while (wanted > certain && may_be_lifted(jar, support, forces, position, radius, t, wanted))
    wanted = std::max(certain, 0.5 * wanted);
  return wanted;
}

}  // namespace mahlwerk::event

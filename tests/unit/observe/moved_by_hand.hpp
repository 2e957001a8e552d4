// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/observe/motion_states.hpp"

// Balls in the jar of a mixer mill that are moved by hand, for states of motion (obs.20).
namespace mahlwerk::observe::moved_by_hand {

constexpr double frequency = 25, radius = 5e-3;
constexpr double half_length = 25e-3, half_width = 8e-3;  // [m] of the ball's centre

inline kinematics::ArcShaker mill() {
  return {.frequency = frequency, .arm = 0.136, .swing = 0.066};
}
inline scene::Chamber jar() {
  return {geometry::Cylinder{2 * (half_width + radius), 2 * (half_length + radius)},
          mill(),
          scene::mounted_along(kinematics::lying),
          {0, 0, -9.81}};
}

/// Position in the laboratory, of a ball in a jar whose centre is at `centre`, at a phase of the
/// mill [turns].
using Way = std::function<Vec3(double phase, const Vec3& centre)>;

/// Along the jar's axis x, and the angle about it [turns].
inline Vec3 at(double x, double turns, double off = half_width) {
  return {x, off * std::cos(2 * std::numbers::pi * turns),
          off * std::sin(2 * std::numbers::pi * turns)};
}
inline Vec3 circles(double phase, const Vec3&) {
  return at(0, 1.5 * phase);
}
inline Vec3 bounces(double phase, const Vec3& centre) {
  return at(centre.x + half_length * std::sin(2 * std::numbers::pi * phase + 0.3), 0);
}
inline Vec3 keeps_to_the_jar(double, const Vec3& centre) {
  return at(centre.x + 0.01, 0.75);
}
inline Vec3 stays(double, const Vec3&) {
  return at(0, 0.75);
}

/// Moves balls for some periods in which 2 J are lost in each, with three hits of 0.1 J.
class MovedCharge {
 public:
  explicit MovedCharge(std::size_t balls) : balls_(balls, {radius, 7850, {}, {}, {}}) {}
  void go(int periods, const std::vector<Way>& ways) {
    for (int i = 0; i < periods * MotionStates::samples; ++i) take(ways);
  }
  /// One sample; the first begins the first period.
  void take(const std::vector<Way>& ways) {
    const double phase = static_cast<double>(taken_++) / MotionStates::samples,
                 time = phase / frequency;
    const Vec3 centre = mill().frame_motion(time).centre;
    for (std::size_t i = 0; i < balls_.size(); ++i)
      balls_[i].position = ways[i](phase, centre) - Vec3{centre.x, 0, 0};
    states.sample(time, balls_, {.lost = 2 * phase, .hits = 3 * phase, .energy = 0.3 * phase});
  }
  MotionStates states{jar()};

 private:
  std::vector<scene::Ball> balls_;
  std::int64_t taken_ = 0;
};

}  // namespace mahlwerk::observe::moved_by_hand

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/scene/typed_chamber.hpp"

namespace mahlwerk::event {

using scene::BallState;
using scene::TypedChamber;
using scene::Wall;

/// A ball in flight: a parabola in laboratory axes (evt.1, evt.2).
struct Flight {
  double since = 0;         ///< [s] start of the flight, on the clock of the search
  Vec3 position, velocity;  ///< [m], [m/s] at `since`, in laboratory axes

  Vec3 lab_position(double t, const Vec3& gravity) const {
    const double s = t - since;
    return position + s * (velocity + 0.5 * s * gravity);
  }
  Vec3 lab_velocity(double t, const Vec3& gravity) const {
    return velocity + (t - since) * gravity;
  }
  /// The state in the jar frame.
  BallState ball_state(double t, const Vec3& gravity, const kinematics::FrameMotion& frame) const {
    return {lab_position(t, gravity) - frame.centre, lab_velocity(t, gravity) - frame.velocity};
  }
};

/// The ball's radius and the tolerance of the touch search (evt.5).
struct TouchTolerance {
  double radius = 0;  ///< [m]
  double margin = 0;  ///< [m] a gap below this is a touch; far below the precision of radii

  /// Least step [s]: a time in which ball and wall, approaching at no more than `speed` [m/s], do
  /// not cross the margin.
  double min_step(double speed) const { return margin / (speed + 1e-3); }
  /// Depth [m], negligible against the radius, to which a ball that neither approaches nor leaves a
  /// wall may sink in.
  double grazing_depth() const { return 1e3 * margin; }
  /// min_step() of a ball and a wall at rest, the largest of all.
  double longest_min_step() const { return min_step(0); }
};

/// The tolerance of the touch search in `jar` (evt.5).
template <class S, class M>
TouchTolerance touch_tolerance(const TypedChamber<S, M>& jar, double radius) {
  const auto& bounds = jar.motion_bounds();
  const double path =
      bounds.jerk > 0 ? bounds.speed * bounds.speed / (norm(bounds.acceleration) + 1e-300) : 0.0;
  const double scale = jar.shape().reach() + norm(jar.motion().frame_motion(0).centre) + path;
  return {radius, std::max(1e-12 * radius, 64 * 0x1p-52 * scale)};
}

/// State at an instant: the clock, the jar's frame motion, and the ball in the jar frame.
struct Instant {
  double time = 0;  ///< [s] on the clock of the search
  kinematics::FrameMotion frame;
  BallState ball;
};

struct Touch {
  Instant when;            ///< of the touch, or the last instant tested
  int face = -1;           ///< < 0: none so far
  std::int64_t steps = 0;  ///< of the search
};

/// Closing speeds below this are rounding, not an approach [m/s].
constexpr double rounding_speed = 1e-10;

/// Speed at which wall and ball approach each other along the normal [m/s].
template <class S, class M>
double closing_speed(const TypedChamber<S, M>& jar, int face, const Instant& now,
                     const TouchTolerance& ball) {
  const Wall wall = jar.wall(face, now.ball.position, now.time, ball.radius);
  return dot(wall.velocity - now.ball.velocity, wall.inward);
}

/// Safe time [s] of a ball that grazes a face, neither approaching nor leaving it. With its true
/// radius it would advance by one margin a step. So the ball may sink in by the grazing depth. A
/// ball that is already deeper gains nothing.
template <class S, class M>
double grazing_safe_time(const TypedChamber<S, M>& jar, int face, const Instant& now,
                         const TouchTolerance& ball) {
  return jar.safe_time(face, now.ball, now.time, ball.radius - ball.grazing_depth()).time;
}

/// Result of testing all faces at an instant.
struct FaceScan {
  double safe_time = geometry::never;  ///< [s] no touch occurs within it
  /// Last approached face whose safe time is below those of all faces tested before it; < 0: none.
  int nearest = -1;
  int face = -1;  ///< touched now; < 0: none
};

template <class S, class M>
FaceScan scan_faces(const TypedChamber<S, M>& jar, const Instant& now, const TouchTolerance& ball) {
  const double radius = ball.radius - ball.margin;
  FaceScan scan;
  for (int face = 0; face < S::faces; ++face) {
    if (S::faces > 1 && !jar.shape().can_touch(face, ball.radius)) continue;
    geometry::SafeTime safe = jar.safe_time(face, now.ball, now.time, radius);
    if (safe.gap <= 2 * ball.margin) {
      const double speed = closing_speed(jar, face, now, ball);
      if (safe.closing > 0 && speed > rounding_speed) {
        scan.face = face;
        return scan;
      }
      if (std::abs(speed) <= rounding_speed)
        safe.time = std::max(safe.time, grazing_safe_time(jar, face, now, ball));
    }
    if (safe.closing > 0 && safe.time < scan.safe_time) scan.nearest = face;
    scan.safe_time = std::min(scan.safe_time, safe.time);
  }
  return scan;
}

/// Maximum steps of one search. A flight usually takes fewer than ten. A ball that grazes a wall
/// may take so many that the caller must be able to process other events in between.
constexpr std::int64_t max_search_steps = 4096;

/// Finds the first touch of a flight from `start` on, no later than about `until` [s]: the first
/// time at which a gap is (nearly) closed and shrinking. Conservative advancement: the steps are
/// safe times, so no touch is passed (evt.3 to evt.5). After max_search_steps it returns no face
/// and the instant reached, before `until`, from which the search can continue.
template <class S, class M>
[[gnu::flatten]] Touch next_touch(const TypedChamber<S, M>& jar, const Flight& flight,
                                  const Instant& start, double until, const TouchTolerance& ball) {
  const double longest_min_step = ball.longest_min_step();
  Instant now = start;
  for (std::int64_t steps = 1;; ++steps) {
    const FaceScan scan = scan_faces(jar, now, ball);
    if (scan.face >= 0) return {now, scan.face, steps};
    const double before = now.time;
    double step = scan.safe_time;
    if (step < longest_min_step)  // hardly ever, so the speed is not needed
      step = std::max(step, ball.min_step(norm(now.ball.velocity) + jar.max_wall_speed()));
    now.time += step;
    if (now.time == before) {  // step below the clock's resolution: this is the touch
      if (scan.nearest >= 0 && closing_speed(jar, scan.nearest, now, ball) > rounding_speed)
        return {now, scan.nearest, steps};
      now.time = std::nextafter(before, geometry::never);
    }
    now.frame = jar.motion().frame_motion(now.time);
    now.ball = flight.ball_state(now.time, jar.gravity(), now.frame);
    if (!(now.time < until) || steps >= max_search_steps) return {now, -1, steps};
  }
}

}  // namespace mahlwerk::event

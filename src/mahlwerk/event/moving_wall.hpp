// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/event/search.hpp"

namespace mahlwerk::event {

/// Result of a search for wall contacts: the next touch, or a time before which none occurs.
struct WallPrediction {
  double time = 0;  ///< [s] of the touch, or until then there is certainly none
  int face = -1;    ///< < 0: no touch
};

/// Wall for the event engine of many balls (that of the soft engines is soft::MovingWall).
/// Type-erased jar on its mill: one virtual call per query. Times are mill times; positions and
/// velocities are those of the jar frame.
class MovingWall {
 public:
  virtual ~MovingWall() = default;

  virtual kinematics::FrameMotion frame_motion(double t) const = 0;
  /// Follows a ball that has the state `ball` at `t` [s] and flies freely, until it touches a face,
  /// `until` [s] is passed, or max_search_steps are done. Tests the faces at least once.
  virtual WallPrediction predict_touch(const BallState& ball, double t, double until,
                                       const TouchTolerance& tolerance) const = 0;
  virtual Wall wall(int face, const Vec3& position, double t, double radius) const = 0;
  virtual Vec3 to_jar_axes(const Vec3& a, double t) const = 0;
  virtual Vec3 spin(double t) const = 0;  ///< [rad/s] angular velocity of the jar

  const kinematics::Bounds& motion_bounds() const { return motion_bounds_; }
  const Vec3& gravity() const { return gravity_; }
  /// Whether walls and frame motion are the same after each period, or at all times if there is
  /// none. Not while the mill speeds up, nor if the walls turn.
  bool repeats() const { return repeats_; }
  int faces() const { return faces_; }
  double period() const { return period_; }  ///< [s] of the frame motion; no_period: not periodic
  /// [m] radius of a sphere round the jar's centre that holds the jar.
  double reach() const { return reach_; }
  /// [m] distance of the jar's centre from the origin of the frame motion at mill time 0.
  double offset() const { return offset_; }
  const Vec3& periods() const { return periods_; }  ///< [m] infinite where not periodic

 protected:
  kinematics::Bounds motion_bounds_;
  Vec3 gravity_, periods_;
  bool repeats_ = true;
  int faces_ = 0;
  double period_ = 0, reach_ = 0, offset_ = 0;
};

template <class S, class M>
class ChamberWall final : public MovingWall {
 public:
  explicit ChamberWall(const TypedChamber<S, M>& jar) : jar_(jar) {
    motion_bounds_ = jar.motion_bounds();
    gravity_ = jar.gravity();
    periods_ = geometry::periods_of(jar.shape());
    repeats_ = jar.static_geometry();
    if constexpr (requires { jar.motion().speed_varies(); })
      repeats_ = repeats_ && !jar.motion().speed_varies();
    faces_ = S::faces;
    period_ = jar.motion().period();
    reach_ = jar.shape().reach();
    offset_ = norm(jar.motion().frame_motion(0).centre);
  }

  kinematics::FrameMotion frame_motion(double t) const override {
    return jar_.motion().frame_motion(t);
  }
  WallPrediction predict_touch(const BallState& ball, double t, double until,
                               const TouchTolerance& tolerance) const override {
    const FaceScan first = scan_faces(jar_, {t, {}, ball}, tolerance);
    if (first.face >= 0) return {t, first.face};
    double step = first.safe_time;
    if (step < tolerance.longest_min_step())
      step = std::max(step, tolerance.min_step(norm(ball.velocity) + jar_.max_wall_speed()));
    if (!(t + step < until)) return {std::max(t + step, std::nextafter(t, geometry::never)), -1};
    const kinematics::FrameMotion frame = jar_.motion().frame_motion(t);
    const Flight flight{t, ball.position + frame.centre, ball.velocity + frame.velocity};
    const Touch touch = next_touch(jar_, flight, {t, frame, ball}, until, tolerance);
    return {touch.when.time, touch.face};
  }
  Wall wall(int face, const Vec3& position, double t, double radius) const override {
    return jar_.wall(face, position, t, radius);
  }
  Vec3 to_jar_axes(const Vec3& a, double t) const override { return jar_.to_jar_axes(a, t); }
  Vec3 spin(double t) const override { return jar_.motion().spin(t); }

 private:
  TypedChamber<S, M> jar_;
};

}  // namespace mahlwerk::event

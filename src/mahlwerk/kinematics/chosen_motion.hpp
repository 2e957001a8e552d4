// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include "mahlwerk/kinematics/any_motion.hpp"

namespace mahlwerk::kinematics {

/// A motion chosen at run time that has the interface of a Motion except for its name. Engines know
/// the jar's shape at compile time, and its motion through this class.
class ChosenMotion {
 public:
  explicit ChosenMotion(Indirect<AnyMotion> motion) : motion_(std::move(motion)) {}

  Pose pose(double t) const { return kinematics::pose(*motion_, t); }
  FrameMotion frame_motion(double t) const { return kinematics::frame_motion(*motion_, t); }
  Rotation rotation(double t) const { return kinematics::rotation(*motion_, t); }
  Vec3 spin(double t) const { return kinematics::spin(*motion_, t); }
  Vec3 angular_acceleration(double t) const {
    return kinematics::angular_acceleration(*motion_, t);
  }
  Clock clock(double t) const { return kinematics::clock(*motion_, t); }
  double largest_rate() const { return kinematics::largest_rate(*motion_); }
  Bounds bounds() const { return kinematics::bounds(*motion_); }
  double period() const { return kinematics::period(*motion_); }
  bool speed_varies() const { return kinematics::speed_varies(*motion_); }
  Vec3 fixed_axis() const { return kinematics::fixed_axis(*motion_); }

 private:
  Indirect<AnyMotion> motion_;
};

/// A ChosenMotion that caches the pose of the last instant, because a search queries the same
/// instant several times. Not thread-safe.
class CachedMotion {
 public:
  explicit CachedMotion(Indirect<AnyMotion> motion) : motion_(std::move(motion)) {}

  FrameMotion frame_motion(double t) const { return at(t).frame; }
  Rotation rotation(double t) const { return at(t).rotation; }
  Vec3 spin(double t) const { return at(t).spin; }
  Vec3 angular_acceleration(double t) const { return at(t).angular_acceleration; }
  Bounds bounds() const { return motion_.bounds(); }
  double period() const { return motion_.period(); }
  bool speed_varies() const { return motion_.speed_varies(); }
  Vec3 fixed_axis() const { return motion_.fixed_axis(); }

 private:
  const Pose& at(double t) const {
    if (t != last_) pose_ = motion_.pose(t), last_ = t;
    return pose_;
  }

  ChosenMotion motion_;
  mutable double last_ = std::numeric_limits<double>::quiet_NaN();
  mutable Pose pose_;
};

}  // namespace mahlwerk::kinematics

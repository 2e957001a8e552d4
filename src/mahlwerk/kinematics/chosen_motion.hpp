// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::kinematics {

/// Where a jar is at an instant, and how it turns.
struct Pose {
  Ride ride;
  Rotation turn;   ///< since it was mounted
  Vec3 spin;       ///< [rad/s]
  Vec3 spin_rate;  ///< [rad/s2]
};

/// A motion chosen at run time, itself a motion but for its name: engines know the jar's shape when
/// they are compiled, and its motion by this.
class ChosenMotion {
 public:
  explicit ChosenMotion(AnyMotion motion);

  Pose pose(double t) const;
  Ride ride(double t) const;
  Rotation turn(double t) const;
  Vec3 spin(double t) const;
  Vec3 spin_rate(double t) const;
  Bounds bounds() const;
  double period() const;
  Vec3 fixed_axis() const;

 private:
  AnyMotion motion_;
};

/// The same, that remembers the last instant: a search asks several times of one. Not for several
/// threads at a time.
class RememberedMotion {
 public:
  explicit RememberedMotion(AnyMotion motion) : motion_(std::move(motion)) {}

  Ride ride(double t) const { return at(t).ride; }
  Rotation turn(double t) const { return at(t).turn; }
  Vec3 spin(double t) const { return at(t).spin; }
  Vec3 spin_rate(double t) const { return at(t).spin_rate; }
  Bounds bounds() const { return motion_.bounds(); }
  double period() const { return motion_.period(); }
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

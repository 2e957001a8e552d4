// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/observe/alignment.hpp"
#include "mahlwerk/observe/fields.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::observe {

/// Density and motion of the charge in the jar, from samples of all balls at intervals: fields in
/// the plane of motion, mass by angle about the jar's axis, slip at the wall. Uses fixed memory.
class Charge {
 public:
  static constexpr int angles = 180;  ///< of two degrees

  Charge() = default;  ///< ignores samples
  /// `radius` [m] is the largest distance of the wall from the jar's own axis. `with_axis`: which
  /// kinds of balls are bodies with an axis of revolution; none: no kind is.
  Charge(const scene::Chamber& mill, double radius, std::vector<bool> with_axis = {});

  /// Adds a sample: the balls in the jar frame at `time` [s], for a duration of `weight` [s].
  void sample(double time, const std::vector<scene::Ball>& balls, double weight);

  /// The plane's axes at time 0, to the right and up, seen against its normal.
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }

  PlaneField in_jar;      ///< in the frame of the rotating jar
  PlaneField in_carrier;  ///< in the carrier's frame: the disc, or the laboratory's axes
  /// [kg s] Mass times time by angle about the jar's axis in the plane, from `right`, in the
  /// carrier's frame.
  std::vector<double> mass_by_angle;
  double mass_at_wall = 0;  ///< [kg s] of balls within a hundredth of their radius from the wall
  double wall_slip = 0;     ///< [kg m] mass of balls at the wall times slip speed and time
  double mass_total = 0;    ///< [kg s] of all balls
  double spin_squared = 0;  ///< [kg rad2/s] mass times squared angular velocity and time
  /// [m4/s3] Square of the charge's mean squared speed seen from the jar, times time: with the mean
  /// of that squared speed it tells a steady motion from one that stops and starts.
  double jar_speed_fourth = 0;
  /// [kg s] Mass outside the bed, and of all balls, in the samples in which it is sought: every
  /// fourth. Only for drums and planetary mills.
  double mass_outside = 0, mass_sought = 0;
  Alignment alignment;  ///< of bodies with an axis, in the carrier's frame

  void merge(const Charge& other);
  void pack();    ///< nothing is added from then on
  void let_go();  ///< forgets the fields, but not the sums
  void serialize(Archive& archive);

 private:
  void add_wall_contact(const scene::Ball& ball, const Rotation& own, const Vec3& spin,
                        double weight);
  void find_bed(const std::vector<scene::Ball>& balls, const Rotation& own, double weight);
  void add_axis(const scene::Ball& ball, const Rotation& carrier, const Vec3& jar_axis,
                double weight);
  scene::Chamber mill_;
  double radius_ = 0;
  std::vector<bool> with_axis_;
  std::int64_t samples_ = 0;
  Vec3 right_{1, 0, 0}, up_{0, 1, 0};
};

}  // namespace mahlwerk::observe

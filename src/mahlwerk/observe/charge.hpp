// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/observe/fields.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::observe {

/// How the charge lies and moves in the jar, from looks at all balls now and then: fields in the
/// plane in which the motion shows, mass by angle about the jar's axis, slip at the wall. In fixed
/// memory.
class Charge {
 public:
  static constexpr int angles = 180;  ///< of two degrees

  Charge() = default;  ///< sees nothing
  /// `radius` [m] is the largest distance of the wall from the jar's own axis.
  Charge(const scene::Chamber& mill, double radius);

  /// The balls in the jar frame at `time` [s]; they stand for `weight` [s].
  void sample(double time, const std::vector<scene::Ball>& balls, double weight);

  /// The plane's axes: to the right and up, seen from where its normal points to, at time 0.
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }

  PlaneField in_jar;      ///< seen from the turning jar
  PlaneField in_carrier;  ///< seen from what carries it: the disc, or the laboratory's axes
  /// [kg s] at each angle about the jar's axis in the plane, from `right` on, seen from the
  /// carrier.
  std::vector<double> mass_by_angle;
  double mass_at_wall = 0;  ///< [kg s] of balls within a hundredth of their radius from the wall
  double wall_slip = 0;     ///< [kg m] of those, times the speed at which they slip
  double mass_total = 0;    ///< [kg s]

  void merge(const Charge& other);
  void serialize(Archive& archive);

 private:
  void add_wall_contact(const scene::Ball& ball, const Rotation& own, const Vec3& spin,
                        double weight);
  scene::Chamber mill_;
  Vec3 right_{1, 0, 0}, up_{0, 1, 0};
};

}  // namespace mahlwerk::observe

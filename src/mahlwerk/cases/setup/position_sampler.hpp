// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/geometry/any_shape.hpp"

namespace mahlwerk::cases {

/// [m] Clearance between a ball and the wall: `share` of the radius, but at most half of the
/// available clearance in a jar hardly larger than the ball.
double wall_clearance(const geometry::AnyShape& shape, double radius, double share);

/// Random positions for balls of one size in a jar, uniform over the positions without wall
/// contact, by rejection sampling. Positions are in the jar's own axes.
class PositionSampler {
 public:
  /// `obstacles` are kept clear of, if not null.
  PositionSampler(const geometry::AnyShape& shape, double radius,
                  const Obstacles* obstacles = nullptr);

  Vec3 draw(Random& random) const;
  /// [m] Half the sides of a box about the origin that holds all such positions.
  const Vec3& box() const { return box_; }

 private:
  template <class S>
  void measure(const S& shape);
  template <class S>
  bool free(const S& shape, const Vec3& p) const;
  template <class S>
  double extent(const S& shape, const Vec3& axis) const;
  template <class S>
  bool square(const S& shape, const Vec3& p, const Vec3& axis) const;

  bool clear_of_parts(const Vec3& p) const;

  const geometry::AnyShape* shape_;
  const Obstacles* obstacles_;
  double radius_, needed_;
  Vec3 box_;
  Vec3 centre_, half_size_;  // of the box in which positions are drawn
  Vec3 middle_;              // centre of the largest ball that fits; the sampling box shrinks to it
};

}  // namespace mahlwerk::cases

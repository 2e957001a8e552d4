// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/any_shape.hpp"

namespace mahlwerk::cases {

/// What balls of one radius keep between themselves and the wall [m]: `share` of the radius, or
/// half of what there is in a jar hardly larger.
double wall_clearance(const geometry::AnyShape& shape, double radius, double share);

/// Random places in a jar for balls of one size, uniform over where such a ball is free. Positions
/// are in the jar's own axes.
class PositionSampler {
 public:
  PositionSampler(const geometry::AnyShape& shape, double radius);

  Vec3 draw(Random& random) const;
  /// Half the sides of a box that holds all such places.
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

  const geometry::AnyShape* shape_;
  double radius_, needed_;
  Vec3 box_;
  Vec3 centre_, half_;  // of the box in which places are drawn
  Vec3 middle_;         // where the largest ball fits
};

}  // namespace mahlwerk::cases

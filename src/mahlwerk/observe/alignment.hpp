// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::observe {

/// How the axes of bodies are aligned (bod.17, bod.18), from samples of all of them.
class Alignment {
 public:
  /// Adds a body with the unit vector `axis`, both ends of which are alike, in a frame in which the
  /// charge does not turn, for a duration of `weight` [s]. `to_jar`: cosine of its angle to the
  /// jar's axis.
  void add(const Vec3& axis, double to_jar, double weight);
  /// [1] Nematic order parameter: 1 if all axes are parallel, 0 if all directions are alike; NaN
  /// without samples.
  double nematic_order() const;
  /// [rad] Mean angle of the axes to the jar's axis, 0 to pi/2; of equal directions 1.
  double mean_angle() const;

  void merge(const Alignment& other);
  void serialize(Archive& archive) { archive(time_)(squares_)(products_)(angle_); }

 private:
  double time_ = 0;          // [s] of all bodies
  Vec3 squares_, products_;  // [s] sums of x^2, y^2, z^2, and of xy, yz, zx
  double angle_ = 0;         // [rad s]
};

}  // namespace mahlwerk::observe

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/body_feature.hpp"
#include "mahlwerk/scene/body_shape.hpp"

namespace mahlwerk::scene {

/// Whether bodies of that kind have such a feature.
bool has_feature(SolidKind kind, BodyFeature feature);

/// The core of a body: its solid less the radius of its edges. What is nearest in it to a point of
/// the surface tells the feature there (bod.16).
class BodyCore {
 public:
  BodyCore() = default;  ///< of a sphere
  /// Lengths are over the radius of the sphere of the same volume, as those of the shape.
  explicit BodyCore(const BodyShape& shape);
  /// The feature at `point`, along the principal axes of the body.
  BodyFeature feature_at(const Vec3& point) const;

 private:
  BodyFeature of_cylinder(const Vec3& point) const;
  BodyFeature of_rod(const Vec3& point) const;
  BodyFeature of_cube(const Vec3& point) const;

  SolidKind kind_ = SolidKind::none;
  double radius_ = 0, half_length_ = 0;  // of a cube, half its edge
};

}  // namespace mahlwerk::scene

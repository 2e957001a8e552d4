// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::parts::mixing {

/// A jar and the parts in it at an instant.
class Instant {
 public:
  /// `diameter` [m] of a ball of mean volume: one that passes through a part's openings sees no
  /// part.
  Instant(const scene::Chamber& mill, double time, double diameter);

  // Unit vectors in the jar frame: along the jar's axis, up, and level across both.
  Vec3 axis, up, across;
  Vec3 periods;  ///< [m] in the jar's own axes

  /// The balls in the jar's own axes.
  std::vector<scene::Ball> in_own_axes(const std::vector<scene::Ball>& balls) const;
  Vec3 in_jar_frame(const Vec3& own) const { return own_ * own; }
  /// [m] Distance of a point, in the jar's own axes, from the nearest wall or part; of walls exact
  /// up to `within` [m].
  double clearance(const Vec3& own, double within) const;

 private:
  struct Placed {
    const scene::MachinePart* part;
    Rotation axes;  // from the part's own axes to the jar's
    Vec3 position;  // [m] of its origin in them
  };
  const scene::Chamber& mill_;
  Rotation own_;  // from the jar's own axes to the jar frame
  std::vector<Placed> parts_;
};

}  // namespace mahlwerk::parts::mixing

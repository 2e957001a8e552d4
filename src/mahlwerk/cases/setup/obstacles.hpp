// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/geometry/shape.hpp"

namespace mahlwerk::cases {

/// The parts in the jar at the start of a run, in the jar's own axes, for placing balls.
class Obstacles {
 public:
  explicit Obstacles(const Case& c);

  struct Placed {
    const MachinePart* part;
    Rotation axes;  // from the part's own axes to the jar's
    Vec3 position;  // [m] of its origin
  };
  struct Nearest {
    double distance = geometry::never;  ///< [m] negative in a solid
    const MachinePart* part = nullptr;
  };

  const std::vector<Placed>& parts() const { return parts_; }
  bool empty() const { return parts_.empty(); }
  /// The part nearest to `p` of those that a ball of `radius` [m] touches.
  Nearest nearest(const Vec3& p, double radius) const;
  double clearance(const Vec3& p, double radius) const { return nearest(p, radius).distance; }
  /// Calls `f(gap)` for each place within `within` [m] where a ball of `radius` at `p` touches.
  template <class F>
  void near(const Vec3& p, double radius, double within, const F& f) const {
    for (const Placed& one : parts_)
      if (2 * radius >= one.part->body.opening)
        for (const geometry::Gap& gap : gaps(one, p, within)) f(gap);
  }

 private:
  /// A position in the own axes of a part, in a periodic jar that of the nearest image.
  Vec3 in_own_axes(const Placed& one, const Vec3& p) const;
  std::vector<geometry::Gap> gaps(const Placed& one, const Vec3& p, double within) const;

  std::vector<Placed> parts_;
  Vec3 periods_;  // [m] of the jar, in its own axes
};

}  // namespace mahlwerk::cases

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {

Obstacles::Obstacles(const Case& c) : periods_(geometry::periods(*c.jar.shape)) {
  const scene::Chamber mill = chamber(c);
  const Rotation jar = kinematics::rotation(*mill.motion, 0) * mill.mount;
  for (const MachinePart& part : c.machine_parts) {
    const scene::PartPose pose =
        scene::part_pose(part.body.motion, part.body.in_laboratory, *mill.motion, mill.mount, 0);
    const Rotation axes = pose.axes * part.body.axes;
    const Vec3 position = pose.origin + pose.axes * part.body.position;
    parts_.push_back(
        {&part,
         {jar.apply_inverse(axes.ex), jar.apply_inverse(axes.ey), jar.apply_inverse(axes.ez)},
         jar.apply_inverse(position)});
  }
}

Obstacles::Nearest Obstacles::nearest(const Vec3& p, double radius) const {
  Nearest found;
  for (const Placed& one : parts_) {
    if (2 * radius < one.part->body.opening) continue;
    const Vec3 own = in_own_axes(one, p);
    const double distance =
        std::visit([&](const auto& s) { return s.clearance(own); }, *one.part->body.solid);
    if (distance < found.distance) found = {distance, one.part};
  }
  return found;
}

Vec3 Obstacles::in_own_axes(const Placed& one, const Vec3& p) const {
  const Vec3 away = p - one.position;
  return one.axes.apply_inverse({std::remainder(away.x, periods_.x),
                                 std::remainder(away.y, periods_.y),
                                 std::remainder(away.z, periods_.z)});
}

std::vector<geometry::Gap> Obstacles::gaps(const Placed& one, const Vec3& p, double within) const {
  const Vec3 own = in_own_axes(one, p);
  std::vector<geometry::Gap> found;
  const auto add = [&](geometry::Gap gap) {
    if (gap.distance > within) return;
    gap.inward = one.axes * gap.inward;
    found.push_back(gap);
  };
  std::visit(
      [&]<class S>(const S& s) {
        for (int face = 0; face < s.faces; ++face) add(s.gap(face, own, within));
        if constexpr (std::is_same_v<S, geometry::MeshSolid>)  // no face is in front of a centre
          if (norm(own) <= s.reach() && s.clearance(own) < 0) add(s.nearest(own));
      },
      *one.part->body.solid);
  return found;
}

}  // namespace mahlwerk::cases

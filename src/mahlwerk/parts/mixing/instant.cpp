// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/mixing/instant.hpp"

#include <algorithm>
#include <variant>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/observe/images.hpp"

namespace mahlwerk::parts::mixing {

Instant::Instant(const scene::Chamber& mill, double time, double diameter)
    : periods(geometry::periods(*mill.shape)),
      mill_(mill),
      own_(kinematics::rotation(*mill.motion, time) * mill.mount) {
  axis = kinematics::rotation(*mill.motion, time) * mill.mount.ez;
  const double g = norm(mill.gravity);
  up = g > 0 ? -mill.gravity / g : Vec3{0, 0, 1};
  const Vec3 level = cross(axis, up);
  const Vec3 other = kinematics::rotation(*mill.motion, time) * mill.mount.ex;
  across = norm(level) > 0.1 ? level / norm(level) : other - dot(other, up) * up;
  for (const scene::MachinePart& part : mill.parts) {
    if (diameter < part.opening) continue;
    const scene::PartPose pose =
        scene::part_pose(part.motion, part.in_laboratory, *mill.motion, mill.mount, time);
    const Rotation axes = pose.axes * part.axes;
    parts_.push_back(
        {&part,
         {own_.apply_inverse(axes.ex), own_.apply_inverse(axes.ey), own_.apply_inverse(axes.ez)},
         own_.apply_inverse(pose.origin + pose.axes * part.position)});
  }
}

std::vector<scene::Ball> Instant::in_own_axes(const std::vector<scene::Ball>& balls) const {
  std::vector<scene::Ball> own = balls;
  for (scene::Ball& b : own) b.position = own_.apply_inverse(b.position);
  return own;
}

double Instant::clearance(const Vec3& own, double within) const {
  double least = geometry::nearest_wall(*mill_.shape, own, within);
  for (const Placed& one : parts_) {
    const Vec3 away = one.axes.apply_inverse(observe::folded(own - one.position, periods));
    least = std::min(least, std::visit([&](const auto& solid) { return solid.clearance(away); },
                                       *one.part->solid));
  }
  return least;
}

}  // namespace mahlwerk::parts::mixing

// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/setup/push_apart.hpp"

namespace mahlwerk::cases {

void remove_overlaps(const Case& c, std::vector<scene::Ball>& balls,
                     const std::atomic<bool>* stop) {
  constexpr double gap = 1e-6;             // over the sum of radii
  constexpr std::int64_t sweeps = 10'000;  // of all balls; resting charges need far fewer
  const geometry::AnyShape& shape = *c.jar.shape;
  const Rotation axes =
      kinematics::rotation(*c.mill.motion, 0) * scene::mounted_along(c.mill.jar_axis);
  const double reach = geometry::reach(shape);
  const Vec3 periods = geometry::periods(shape);
  const Domain domain{.half = {std::min(reach, 0.5 * periods.x), std::min(reach, 0.5 * periods.y),
                               std::min(reach, 0.5 * periods.z)},
                      .periods = periods};
  std::vector<PlacedBall> placed;
  for (const scene::Ball& b : balls) placed.push_back({axes.apply_inverse(b.position), b.radius});
  const auto most = sweeps * static_cast<std::int64_t>(balls.size());
  if (!push_apart(placed, shape, domain, gap, most, stop).free)
    throw InputError(Fault{location_of(c, "run.start_from"),
                           "balls of the state overlap so much that they cannot be parted, as the "
                           "event engine needs",
                           "write engine = \"soft\", or take a state of a run with harder contacts",
                           "bad-start-state"});
  for (std::size_t i = 0; i < balls.size(); ++i) balls[i].position = axes * placed[i].position;
}

}  // namespace mahlwerk::cases

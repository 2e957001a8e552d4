// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/build.hpp"

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/setup/fill.hpp"

namespace mahlwerk::cases {

scene::Chamber chamber(const Case& c) {
  return {.shape = c.jar.shape,
          .motion = c.mill.motion,
          .mount = scene::mounted_along(c.mill.jar_axis),
          .gravity = {0, 0, -c.gravity}};
}

std::vector<scene::Ball> starting_balls(const Case& c, int replicate,
                                        const std::atomic<bool>* stop) {
  Random random(c.seed, static_cast<std::uint32_t>(replicate));
  std::vector<scene::Ball> balls = fill(*c.jar.shape, c.balls, random, stop);
  const Rotation mount = scene::mounted_along(c.mill.jar_axis);
  const kinematics::Pose start = kinematics::pose(*c.mill.motion, 0);
  // Ball velocities are relative to the jar's centre, initial speeds to the chosen frame.
  const Vec3 frame = c.run.start_frame == StartFrame::jar ? Vec3{} : start.frame.velocity;
  for (scene::Ball& ball : balls) {
    ball.position = start.rotation * (mount * ball.position);
    const double speed = random.uniform(0, c.run.start_speed);
    ball.velocity = speed * random.direction() - frame;
    const double spin = random.uniform(0, c.run.start_spin);
    ball.spin = spin * random.direction();
  }
  return balls;
}

std::vector<std::int32_t> kinds_of_balls(const Case& c) {
  std::vector<std::int32_t> kinds;
  for (std::size_t i = 0; i < c.balls.size(); ++i)
    kinds.insert(kinds.end(), static_cast<std::size_t>(c.balls[i].count),
                 static_cast<std::int32_t>(i));
  return kinds;
}

}  // namespace mahlwerk::cases

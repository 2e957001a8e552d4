// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/build.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/setup/fill.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/scene/drawn_spheres.hpp"

namespace mahlwerk::cases {

namespace {

std::vector<scene::MachinePart> bodies(const Case& c) {
  std::vector<scene::MachinePart> all;
  for (const MachinePart& part : c.machine_parts) all.push_back(part.body);
  return all;
}

}  // namespace

namespace {

Indirect<kinematics::AnyMotion> motion_in_run(const Case& c) {
  if (const double speed = speed_without_load(c); c.drive && speed != 0)
    return kinematics::driven(*c.mill.motion, *c.drive, speed);
  const kinematics::SpeedProgram program = speed_program(c);
  return program.empty() ? c.mill.motion : kinematics::programmed(*c.mill.motion, program);
}

}  // namespace

scene::Chamber chamber(const Case& c) {
  return {.shape = c.jar.shape,
          .motion = motion_in_run(c),
          .mount = scene::mounted_along(c.mill.jar_axis),
          .gravity = c.gravity_vector(),
          .parts = bodies(c)};
}

scene::Flow flow_in_jar_frame(const Case& c) {
  const Rotation axes =
      kinematics::rotation(*c.mill.motion, 0) * scene::mounted_along(c.mill.jar_axis);
  const Flow& f = *c.flow;
  return {.outlet = axes * f.outlet,
          .outlet_normal = axes * f.outlet_normal,
          .feed = f.feed,
          .axes = axes,
          .inlet = axes * f.inlet,
          .inlet_size = f.inlet_size,
          .rate = f.feed_rate,
          .mass_rate = f.feed_mass_rate.value_or(0),
          .returns = f.feed == Flow::Feed::recirculate || f.fresh_feed.empty() || f.recirculate,
          .seed = c.seed};
}

std::vector<scene::Ball> balls_by_set(const std::vector<BallSet>& sets) {
  std::vector<scene::Ball> balls;
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (const SizeClass& size : sets[i].sizes())
      balls.insert(balls.end(), static_cast<std::size_t>(size.count),
                   {.radius = 0.5 * size.diameter,
                    .density = sets[i].layers().mean_density(0.5 * size.diameter),
                    .position = {},
                    .velocity = {},
                    .spin = {},
                    .kind = static_cast<std::int32_t>(i),
                    .inertia_ratio = sets[i].inertia_ratio(size.diameter)});
  return balls;
}

namespace {

/// The balls in the state of another run; the mill starts in its own initial position.
std::vector<scene::Ball> balls_of_state(const Case& c, const std::vector<BallState>& state) {
  std::vector<scene::Ball> balls = balls_by_set(c.balls);
  const Rotation carrier = kinematics::carrier(*c.mill.motion, 0).rotation;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls[i].position = carrier * state[i].position;
    balls[i].velocity = carrier * state[i].velocity;
    balls[i].spin = carrier * state[i].spin;
    balls[i].orientation = quaternion_of(carrier) * state[i].orientation;
  }
  return balls;
}

/// Uniform over all orientations (Shoemake 1992).
Quaternion random_orientation(Random& random) {
  const double share = random.uniform();
  const SinCos a = sin_cos(2 * std::numbers::pi * random.uniform());
  const SinCos b = sin_cos(2 * std::numbers::pi * random.uniform());
  const double one = std::sqrt(1 - share), other = std::sqrt(share);
  return {other * b.cos, one * a.sin, one * a.cos, other * b.sin};
}

/// Gives balls of a set with given velocities or spins these; `of_set` is the ball's number there.
void set_given_motion(scene::Ball& ball, const BallSet& set, std::size_t of_set,
                      const Rotation& axes, const Vec3& frame) {
  if (of_set < set.velocities.size()) ball.velocity = axes * set.velocities[of_set] - frame;
  if (of_set < set.spins.size()) ball.spin = axes * set.spins[of_set];
}

/// The balls that are in the jar at the start, set by set, in the jar's own axes.
std::vector<scene::Ball> placed_balls(const Case& c, Random& random, const std::atomic<bool>* stop,
                                      const Vec3& up) {
  const std::vector<BallSet> sets = sets_at_start(c);
  if (sets.empty()) return {};
  const Obstacles obstacles(c);
  std::vector<scene::Ball> balls =
      fill(*c.jar.shape, sets, random, stop, c.run.start == StartLayout::layers ? &up : nullptr,
           obstacles.empty() ? nullptr : &obstacles);
  std::vector<std::int32_t> numbers;  // of these sets among all
  const std::vector<bool> fresh = fresh_sets(c);
  for (std::size_t i = 0; i < fresh.size(); ++i)
    if (!fresh[i]) numbers.push_back(static_cast<std::int32_t>(i));
  for (scene::Ball& ball : balls) ball.kind = numbers[static_cast<std::size_t>(ball.kind)];
  return balls;
}

/// Adds the balls of the fresh feed, which wait outside, so that all are in the order of their
/// sets.
std::vector<scene::Ball> with_fresh_feed(const Case& c, const std::vector<scene::Ball>& placed) {
  const std::vector<bool> fresh = fresh_sets(c);
  if (std::ranges::find(fresh, true) == fresh.end()) return placed;
  std::vector<scene::Ball> all = balls_by_set(c.balls);
  auto next = placed.begin();
  for (scene::Ball& ball : all)
    if (fresh[static_cast<std::size_t>(ball.kind)])
      ball.outside = true;
    else
      ball = *next++;
  return all;
}

}  // namespace

std::vector<scene::Ball> starting_balls(const Case& c, int replicate,
                                        const std::atomic<bool>* stop) {
  if (c.run.start_from.states)
    return balls_of_state(c, c.run.start_from.states->at(static_cast<std::size_t>(replicate)));
  Random random(c.seed, static_cast<std::uint32_t>(replicate));
  const Rotation mount = scene::mounted_along(c.mill.jar_axis);
  const kinematics::Pose start = kinematics::pose(*chamber(c).motion, 0);
  const Rotation axes = start.rotation * mount;
  const Vec3 gravity = c.gravity_vector();
  const Vec3 up = axes.apply_inverse(c.gravity == 0 ? Vec3{0, 0, 1} : -gravity / c.gravity);
  std::vector<scene::Ball> balls = placed_balls(c, random, stop, up);
  // Ball velocities are relative to the jar's centre, initial speeds to the chosen frame.
  const Vec3 frame = c.run.start_frame == StartFrame::jar ? Vec3{} : start.frame.velocity;
  std::vector<std::size_t> placed(c.balls.size());  // balls of each set so far
  for (scene::Ball& ball : balls) {
    ball.position = start.rotation * (mount * ball.position);
    const double speed = random.uniform(0, c.run.start_speed);
    ball.velocity = speed * random.direction() - frame;
    const double spin = random.uniform(0, c.run.start_spin);
    ball.spin = spin * random.direction();
    const auto set = static_cast<std::size_t>(ball.kind);
    if (!c.balls[set].body.is_sphere()) ball.orientation = random_orientation(random);
    set_given_motion(ball, c.balls[set], placed[set]++, axes, frame);
  }
  return with_fresh_feed(c, balls);
}

std::vector<scene::BodyShape> body_shapes(const Case& c) {
  std::vector<scene::BodyShape> shapes;
  if (has_bodies(c))
    for (const BallSet& set : c.balls) shapes.push_back(set.shape());
  return shapes;
}

std::vector<scene::Ball> drawn_spheres(const Case& c, const std::vector<scene::Ball>& balls) {
  return has_bodies(c) ? scene::drawn_spheres(balls, body_shapes(c)).spheres : balls;
}

std::vector<std::int32_t> kinds_of_balls(const Case& c) {
  std::vector<std::int32_t> kinds;
  for (std::size_t i = 0; i < c.balls.size(); ++i)
    kinds.insert(kinds.end(), static_cast<std::size_t>(c.balls[i].count),
                 static_cast<std::int32_t>(i));
  return kinds;
}

}  // namespace mahlwerk::cases

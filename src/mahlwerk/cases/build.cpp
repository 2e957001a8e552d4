// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/build.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/random.hpp"

namespace mahlwerk::cases {
namespace {

using scene::Ball;

/// Distance of a ball's centre at `p`, in the jar's own axes, from the nearest face it can meet.
template <class S>
double nearest_wall(const S& shape, const Vec3& p, double radius) {
  double least = geometry::never;
  for (int face = 0; face < S::faces; ++face)
    if (shape.meets(face, radius)) least = std::min(least, shape.gap(face, p).distance);
  return least;
}

/// Random places in a jar for balls of one size, uniform over where such a ball is free.
template <class S>
class Places {
 public:
  Places(const S& shape, double radius) : shape_(shape), radius_(radius) {
    const double room = shape.inradius() - radius;
    needed_ = radius + std::min(1e-3 * radius, 0.5 * room);
    for (Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) box_ += extent(axis) * axis;
  }

  Vec3 draw(Random& random) const {
    constexpr int tries = 1000;  // between halvings; the first box is half full at least
    for (double scale = 1;; scale *= 0.5)
      for (int i = 0; i < tries; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        const double z = random.uniform(-1, 1);
        const Vec3 p = scale * Vec3{x * box_.x, y * box_.y, z * box_.z};
        if (free(p)) return p;
      }
  }

 private:
  bool free(const Vec3& p) const { return nearest_wall(shape_, p, radius_) >= needed_; }

  /// How far the free region reaches along an axis: in a convex round jar no point of it lies
  /// farther.
  double extent(const Vec3& axis) const {
    if (!S::axisymmetric) return shape_.reach();
    double in = 0, out = shape_.reach();
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (in + out);
      (free(middle * axis) ? in : out) = middle;
    }
    return out;
  }

  const S& shape_;
  double radius_, needed_;
  Vec3 box_;
};

bool apart(const Vec3& p, double radius, const std::vector<Ball>& others) {
  constexpr double gap = 1.001;  // of the distance at touch
  return std::ranges::none_of(
      others, [&](const Ball& o) { return norm(p - o.position) < gap * (radius + o.radius); });
}

/// Places all balls, positions in the jar's own axes.
template <class S>
void place(std::vector<Ball>& balls, const BallSet& set, const S& shape, Random& random) {
  constexpr int tries = 100'000;
  const double radius = 0.5 * set.diameter;
  const Places<S> places(shape, radius);
  for (std::int64_t n = 0; n < set.count; ++n) {
    Vec3 p = places.draw(random);
    for (int i = 0; i < tries && !apart(p, radius, balls); ++i) p = places.draw(random);
    if (!apart(p, radius, balls))
      throw InputError(Fault{"balls",
                             fmt::format("found no free place for ball {}", balls.size() + 1),
                             "give fewer or smaller balls", "too-many-balls"});
    balls.push_back(
        {.radius = radius, .density = set.density, .position = p, .velocity = {}, .spin = {}});
  }
}

}  // namespace

scene::Chamber chamber(const Case& c) {
  return {.shape = c.jar.shape,
          .motion = c.mill.motion,
          .mount = scene::mounted_along(c.mill.jar_axis),
          .gravity = {0, 0, -c.gravity}};
}

std::vector<Ball> starting_balls(const Case& c, int replicate) {
  Random random(c.seed, static_cast<std::uint32_t>(replicate));
  std::vector<Ball> balls;
  for (const BallSet& set : c.balls)
    std::visit([&](const auto& shape) { place(balls, set, shape, random); }, c.jar.shape);
  const Rotation mount = scene::mounted_along(c.mill.jar_axis);
  std::visit(
      [&](const auto& motion) {
        const Rotation turn = motion.turn(0);
        const Vec3 jar_velocity = motion.ride(0).velocity;
        for (Ball& ball : balls) {
          ball.position = turn * (mount * ball.position);
          const double speed = random.uniform(0, c.run.start_speed);
          ball.velocity = speed * random.direction() - jar_velocity;  // paper A: in the laboratory
          const double spin = random.uniform(0, c.run.start_spin);
          ball.spin = spin * random.direction();
        }
      },
      c.mill.motion);
  return balls;
}

}  // namespace mahlwerk::cases
